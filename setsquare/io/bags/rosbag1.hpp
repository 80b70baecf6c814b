// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/io/bags/chunked_recording.hpp"
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
class Rosbag1 final : public ChunkedRecording {
 public:
  /// Throws FormatError, with `name`, for a bag of an older version.
  Rosbag1(std::unique_ptr<InputBuffer> bag, const std::string& name);

  std::string format() const override { return "ROS 1 bag"; }

 private:
  Step read_record(Message& message) override;
  [[nodiscard]] bool is_record(ByteWindow& bytes) const override;
  void report_end() override;
  void read_connection(const RosbagHead& head);
  void read_chunk(const RosbagHead& head);
  void enter_packed_chunk(const RosbagHead& head, std::optional<Packing> packing);
  void add_connection(const RosbagHead& head, const RosbagConnection& connection);

  std::uint64_t index_position_ = 0;  ///< As the bag's header states it.
  std::uint32_t num_chunks_stated_ = 0;
  std::uint32_t num_chunk_infos_ = 0;
};

}  // namespace setsquare
