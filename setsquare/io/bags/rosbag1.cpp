// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag1.hpp"

#include <fmt/core.h>

#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kBagMagic = "#ROSBAG V";
constexpr std::string_view kOldBagMagic = "#ROSRECORD V";  // before version 1.2
/// Longer messages are not read only to see whether another record follows: they may be jumped
/// over.
constexpr std::size_t kMaxCheckedRosbagBytes = 1 << 16;
/// What a recorder that was killed had written of its last chunk; it closes chunks at 768 kB.
constexpr std::size_t kMaxOpenChunkBytes = 1 << 26;

std::optional<Packing> packing_from_rosbag(std::string_view compression) {
  if (compression == "bz2") return Packing::kBzip2;
  if (compression == "lz4") return Packing::kLz4;
  return std::nullopt;
}

/// Whether the record is whole and another one, or the end, behind it.
bool is_followed_by_rosbag_record(ByteWindow& bytes, const RosbagHead& head) {
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  if (!bytes.ensure(num_bytes)) return false;
  return !bytes.ensure(num_bytes + 1) || read_rosbag_head(bytes, num_bytes).has_value();
}

bool is_rosbag_record(ByteWindow& bytes) {
  const auto head = read_rosbag_head(bytes);
  return head && head->is_known();
}

/// Whether the length of a record is so long that others are lost in it: one begins inside of it,
/// and none behind it.
bool covers_other_rosbag_records(ByteWindow& bytes, const RosbagHead& head) {
  const bool may_be_jumped_over = head.op == RosbagOp::kMessage;
  if (head.op == RosbagOp::kChunk) return false;
  if (may_be_jumped_over && head.num_bytes() > kMaxCheckedRosbagBytes) return false;
  if (is_followed_by_rosbag_record(bytes, head)) return false;
  ByteWindow inside(bytes.available());
  while (inside.skip(1) == 1 && inside.offset() < head.num_bytes()) {
    if (is_rosbag_record(inside)) return true;
  }
  return false;
}

/// Consumes the line "#ROSBAG V2.0" and returns its version.
std::string read_rosbag_version(ByteWindow& bytes) {
  constexpr std::size_t kMaxLineBytes = 64;
  bytes.ensure(kMaxLineBytes);
  const std::string_view line = bytes.available().substr(0, kMaxLineBytes);
  const std::string_view magic = line.starts_with(kBagMagic) ? kBagMagic : kOldBagMagic;
  if (!line.starts_with(magic)) return {};
  const std::size_t end = line.find('\n');
  if (end == std::string_view::npos) return {};
  std::string version(line.substr(magic.size(), end - magic.size()));
  bytes.consume(end + 1);
  return version;
}

}  // namespace

bool is_rosbag1(std::string_view beginning) {
  return beginning.starts_with(kBagMagic) || beginning.starts_with(kOldBagMagic);
}

Rosbag1::Rosbag1(std::unique_ptr<InputBuffer> bag, const std::string& name)
    : ChunkedRecording(std::move(bag), "connection") {
  const std::string version = read_rosbag_version(input().next_record());
  if (version.empty() || version.starts_with("2.")) return;
  throw FormatError(
      name,
      "",
      fmt::format("a ROS 1 bag of version {}, which cannot be read; \"rosbag fix\" of "
                  "ROS 1 writes one of version 2.0",
                  version));
}

Rosbag1::Step Rosbag1::read_record(Message& message) {
  ByteWindow& bytes = input().next_record();
  if (!bytes.ensure(1)) return Step::kEnd;
  const auto head = read_rosbag_head(bytes);
  if (!head) {
    resynchronise("no whole record begins here");
  } else if (covers_other_rosbag_records(bytes, *head)) {
    resynchronise("a record's length is wrong");
  } else if (head->op == RosbagOp::kMessage) {
    if (leaves_chunk(head->num_bytes())) return Step::kOther;
    return read_message({.channel = head->connection,
                         .log_time = head->time,
                         .num_bytes = head->num_bytes(),
                         .num_head_bytes = head->num_head_bytes},
                        message);
  } else if (head->op == RosbagOp::kConnection) {
    read_connection(*head);
  } else if (head->op == RosbagOp::kChunk) {
    read_chunk(*head);
  } else {
    if (head->op == RosbagOp::kBagHeader) {
      index_position_ = head->index_position;
      num_chunks_stated_ = head->num_chunks;
    }
    if (!head->is_known()) {
      problems().add(input().location(),
                     fmt::format("a record of unknown kind {}", static_cast<int>(head->op)));
    }
    const bool is_chunk_info = head->op == RosbagOp::kChunkInfo;
    if (pass(head->num_bytes()) && is_chunk_info) ++num_chunk_infos_;
  }
  return Step::kOther;
}

void Rosbag1::read_connection(const RosbagHead& head) {
  ByteWindow& bytes = input().next_record();
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  if (!bytes.ensure(num_bytes)) {
    resynchronise("the description of a connection is cut short");
    return;
  }
  // More bytes may have moved the window, and the head's text with it.
  const auto held = read_rosbag_head(bytes);
  const auto connection =
      read_rosbag_connection(bytes.available().substr(held->num_head_bytes, held->num_data_bytes));
  if (!connection) {
    resynchronise("the description of a connection is damaged");
    return;
  }
  add_connection(*held, *connection);
  bytes.consume(num_bytes);
}

void Rosbag1::add_connection(const RosbagHead& head, const RosbagConnection& connection) {
  MessageTopic topic;
  topic.name = head.topic.empty() ? connection.topic : head.topic;
  topic.type = connection.type;
  topic.encoding = MessageEncoding::kRos1;
  if (!is_new_channel(head.connection, topic.name)) return;
  topic.definition = connection.definition;
  add_channel_topic(head.connection, std::move(topic));
}

void Rosbag1::read_chunk(const RosbagHead& head) {
  ByteWindow& bytes = input().next_record();
  if (input().is_in_chunk()) {
    resynchronise("a chunk inside a chunk");
    return;
  }
  if (head.compression != "none") {
    enter_packed_chunk(head, packing_from_rosbag(head.compression));
    return;
  }
  // A recorder writes the sizes when it closes the chunk.
  const bool is_open = head.num_data_bytes == 0 && head.num_bytes_unpacked == 0;
  const bool is_sure = head.num_data_bytes == head.num_bytes_unpacked && !is_open;
  if (!is_open && !is_sure) {
    problems().add(input().location(),
                   fmt::format("a chunk has {} bytes, not {} as stated",
                               head.num_data_bytes,
                               head.num_bytes_unpacked));
  }
  bytes.consume(head.num_head_bytes);
  set_end_of_plain_chunk(is_sure ? bytes.offset() + head.num_data_bytes : 0);
}

void Rosbag1::enter_packed_chunk(const RosbagHead& head, std::optional<Packing> packing) {
  ByteWindow& bytes = input().next_record();
  const std::string location = input().location();
  if (!packing || head.num_data_bytes > BlockUnpacker::kMaxBlockBytes) {
    problems().add(location,
                   fmt::format("a chunk of {} bytes packed by \"{}\" cannot be read",
                               head.num_data_bytes,
                               head.compression));
    pass(head.num_bytes());
    return;
  }
  bytes.consume(head.num_head_bytes);
  if (head.num_data_bytes > 0) {
    const std::string damage =
        input().enter_chunk(*packing, head.num_data_bytes, head.num_bytes_unpacked);
    if (!damage.empty()) problems().add(location, "a chunk is " + damage);
  } else if (bytes.ensure(kMagicBytes) && packing_at(bytes.available()) == packing) {
    // The recorder was killed in this chunk: its sizes were never written, but its beginning was.
    // That it is cut short is no damage of its own; report_end() tells of the bag.
    input().enter_chunk(*packing, kMaxOpenChunkBytes, std::nullopt);
  }
}

bool Rosbag1::is_record(ByteWindow& bytes) const { return is_rosbag_record(bytes); }

void Rosbag1::report_end() {
  auto& remarks = problems().remarks;
  if (index_position_ == 0) {
    remarks.emplace_back("the bag was not closed: its recorder was stopped before it could");
  } else if (num_chunk_infos_ < num_chunks_stated_ || input().file().offset() < index_position_) {
    remarks.emplace_back("the bag ends before its index does: it was cut short");
  }
  const std::string damage = input().file().source().damage();
  if (!damage.empty()) remarks.push_back(damage);
}

}  // namespace setsquare
