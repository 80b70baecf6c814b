// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

#include "setsquare/io/bags/chunked_recording.hpp"
#include "setsquare/io/bags/mcap_records.hpp"

namespace setsquare {

/// Whether the first bytes are those of an MCAP file.
[[nodiscard]] bool is_mcap(std::string_view beginning);

/// The messages of an MCAP file (https://mcap.dev/spec), from its beginning to its end; neither the
/// summary nor an index is used.
///
/// The records of an uncompressed chunk are read where they are, as those outside of chunks: what
/// is not wanted is jumped over. lz4 and zstd chunks are unpacked whole, for what a chunk holds is
/// told only behind it. Where a record is damaged, reading goes on at the next place where a record
/// begins beyond doubt. A chunk's checksum is compared where the chunk is unpacked anyway: there it
/// costs a fraction, but would halve the speed of an uncompressed one, and forbid jumping.
class Mcap final : public ChunkedRecording {
 public:
  explicit Mcap(std::unique_ptr<InputBuffer> input)
      : ChunkedRecording(std::move(input), "channel") {}

  std::string format() const override { return "MCAP"; }

 private:
  struct Schema {
    std::string name;
    std::string definition;
  };

  Step read_record(Message& message) override;
  Step read_message_record(const McapHead& head, Message& message);
  void read_description(const McapHead& head);
  void read_chunk(const McapHead& head);
  void pass_unknown();
  Step pass_footer(const McapHead& head);
  bool add_schema(std::string_view body);
  bool add_channel(std::string_view body);
  [[nodiscard]] bool is_record(ByteWindow& bytes) const override;
  [[nodiscard]] bool covers_others(ByteWindow& bytes, const McapHead& head) const;
  [[nodiscard]] bool has_fitting_body(const McapHead& head, std::string_view body) const;
  void report_end() override;

  std::unordered_map<std::uint16_t, Schema> schemas_;
  bool is_begun_ = false;
  bool has_footer_ = false;
};

}  // namespace setsquare
