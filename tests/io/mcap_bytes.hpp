// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes MCAP records byte by byte, for the tests of their reader.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>

#include "tests/io/packing.hpp"
#include "tests/io/raw_bytes.hpp"

namespace setsquare::testing {

inline const std::string kMcapMagicBytes("\x89MCAP0\r\n");

inline std::string mcap_record(int op, const std::string& body) {
  return raw(static_cast<std::uint8_t>(op)) + raw<std::uint64_t>(body.size()) + body;
}

inline std::string mcap_string(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}

inline std::string mcap_header() {
  return mcap_record(0x01, mcap_string("ros2") + mcap_string("a test"));
}

inline std::string mcap_schema(int id,
                               const std::string& name,
                               const std::string& definition,
                               const std::string& encoding = "ros2msg") {
  return mcap_record(0x03,
                     raw(static_cast<std::uint16_t>(id)) + mcap_string(name) +
                         mcap_string(encoding) + mcap_string(definition));
}

inline std::string mcap_channel(int id,
                                int schema_id,
                                const std::string& topic,
                                const std::string& encoding = "cdr") {
  const std::string metadata = mcap_string("qos") + mcap_string("- depth: 10");
  return mcap_record(0x04,
                     raw(static_cast<std::uint16_t>(id)) +
                         raw(static_cast<std::uint16_t>(schema_id)) + mcap_string(topic) +
                         mcap_string(encoding) + mcap_string(metadata));
}

inline std::string mcap_message(int channel_id,
                                std::uint64_t log_time_ns,
                                const std::string& data) {
  return mcap_record(0x05,
                     raw(static_cast<std::uint16_t>(channel_id)) + raw<std::uint32_t>(7) +
                         raw(log_time_ns) + raw(log_time_ns) + data);
}

inline std::uint32_t mcap_crc(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// A chunk around records: compression "", "lz4", "zstd" (or another name, unpacked as "").
inline std::string mcap_chunk(const std::string& records,
                              const std::string& compression = "",
                              std::uint32_t crc_error = 0) {
  std::string packed = records;
  if (compression == "lz4") packed = pack_lz4(records);
  if (compression == "zstd") packed = pack_zstd(records);
  return mcap_record(0x06,
                     raw<std::uint64_t>(1) + raw<std::uint64_t>(2) +
                         raw<std::uint64_t>(records.size()) + raw(mcap_crc(records) ^ crc_error) +
                         mcap_string(compression) + raw<std::uint64_t>(packed.size()) + packed);
}

/// As it follows a chunk: one entry.
inline std::string mcap_message_index(int channel_id) {
  return mcap_record(0x07,
                     raw(static_cast<std::uint16_t>(channel_id)) +
                         mcap_string(raw<std::uint64_t>(1) + raw<std::uint64_t>(0)));
}

inline std::string mcap_data_end() { return mcap_record(0x0F, raw<std::uint32_t>(0)); }

inline std::string mcap_footer() {
  return mcap_record(0x02, raw<std::uint64_t>(0) + raw<std::uint64_t>(0) + raw<std::uint32_t>(0)) +
         kMcapMagicBytes;
}

/// A whole file around records.
inline std::string mcap_file(const std::string& records) {
  return kMcapMagicBytes + mcap_header() + records + mcap_data_end() + mcap_footer();
}

}  // namespace setsquare::testing
