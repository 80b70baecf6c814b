// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// How the chunks of an MCAP file are packed.
enum class ChunkPacking : std::uint8_t { kNone, kLz4, kZstd };

/// Writes an MCAP file (mcap.dev, "MCAP Format Specification"): messages in packed chunks, each
/// with its index, and a summary at the end, so that viewers open it at once and jump to any time.
/// Memory is bounded by one chunk and the index of chunks.
///
///   McapWriter writer([&](std::string_view bytes) { file.write(bytes); });
///   const auto scan = writer.add_channel("/scan", "sensor_msgs/msg/LaserScan", definition);
///   writer.write(scan, stamp, cdr.message());
///   writer.finish();
class McapWriter {
 public:
  using Sink = std::function<void(std::string_view bytes)>;
  using Channel = std::uint16_t;

  static constexpr std::size_t kChunkBytes = 1 << 20;

  /// Writes the file's beginning. What `sink` throws goes through.
  explicit McapWriter(Sink sink, ChunkPacking packing = ChunkPacking::kZstd);

  /// A topic of CDR messages (ROS 2). `type`: "sensor_msgs/msg/LaserScan"; `definition`: that of
  /// the type and of its parts, as ros2msg. `is_latched`: late readers want its last message, too.
  [[nodiscard]] Channel add_channel(const std::string& topic,
                                    const std::string& type,
                                    const std::string& definition,
                                    bool is_latched = false);

  void write(Channel channel, Timestamp stamp, std::string_view cdr);

  /// Writes the last chunk and the summary. Nothing may be written behind it.
  void finish();

 private:
  struct IndexEntry {
    std::uint64_t time_ns;
    std::uint64_t offset;
  };
  struct ChunkEntry {
    std::uint64_t first_ns;
    std::uint64_t last_ns;
    std::uint64_t offset;
    std::uint64_t num_bytes;
    std::map<Channel, std::uint64_t> index_offsets;
    std::uint64_t num_index_bytes;
    std::uint64_t num_packed_bytes;
    std::uint64_t num_unpacked_bytes;
  };

  void put(std::string_view bytes);
  void close_chunk();
  [[nodiscard]] std::string statistics() const;
  void finish_summary();

  Sink sink_;
  ChunkPacking packing_;
  std::uint64_t offset_ = 0;
  std::string chunk_;   ///< Records of the open chunk.
  std::string packed_;  ///< Memory that is used again.
  std::uint64_t first_ns_ = 0;
  std::uint64_t last_ns_ = 0;
  std::map<Channel, std::vector<IndexEntry>> index_;
  std::vector<ChunkEntry> chunks_;
  std::map<std::string, std::uint16_t> schemas_;  ///< By type.
  std::string schema_records_;
  std::string channel_records_;
  std::vector<std::uint64_t> num_messages_;  ///< Per channel.
};

}  // namespace setsquare
