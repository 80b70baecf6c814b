// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag1.hpp"

#include <fmt/format.h>

#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kBagMagic = "#ROSBAG V";
constexpr std::string_view kOldBagMagic = "#ROSRECORD V";  // before version 1.2
/// A recording has a few hundred connections; a file that describes more than this is damaged.
constexpr std::size_t kMaxConnections = 1 << 14;
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

Rosbag1::Rosbag1(std::unique_ptr<InputBuffer> input, const std::string& name)
    : input_(std::move(input)) {
  const std::string version = read_rosbag_version(input_.next_record());
  if (version.empty() || version.starts_with("2.")) return;
  throw FormatError(
      name,
      "",
      fmt::format("a ROS 1 bag of version {}, which cannot be read; \"rosbag fix\" of "
                  "ROS 1 writes one of version 2.0",
                  version));
}

bool Rosbag1::read(Message& message) {
  input_.next_record().consume(std::exchange(num_bytes_of_message_, 0));
  while (!is_ended_) {
    const Step step = read_record(message);
    if (step == Step::kMessage) return true;
    is_ended_ = step == Step::kEnd;
    if (is_ended_) report_end();
  }
  return false;
}

Rosbag1::Step Rosbag1::read_record(Message& message) {
  ByteWindow& bytes = input_.next_record();
  if (!bytes.ensure(1)) return Step::kEnd;
  const auto head = read_rosbag_head(bytes);
  if (!head) {
    resynchronise("no whole record begins here");
  } else if (covers_other_rosbag_records(bytes, *head)) {
    resynchronise("a record's length is wrong");
  } else if (head->op == RosbagOp::kMessage) {
    return read_message(*head, message);
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
      problems().add(input_.location(),
                     fmt::format("a record of unknown kind {}", static_cast<int>(head->op)));
    }
    const bool is_chunk_info = head->op == RosbagOp::kChunkInfo;
    if (pass(*head) && is_chunk_info) ++num_chunk_infos_;
  }
  return Step::kOther;
}

Rosbag1::Step Rosbag1::read_message(const RosbagHead& head, Message& message) {
  ByteWindow& bytes = input_.next_record();
  const bool is_in_plain_chunk = !input_.is_in_chunk() && bytes.offset() < end_of_plain_chunk_;
  if (is_in_plain_chunk && bytes.offset() + head.num_bytes() > end_of_plain_chunk_) {
    resynchronise("a message reaches beyond its chunk");
    return Step::kOther;
  }
  const auto connection = topic_of_connection_.find(head.connection);
  if (connection == topic_of_connection_.end()) {
    problems().add(
        input_.location(),
        fmt::format("a message of connection {}, which is not described", head.connection));
    pass(head);
    return Step::kOther;
  }
  if (!is_wanted(connection->second)) {
    if (pass(head)) count(connection->second);
    return Step::kOther;
  }
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  if (!bytes.ensure(num_bytes)) {
    resynchronise("a message is cut short");
    return Step::kOther;
  }
  count(connection->second);
  message.topic = connection->second;
  message.log_time = head.time;
  message.data = bytes.available().substr(head.num_head_bytes, head.num_data_bytes);
  message.position = input_.position();
  num_bytes_of_message_ = num_bytes;
  return Step::kMessage;
}

void Rosbag1::read_connection(const RosbagHead& head) {
  ByteWindow& bytes = input_.next_record();
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
  const auto known = topic_of_connection_.find(head.connection);
  if (known != topic_of_connection_.end()) {
    if (topics()[known->second].name != topic.name) {
      problems().add(input_.location(),
                     fmt::format("connection {} is described again, as another", head.connection));
    }
    return;
  }
  if (topic_of_connection_.size() >= kMaxConnections) {
    problems().add(input_.location(), "too many connections");
    return;
  }
  topic.definition = connection.definition;
  topic_of_connection_.emplace(head.connection, add_topic(std::move(topic)));
}

void Rosbag1::read_chunk(const RosbagHead& head) {
  ByteWindow& bytes = input_.next_record();
  if (input_.is_in_chunk()) {
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
    problems().add(input_.location(),
                   fmt::format("a chunk has {} bytes, not {} as stated",
                               head.num_data_bytes,
                               head.num_bytes_unpacked));
  }
  bytes.consume(head.num_head_bytes);
  end_of_plain_chunk_ = is_sure ? bytes.offset() + head.num_data_bytes : 0;
}

void Rosbag1::enter_packed_chunk(const RosbagHead& head, std::optional<Packing> packing) {
  ByteWindow& bytes = input_.next_record();
  const std::string location = input_.location();
  if (!packing || head.num_data_bytes > BlockUnpacker::kMaxBlockBytes) {
    problems().add(location,
                   fmt::format("a chunk of {} bytes packed by \"{}\" cannot be read",
                               head.num_data_bytes,
                               head.compression));
    pass(head);
    return;
  }
  bytes.consume(head.num_head_bytes);
  if (head.num_data_bytes > 0) {
    const std::string damage =
        input_.enter_chunk(*packing, head.num_data_bytes, head.num_bytes_unpacked);
    if (!damage.empty()) problems().add(location, "a chunk is " + damage);
  } else if (bytes.ensure(kMagicBytes) && packing_at(bytes.available()) == packing) {
    // The recorder was killed in this chunk: its sizes were never written, but its beginning was.
    // That it is cut short is no damage of its own; report_end() tells of the bag.
    input_.enter_chunk(*packing, kMaxOpenChunkBytes, std::nullopt);
  }
}

/// Jumps over a record; false where it is cut short.
bool Rosbag1::pass(const RosbagHead& head) {
  ByteWindow& bytes = input_.next_record();
  const std::uint64_t offset = bytes.offset();
  if (bytes.skip(head.num_bytes()) == head.num_bytes()) return true;
  problems().add(input_.location(offset), "a record is cut short");
  return false;
}

void Rosbag1::resynchronise(const std::string& reason) {
  problems().add(input_.location(), reason);
  input_.find_record(is_rosbag_record);
}

void Rosbag1::report_end() {
  auto& remarks = problems().remarks;
  if (index_position_ == 0) {
    remarks.emplace_back("the bag was not closed: its recorder was stopped before it could");
  } else if (num_chunk_infos_ < num_chunks_stated_ || input_.file().offset() < index_position_) {
    remarks.emplace_back("the bag ends before its index does: it was cut short");
  }
  const std::string damage = input_.file().source().damage();
  if (!damage.empty()) remarks.push_back(damage);
}

}  // namespace setsquare
