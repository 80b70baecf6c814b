// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/mcap_writer.hpp"

#include <lz4frame.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/mcap_records.hpp"
#include "setsquare/io/bytes/crc32.hpp"
#include "setsquare/io/bytes/zstd_packing.hpp"

namespace setsquare {
namespace {

static_assert(std::endian::native == std::endian::little, "byte order of MCAP");

template <typename Value>
void append_value(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

void append_text(std::string& bytes, std::string_view text) {
  append_value(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

void append_record(std::string& bytes, McapOp op, std::string_view content) {
  append_value(bytes, op);
  append_value(bytes, std::uint64_t{content.size()});
  bytes.append(content);
}

std::string record(McapOp op, std::string_view content) {
  std::string bytes;
  append_record(bytes, op, content);
  return bytes;
}

/// A map of channels to 64-bit numbers, its length in bytes before it.
template <typename Numbers>
void append_per_channel(std::string& bytes, const Numbers& numbers) {
  append_value(bytes, static_cast<std::uint32_t>(numbers.size() * 10));
  for (const auto& [channel, number] : numbers) {
    append_value(bytes, std::uint16_t{channel});
    append_value(bytes, std::uint64_t{number});
  }
}

/// As MCAP names it.
std::string_view name_of(ChunkPacking packing) {
  switch (packing) {
    case ChunkPacking::kNone:
      return "";
    case ChunkPacking::kLz4:
      return "lz4";
    case ChunkPacking::kZstd:
      return "zstd";
  }
  return "";
}

void pack_lz4(std::string_view bytes, std::string& packed) {
  packed.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0U) throw Error(std::string("lz4: ") + LZ4F_getErrorName(size));
  packed.resize(size);
}

void pack(ChunkPacking packing, std::string_view bytes, std::string& packed) {
  switch (packing) {
    case ChunkPacking::kNone:
      packed.assign(bytes);
      return;
    case ChunkPacking::kLz4:
      return pack_lz4(bytes, packed);
    case ChunkPacking::kZstd:
      return pack_zstd(bytes, 1, packed);
  }
}

}  // namespace

McapWriter::McapWriter(Sink sink, ChunkPacking packing)
    : sink_(std::move(sink)), packing_(packing) {
  std::string content;
  append_text(content, "ros2");
  append_text(content, "setsquare");
  put(kMcapMagic);
  put(record(McapOp::kHeader, content));
}

void McapWriter::put(std::string_view bytes) {
  sink_(bytes);
  offset_ += bytes.size();
}

McapWriter::Channel McapWriter::add_channel(const std::string& topic,
                                            const std::string& type,
                                            const std::string& definition,
                                            bool is_latched) {
  const auto [schema, is_new] =
      schemas_.emplace(type, static_cast<std::uint16_t>(schemas_.size() + 1));
  if (is_new) {
    std::string content;
    append_value(content, schema->second);
    append_text(content, type);
    append_text(content, "ros2msg");
    append_text(content, definition);
    append_record(chunk_, McapOp::kSchema, content);
    append_record(schema_records_, McapOp::kSchema, content);
  }
  const auto channel = static_cast<Channel>(num_messages_.size());
  num_messages_.push_back(0);
  std::string metadata;
  if (is_latched) {
    append_text(metadata, "offered_qos_profiles");
    append_text(metadata,
                "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline:\n    "
                "sec: 9223372036\n    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: "
                "854775807\n  liveliness: 1\n  liveliness_lease_duration:\n    sec: 9223372036\n   "
                " nsec: 854775807\n  avoid_ros_namespace_conventions: false");
  }
  std::string content;
  append_value(content, channel);
  append_value(content, schema->second);
  append_text(content, topic);
  append_text(content, "cdr");
  append_text(content, metadata);
  append_record(chunk_, McapOp::kChannel, content);
  append_record(channel_records_, McapOp::kChannel, content);
  return channel;
}

void McapWriter::write(Channel channel, Timestamp stamp, std::string_view cdr) {
  const auto time_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, stamp.ns));
  if (index_.empty()) first_ns_ = last_ns_ = time_ns;
  first_ns_ = std::min(first_ns_, time_ns);
  last_ns_ = std::max(last_ns_, time_ns);
  index_[channel].push_back({time_ns, chunk_.size()});
  append_value(chunk_, McapOp::kMessage);
  append_value(chunk_, std::uint64_t{22 + cdr.size()});
  append_value(chunk_, channel);
  append_value(chunk_, static_cast<std::uint32_t>(num_messages_[channel]++));
  append_value(chunk_, time_ns);
  append_value(chunk_, time_ns);
  chunk_.append(cdr);
  if (chunk_.size() >= kChunkBytes) close_chunk();
}

void McapWriter::close_chunk() {
  if (chunk_.empty()) return;
  pack(packing_, chunk_, packed_);
  std::string content;
  append_value(content, first_ns_);
  append_value(content, last_ns_);
  append_value(content, std::uint64_t{chunk_.size()});
  append_value(content, crc32_of(chunk_));
  append_text(content, name_of(packing_));
  append_value(content, std::uint64_t{packed_.size()});
  content.append(packed_);
  ChunkEntry entry{first_ns_, last_ns_, offset_, 0, {}, 0, packed_.size(), chunk_.size()};
  put(record(McapOp::kChunk, content));
  entry.num_bytes = offset_ - entry.offset;
  const std::uint64_t index_begin = offset_;
  for (const auto& [channel, messages] : index_) {
    entry.index_offsets[channel] = offset_;
    std::string index;
    append_value(index, channel);
    append_value(index, static_cast<std::uint32_t>(messages.size() * 16));
    for (const IndexEntry& message : messages) {
      append_value(index, message.time_ns);
      append_value(index, message.offset);
    }
    put(record(McapOp::kMessageIndex, index));
  }
  entry.num_index_bytes = offset_ - index_begin;
  chunks_.push_back(std::move(entry));
  chunk_.clear();
  index_.clear();
}

std::string McapWriter::statistics() const {
  std::uint64_t first_ns = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t last_ns = 0;
  for (const ChunkEntry& chunk : chunks_) {
    if (chunk.index_offsets.empty()) continue;
    first_ns = std::min(first_ns, chunk.first_ns);
    last_ns = std::max(last_ns, chunk.last_ns);
  }
  std::map<Channel, std::uint64_t> counts;
  std::uint64_t sum = 0;
  for (std::size_t channel = 0; channel < num_messages_.size(); ++channel) {
    counts[static_cast<Channel>(channel)] = num_messages_[channel];
    sum += num_messages_[channel];
  }
  std::string content;
  append_value(content, sum);
  append_value(content, static_cast<std::uint16_t>(schemas_.size()));
  append_value(content, static_cast<std::uint32_t>(num_messages_.size()));
  append_value(content, std::uint32_t{0});  // attachments
  append_value(content, std::uint32_t{0});  // metadata
  append_value(content, static_cast<std::uint32_t>(chunks_.size()));
  append_value(content, sum == 0 ? 0 : first_ns);
  append_value(content, last_ns);
  append_per_channel(content, counts);
  return record(McapOp::kStatistics, content);
}

void McapWriter::finish() {
  close_chunk();
  std::string end;
  append_value(end, std::uint32_t{0});  // no checksum of the data section
  put(record(McapOp::kDataEnd, end));
  finish_summary();
}

void McapWriter::finish_summary() {
  std::string chunk_indexes;
  for (const ChunkEntry& chunk : chunks_) {
    std::string content;
    append_value(content, chunk.first_ns);
    append_value(content, chunk.last_ns);
    append_value(content, chunk.offset);
    append_value(content, chunk.num_bytes);
    append_per_channel(content, chunk.index_offsets);
    append_value(content, chunk.num_index_bytes);
    append_text(content, "zstd");
    append_value(content, chunk.num_packed_bytes);
    append_value(content, chunk.num_unpacked_bytes);
    append_record(chunk_indexes, McapOp::kChunkIndex, content);
  }
  const std::pair<McapOp, std::string> groups[] = {{McapOp::kSchema, schema_records_},
                                                   {McapOp::kChannel, channel_records_},
                                                   {McapOp::kStatistics, statistics()},
                                                   {McapOp::kChunkIndex, chunk_indexes}};
  const std::uint64_t summary_begin = offset_;
  std::string offsets;
  for (const auto& [op, records] : groups) {
    if (records.empty()) continue;
    std::string content;
    append_value(content, op);
    append_value(content, offset_);
    append_value(content, std::uint64_t{records.size()});
    append_record(offsets, McapOp::kSummaryOffset, content);
    put(records);
  }
  std::string footer;
  append_value(footer, summary_begin);
  append_value(footer, offset_);
  append_value(footer, std::uint32_t{0});  // no checksum of the summary
  put(offsets);
  put(record(McapOp::kFooter, footer));
  put(kMcapMagic);
}

}  // namespace setsquare
