// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "setsquare/io/bags/chunked_input.hpp"
#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/bags/rosbag1_records.hpp"

namespace setsquare {

/// Whether the first bytes are those of a ROS 1 bag, whatever its version.
[[nodiscard]] bool is_rosbag1(std::string_view beginning);

/// The messages of a ROS 1 bag of version 2.0 (http://wiki.ros.org/Bags/Format/2.0), from its
/// beginning to its end. No index is used, so a bag that was not closed reads like any other.
///
/// The records of an uncompressed chunk are read where they are: what is not wanted is jumped over.
/// bz2 and lz4 chunks are all unpacked: which messages a chunk holds is told by the index behind it
/// alone, which may be missing or wrong. Where a record is damaged, reading goes on at the next
/// place where a record begins.
class Rosbag1 final : public MessageSource {
 public:
  /// Throws FormatError, with `name`, for a bag of an older version.
  Rosbag1(std::unique_ptr<InputBuffer> input, const std::string& name);

  bool read(Message& message) override;
  std::string format() const override { return "ROS 1 bag"; }
  std::optional<double> fraction_read() const override {
    return input_.file().source().fraction_read();
  }

 private:
  enum class Step { kMessage, kOther, kEnd };

  Step read_record(Message& message);
  Step read_message(const RosbagHead& head, Message& message);
  void read_connection(const RosbagHead& head);
  void read_chunk(const RosbagHead& head);
  void enter_packed_chunk(const RosbagHead& head, std::optional<Packing> packing);
  bool pass(const RosbagHead& head);
  void add_connection(const RosbagHead& head, const RosbagConnection& connection);
  void resynchronise(const std::string& reason);
  void report_end();

  ChunkedInput input_;
  std::unordered_map<std::uint32_t, std::size_t> topic_of_connection_;
  std::size_t num_bytes_of_message_ = 0;  ///< What the last read() handed on.
  std::uint64_t end_of_plain_chunk_ = 0;  ///< Offset in the file; 0 where it is not known.
  std::uint64_t index_position_ = 0;      ///< As the bag's header states it.
  std::uint32_t num_chunks_stated_ = 0;
  std::uint32_t num_chunk_infos_ = 0;
  bool is_ended_ = false;
};

}  // namespace setsquare
