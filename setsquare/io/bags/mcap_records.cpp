// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/mcap_records.hpp"

#include <array>

#include "setsquare/io/bytes/byte_cursor.hpp"

namespace setsquare {
namespace {

struct McapBodyBytes {
  std::uint64_t least;
  std::uint64_t most;
};

constexpr std::uint64_t kMcapMib = 1 << 20;
/// Descriptions, indices, statistics.
constexpr std::uint64_t kMostSmallBytes = 16 * kMcapMib;
/// A message is held in memory; an image has a few MiB, a point cloud tens.
constexpr std::uint64_t kMostMessageBytes = 256 * kMcapMib;
/// What is jumped over, or read record by record, may be longer: a video, a chunk of a whole drive.
constexpr std::uint64_t kMostPassedBytes = 1024 * 1024 * kMcapMib;

/// The lengths that bodies can have, by op code from 1: the fixed fields at least, since later
/// versions may append fields.
constexpr std::array<McapBodyBytes, 15> kBodyBytes = {{
    {8, kMostSmallBytes},     // Header
    {20, kMostSmallBytes},    // Footer
    {14, kMostSmallBytes},    // Schema
    {16, kMostSmallBytes},    // Channel
    {22, kMostMessageBytes},  // Message
    {40, kMostPassedBytes},   // Chunk
    {6, kMostSmallBytes},     // MessageIndex
    {64, kMostSmallBytes},    // ChunkIndex
    {36, kMostPassedBytes},   // Attachment
    {48, kMostSmallBytes},    // AttachmentIndex
    {46, kMostSmallBytes},    // Statistics
    {8, kMostSmallBytes},     // Metadata
    {20, kMostSmallBytes},    // MetadataIndex
    {17, kMostSmallBytes},    // SummaryOffset
    {4, kMostSmallBytes},     // DataEnd
}};

std::string_view read_mcap_string(ByteCursor& bytes) {
  return bytes.take(bytes.read<std::uint32_t>());
}

}  // namespace

std::optional<McapHead> read_unknown_mcap_head(std::string_view bytes) {
  ByteCursor cursor(bytes);
  const McapHead head{McapOp{cursor.read<std::uint8_t>()}, cursor.read<std::uint64_t>()};
  if (cursor.is_short() || head.op == McapOp{0} || head.num_body_bytes > kMostPassedBytes) {
    return std::nullopt;
  }
  return head;
}

std::optional<McapHead> read_mcap_head(std::string_view bytes) {
  const auto head = read_unknown_mcap_head(bytes);
  if (!head || head->op >= McapOp::kFirstPrivate) return head;
  const std::size_t index = static_cast<std::size_t>(head->op) - 1;
  if (index >= kBodyBytes.size()) return std::nullopt;
  const McapBodyBytes& bounds = kBodyBytes[index];
  const bool is_possible =
      head->num_body_bytes >= bounds.least && head->num_body_bytes <= bounds.most;
  return is_possible ? head : std::nullopt;
}

std::optional<McapSchema> read_mcap_schema(std::string_view body) {
  ByteCursor cursor(body);
  McapSchema schema;
  schema.id = cursor.read<std::uint16_t>();
  schema.name = read_mcap_string(cursor);
  schema.encoding = read_mcap_string(cursor);
  schema.definition = read_mcap_string(cursor);
  if (cursor.is_short() || schema.id == 0) return std::nullopt;
  return schema;
}

std::optional<McapChannel> read_mcap_channel(std::string_view body) {
  ByteCursor cursor(body);
  McapChannel channel;
  channel.id = cursor.read<std::uint16_t>();
  channel.schema_id = cursor.read<std::uint16_t>();
  channel.topic = read_mcap_string(cursor);
  channel.message_encoding = read_mcap_string(cursor);
  read_mcap_string(cursor);  // metadata: the quality of service, for one
  if (cursor.is_short()) return std::nullopt;
  return channel;
}

std::optional<McapMessageHead> read_mcap_message_head(std::string_view body) {
  ByteCursor cursor(body);
  McapMessageHead head;
  head.channel_id = cursor.read<std::uint16_t>();
  cursor.skip(sizeof(std::uint32_t));  // the sequence number
  head.log_time_ns = cursor.read<std::uint64_t>();
  cursor.skip(sizeof(std::uint64_t));  // when it was published
  if (cursor.is_short()) return std::nullopt;
  return head;
}

std::optional<McapChunkHead> read_mcap_chunk_head(std::string_view beginning,
                                                  std::uint64_t num_body_bytes) {
  ByteCursor cursor(beginning);
  McapChunkHead head;
  cursor.skip(2 * sizeof(std::uint64_t));  // times of the first and the last message
  head.num_bytes_unpacked = cursor.read<std::uint64_t>();
  head.crc = cursor.read<std::uint32_t>();
  head.compression = read_mcap_string(cursor);
  head.num_bytes_packed = cursor.read<std::uint64_t>();
  head.num_bytes = cursor.position();
  const bool fits = !cursor.is_short() && head.num_bytes <= num_body_bytes &&
                    head.num_bytes_packed <= num_body_bytes - head.num_bytes;
  return fits ? std::optional(head) : std::nullopt;
}

}  // namespace setsquare
