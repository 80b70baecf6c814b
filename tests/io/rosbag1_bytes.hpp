// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes records of ROS 1 bags byte by byte, for the tests of their reader.
#pragma once

#include <cstdint>
#include <string>

#include "tests/io/packing.hpp"
#include "tests/io/raw_bytes.hpp"

namespace setsquare::testing {

inline const std::string kRosbagMagicBytes = "#ROSBAG V2.0\n";

inline std::string rosbag_field(const std::string& name, const std::string& value) {
  const std::string text = name + "=" + value;
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}

inline std::string rosbag_record(int op, const std::string& fields, const std::string& data) {
  const std::string header = fields + rosbag_field("op", raw(static_cast<std::uint8_t>(op)));
  return raw(static_cast<std::uint32_t>(header.size())) + header +
         raw(static_cast<std::uint32_t>(data.size())) + data;
}

/// `index_position` 0: a bag that was not closed.
inline std::string rosbag_header(std::uint64_t index_position, std::uint32_t num_chunks) {
  const std::string fields = rosbag_field("chunk_count", raw(num_chunks)) +
                             rosbag_field("conn_count", raw<std::uint32_t>(2)) +
                             rosbag_field("index_pos", raw(index_position));
  return rosbag_record(0x03, fields, std::string(100, ' '));
}

inline std::string rosbag_connection(std::uint32_t id,
                                     const std::string& topic,
                                     const std::string& type,
                                     const std::string& definition,
                                     const std::string& own_topic = "/as_published") {
  const std::string data = rosbag_field("callerid", "/recorder") + rosbag_field("md5sum", "0123") +
                           rosbag_field("message_definition", definition) +
                           rosbag_field("topic", own_topic) + rosbag_field("type", type);
  return rosbag_record(0x07, rosbag_field("conn", raw(id)) + rosbag_field("topic", topic), data);
}

inline std::string rosbag_message(std::uint32_t connection,
                                  std::uint32_t seconds,
                                  std::uint32_t ns,
                                  const std::string& data) {
  return rosbag_record(
      0x02,
      rosbag_field("conn", raw(connection)) + rosbag_field("time", raw(seconds) + raw(ns)),
      data);
}

inline std::string rosbag_chunk_head_fields(const std::string& compression, std::uint32_t size) {
  return rosbag_field("compression", compression) + rosbag_field("size", raw(size));
}

/// A chunk around records: compression "none", "bz2", "lz4" (or another name, not packed).
inline std::string rosbag_chunk(const std::string& records, const std::string& compression) {
  std::string packed = records;
  if (compression == "bz2") packed = pack_bzip2(records);
  if (compression == "lz4") packed = pack_lz4(records);
  const auto size = static_cast<std::uint32_t>(records.size());
  return rosbag_record(0x05, rosbag_chunk_head_fields(compression, size), packed);
}

/// As it follows a chunk: one entry.
inline std::string rosbag_index(std::uint32_t connection) {
  return rosbag_record(0x04,
                       rosbag_field("conn", raw(connection)) +
                           rosbag_field("count", raw<std::uint32_t>(1)) +
                           rosbag_field("ver", raw<std::uint32_t>(1)),
                       std::string(12, '\0'));
}

inline std::string rosbag_chunk_info() {
  return rosbag_record(
      0x06,
      rosbag_field("chunk_pos", raw<std::uint64_t>(0)) + rosbag_field("ver", raw<std::uint32_t>(1)),
      std::string(8, '\0'));
}

/// A closed bag around chunks and their indices.
inline std::string rosbag_file(const std::string& chunks, std::uint32_t num_chunks) {
  const std::size_t num_before = (kRosbagMagicBytes + rosbag_header(1, num_chunks)).size();
  std::string bag =
      kRosbagMagicBytes + rosbag_header(num_before + chunks.size(), num_chunks) + chunks;
  for (std::uint32_t i = 0; i < num_chunks; ++i) bag += rosbag_chunk_info();
  return bag;
}

}  // namespace setsquare::testing
