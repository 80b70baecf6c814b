// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag1_records.hpp"

#include "setsquare/io/bytes/byte_cursor.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kRosbagLengthBytes = sizeof(std::uint32_t);
/// "op=" and its value, behind a length: no header is shorter.
constexpr std::size_t kLeastHeaderBytes = kRosbagLengthBytes + 4;
/// Topics are the only text in headers.
constexpr std::size_t kMostHeaderBytes = 1 << 16;
/// "message_definition" is the longest that ROS writes. Bounds the search for the equals sign, so
/// that bytes which are no record are passed in linear time.
constexpr std::size_t kMostNameBytes = 32;
constexpr int kMostFields = 64;
/// Descriptions and indices.
constexpr std::uint32_t kMostSmallDataBytes = 1 << 24;
/// A message is held in memory; an image has a few MiB, a point cloud tens.
constexpr std::uint32_t kMostMessageDataBytes = 1 << 28;

struct RosbagField {
  std::string_view name;
  std::string_view value;
};

std::optional<RosbagField> read_rosbag_field(ByteCursor& cursor) {
  const std::string_view text = cursor.take(cursor.read<std::uint32_t>());
  const std::size_t equals = text.substr(0, kMostNameBytes + 1).find('=');
  if (equals == std::string_view::npos || equals == 0) return std::nullopt;
  return RosbagField{text.substr(0, equals), text.substr(equals + 1)};
}

/// Hands every field of `fields` to `take`; false where they do not fill it exactly.
template <typename Take>
bool read_rosbag_fields(std::string_view fields, Take take) {
  ByteCursor cursor(fields);
  for (int i = 0; cursor.position() < fields.size(); ++i) {
    const auto field = read_rosbag_field(cursor);
    if (!field || i == kMostFields) return false;
    take(*field);
  }
  return true;
}

/// A value of fixed size; nothing where the field has another.
template <typename Value>
std::optional<Value> rosbag_value(std::string_view bytes) {
  if (bytes.size() != sizeof(Value)) return std::nullopt;
  return ByteCursor(bytes).read<Value>();
}

/// Which of a header's fields were there, with values of the right size.
struct RosbagFieldsMet {
  bool op = false;
  bool connection = false;
  bool time = false;
  bool topic = false;
  bool compression = false;
  bool size = false;
};

template <typename Value>
void assign_value(Value& value, bool& is_met, std::string_view bytes) {
  const auto read = rosbag_value<Value>(bytes);
  is_met = read.has_value();
  value = read.value_or(Value{});
}

/// Seconds and nanoseconds, four bytes each.
void assign_time(Timestamp& time, bool& is_met, std::string_view bytes) {
  ByteCursor cursor(bytes);
  const std::int64_t seconds = cursor.read<std::uint32_t>();
  const std::int64_t ns = cursor.read<std::uint32_t>();
  is_met = bytes.size() == 2 * sizeof(std::uint32_t);
  time.ns = seconds * 1'000'000'000 + ns;
}

void take_rosbag_field(const RosbagField& field, RosbagHead& head, RosbagFieldsMet& met) {
  bool is_met = false;
  if (field.name == "op") {
    assign_value(head.op, met.op, field.value);
  } else if (field.name == "conn") {
    assign_value(head.connection, met.connection, field.value);
  } else if (field.name == "time") {
    assign_time(head.time, met.time, field.value);
  } else if (field.name == "topic") {
    head.topic = field.value;
    met.topic = true;
  } else if (field.name == "compression") {
    head.compression = field.value;
    met.compression = true;
  } else if (field.name == "size") {
    assign_value(head.num_bytes_unpacked, met.size, field.value);
  } else if (field.name == "count") {
    assign_value(head.num_entries, is_met, field.value);
  } else if (field.name == "index_pos") {
    assign_value(head.index_position, is_met, field.value);
  } else if (field.name == "chunk_count") {
    assign_value(head.num_chunks, is_met, field.value);
  }
}

bool has_needed_rosbag_fields(RosbagOp op, const RosbagFieldsMet& met) {
  if (op == RosbagOp::kMessage) return met.connection && met.time;
  if (op == RosbagOp::kConnection) return met.connection && met.topic;
  if (op == RosbagOp::kChunk) return met.compression && met.size;
  return met.op;
}

/// The recorder of 2010 states 20 bytes for every entry of an index, and writes 12.
void mend_index_length(RosbagHead& head) {
  constexpr std::uint64_t kStatedBytes = 20;
  constexpr std::uint32_t kWrittenBytes = 12;
  const bool is_overstated =
      head.op == RosbagOp::kIndex && head.num_data_bytes == kStatedBytes * head.num_entries;
  if (is_overstated) head.num_data_bytes = kWrittenBytes * head.num_entries;
}

bool has_possible_rosbag_length(const RosbagHead& head) {
  if (head.op == RosbagOp::kMessage) return head.num_data_bytes <= kMostMessageDataBytes;
  return head.op == RosbagOp::kChunk || head.num_data_bytes <= kMostSmallDataBytes;
}

}  // namespace

std::optional<RosbagHead> read_rosbag_head(ByteWindow& bytes, std::size_t offset) {
  if (!bytes.ensure(offset + 2 * kRosbagLengthBytes)) return std::nullopt;
  ByteCursor lengths(bytes.available().substr(offset));
  const auto num_header_bytes = lengths.read<std::uint32_t>();
  const auto num_first_field_bytes = lengths.read<std::uint32_t>();
  if (num_header_bytes < kLeastHeaderBytes || num_header_bytes > kMostHeaderBytes ||
      num_first_field_bytes > num_header_bytes - kRosbagLengthBytes) {
    return std::nullopt;
  }
  if (!bytes.ensure(offset + num_header_bytes + 2 * kRosbagLengthBytes)) return std::nullopt;
  ByteCursor cursor(bytes.available().substr(offset + kRosbagLengthBytes));
  const std::string_view fields = cursor.take(num_header_bytes);
  RosbagHead head;
  RosbagFieldsMet met;
  const bool is_read = read_rosbag_fields(
      fields, [&](const RosbagField& field) { take_rosbag_field(field, head, met); });
  head.num_head_bytes = num_header_bytes + 2 * kRosbagLengthBytes;
  head.num_data_bytes = cursor.read<std::uint32_t>();
  mend_index_length(head);
  const bool is_possible = is_read && met.op && has_needed_rosbag_fields(head.op, met) &&
                           has_possible_rosbag_length(head);
  return is_possible ? std::optional(head) : std::nullopt;
}

std::optional<RosbagConnection> read_rosbag_connection(std::string_view data) {
  RosbagConnection connection;
  const bool is_read = read_rosbag_fields(data, [&connection](const RosbagField& field) {
    if (field.name == "topic") connection.topic = field.value;
    if (field.name == "type") connection.type = field.value;
    if (field.name == "message_definition") connection.definition = field.value;
  });
  if (!is_read || connection.type.empty()) return std::nullopt;
  return connection;
}

}  // namespace setsquare
