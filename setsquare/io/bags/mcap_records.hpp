// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The records of the MCAP format, version 0 (https://mcap.dev/spec), as far as messages need them.
// A record is an op code of one byte, the length of its body in eight, and the body; strings and
// lists inside a body have lengths of four bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace setsquare {

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

enum class McapOp : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
  kFirstPrivate = 0x80,  ///< This and all above are left to applications.
};

/// What every record begins with.
struct McapHead {
  static constexpr std::size_t kBytes = 9;

  McapOp op{};
  std::uint64_t num_body_bytes = 0;

  [[nodiscard]] std::uint64_t num_bytes() const { return kBytes + num_body_bytes; }
};

struct McapSchema {
  std::uint16_t id = 0;
  std::string_view name;
  std::string_view encoding;
  std::string_view definition;
};

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none.
  std::string_view topic;
  std::string_view message_encoding;
};

/// The fields of a message in front of its data.
struct McapMessageHead {
  static constexpr std::size_t kBytes = 22;

  std::uint16_t channel_id = 0;
  std::uint64_t log_time_ns = 0;
};

/// The fields of a chunk in front of its records.
struct McapChunkHead {
  static constexpr std::size_t kMaxBytes = 40 + 32;  ///< With a name of the compression of 32.

  std::uint64_t num_bytes_unpacked = 0;
  std::uint32_t crc = 0;  ///< Of the unpacked records; 0: not stated.
  std::string_view compression;
  std::uint64_t num_bytes_packed = 0;
  std::size_t num_bytes = 0;  ///< Of these fields.
};

/// The head that `bytes` begin with; nothing where no record can begin like this: an op code that
/// the format does not know, or a length that a record of this kind does not have.
[[nodiscard]] std::optional<McapHead> read_mcap_head(std::string_view bytes);

/// The same for an op code that a later version of the format may define.
[[nodiscard]] std::optional<McapHead> read_unknown_mcap_head(std::string_view bytes);

/// The fields of a body; nothing where their lengths do not fit into it.
[[nodiscard]] std::optional<McapSchema> read_mcap_schema(std::string_view body);
[[nodiscard]] std::optional<McapChannel> read_mcap_channel(std::string_view body);
[[nodiscard]] std::optional<McapMessageHead> read_mcap_message_head(std::string_view body);

/// `beginning` are the first bytes of the body, kMaxBytes of them where there are as many.
[[nodiscard]] std::optional<McapChunkHead> read_mcap_chunk_head(std::string_view beginning,
                                                                std::uint64_t num_body_bytes);

}  // namespace setsquare
