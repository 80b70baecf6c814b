// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/mcap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "setsquare/io/bytes/crc32.hpp"

namespace setsquare {
namespace {

/// A recording has a few hundred types; a file that describes more than this is damaged.
constexpr std::size_t kMaxSchemas = 1 << 14;
/// How far behind a place where a record may begin we look whether another one follows it.
constexpr std::size_t kMaxLookAheadBytes = 1 << 24;
/// Longer messages are not read only to see whether another record follows: they may be jumped
/// over.
constexpr std::size_t kMaxCheckedMcapBytes = 1 << 16;

MessageEncoding encoding_from_mcap(std::string_view name) {
  if (name == "cdr") return MessageEncoding::kCdr;
  if (name == "ros1") return MessageEncoding::kRos1;
  return MessageEncoding::kOther;
}

bool is_ros_schema(std::string_view encoding) {
  return encoding == "ros1msg" || encoding == "ros2msg" || encoding == "ros2idl";
}

std::optional<Packing> packing_from_mcap(std::string_view compression) {
  if (compression == "lz4") return Packing::kLz4;
  if (compression == "zstd") return Packing::kZstd;
  return std::nullopt;
}

Timestamp stamp_from_mcap(std::uint64_t ns) {
  constexpr std::uint64_t kLatest = std::numeric_limits<std::int64_t>::max();
  return {static_cast<std::int64_t>(std::min(ns, kLatest))};
}

/// Whether the record is whole and another one, or the end, behind it.
bool is_followed_by_mcap_record(ByteWindow& bytes, const McapHead& head) {
  if (head.num_bytes() > kMaxLookAheadBytes) return false;
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  if (!bytes.ensure(num_bytes)) return false;
  const bool is_last = !bytes.ensure(num_bytes + McapHead::kBytes);
  return is_last || read_mcap_head(bytes.available().substr(num_bytes)).has_value();
}

}  // namespace

bool is_mcap(std::string_view beginning) { return beginning.starts_with("\x89MCAP0"); }

Mcap::Step Mcap::read_record(Message& message) {
  ByteWindow& bytes = input().next_record();
  if (!is_begun_) {
    is_begun_ = true;
    if (bytes.ensure(kMcapMagic.size()) && bytes.available().starts_with(kMcapMagic)) {
      bytes.consume(kMcapMagic.size());
    }
  }
  if (!bytes.ensure(1)) return Step::kEnd;
  const bool has_head = bytes.ensure(McapHead::kBytes);
  const auto head = read_mcap_head(bytes.available());
  if (!has_head) {
    resynchronise("a record is cut short");
  } else if (!head) {
    pass_unknown();
  } else if (covers_others(bytes, *head)) {
    resynchronise("a record's length is wrong");
  } else if (head->op == McapOp::kMessage) {
    return read_message_record(*head, message);
  } else if (head->op == McapOp::kSchema || head->op == McapOp::kChannel) {
    read_description(*head);
  } else if (head->op == McapOp::kChunk) {
    read_chunk(*head);
  } else if (head->op == McapOp::kFooter) {
    return pass_footer(*head);
  } else {
    pass(head->num_bytes());
  }
  return Step::kOther;
}

Mcap::Step Mcap::read_message_record(const McapHead& head, Message& message) {
  constexpr std::size_t kHeadBytes = McapHead::kBytes + McapMessageHead::kBytes;
  if (leaves_chunk(head.num_bytes())) return Step::kOther;
  ByteWindow& bytes = input().next_record();
  bytes.ensure(kHeadBytes);
  const auto message_head = read_mcap_message_head(bytes.available().substr(McapHead::kBytes));
  if (!message_head) {
    resynchronise("a message is cut short");
    return Step::kOther;
  }
  return read_message({.channel = message_head->channel_id,
                       .log_time = stamp_from_mcap(message_head->log_time_ns),
                       .num_bytes = head.num_bytes(),
                       .num_head_bytes = kHeadBytes},
                      message);
}

void Mcap::read_description(const McapHead& head) {
  ByteWindow& bytes = input().next_record();
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  if (!bytes.ensure(num_bytes)) {
    resynchronise("the description of a channel is cut short");
    return;
  }
  const std::string_view body =
      bytes.available().substr(McapHead::kBytes, num_bytes - McapHead::kBytes);
  const bool is_read = head.op == McapOp::kSchema ? add_schema(body) : add_channel(body);
  if (is_read) {
    bytes.consume(num_bytes);
  } else {
    resynchronise("the description of a channel is damaged");
  }
}

/// False where the record is damaged.
bool Mcap::add_schema(std::string_view body) {
  const auto schema = read_mcap_schema(body);
  if (!schema) return false;
  if (schemas_.size() >= kMaxSchemas) return true;
  const auto [place, is_new] = schemas_.try_emplace(schema->id);
  if (!is_new) return true;
  place->second.name = schema->name;
  if (is_ros_schema(schema->encoding)) place->second.definition = schema->definition;
  return true;
}

/// False where the record is damaged.
bool Mcap::add_channel(std::string_view body) {
  const auto channel = read_mcap_channel(body);
  if (!channel) return false;
  if (!is_new_channel(channel->id, channel->topic)) return true;
  MessageTopic topic;
  topic.name = channel->topic;
  topic.encoding = encoding_from_mcap(channel->message_encoding);
  const auto schema = schemas_.find(channel->schema_id);
  if (schema != schemas_.end()) {
    topic.type = schema->second.name;
    topic.definition = schema->second.definition;
  } else if (channel->schema_id != 0) {
    problems().add(
        input().location(),
        fmt::format(
            "channel {} has schema {}, which is not described", channel->id, channel->schema_id));
  }
  add_channel_topic(channel->id, std::move(topic));
  return true;
}

void Mcap::read_chunk(const McapHead& head) {
  ByteWindow& bytes = input().next_record();
  bytes.ensure(McapHead::kBytes + McapChunkHead::kMaxBytes);
  const auto chunk =
      read_mcap_chunk_head(bytes.available().substr(McapHead::kBytes), head.num_body_bytes);
  if (!chunk || input().is_in_chunk()) {
    resynchronise(chunk ? "a chunk inside a chunk" : "a chunk's lengths are damaged");
    return;
  }
  const std::string location = input().location();
  const bool is_plain = chunk->compression.empty();
  const auto packing = packing_from_mcap(chunk->compression);
  const bool can_be_held = chunk->num_bytes_packed <= BlockUnpacker::kMaxBlockBytes;
  if (!is_plain && (!packing || !can_be_held)) {
    problems().add(location,
                   fmt::format("a chunk of {} bytes packed by \"{}\" cannot be read",
                               chunk->num_bytes_packed,
                               chunk->compression));
    pass(head.num_bytes());
    return;
  }
  bytes.consume(McapHead::kBytes + chunk->num_bytes);
  if (is_plain) {
    set_end_of_plain_chunk(bytes.offset() + chunk->num_bytes_packed);
    return;
  }
  const std::string damage =
      input().enter_chunk(*packing, chunk->num_bytes_packed, chunk->num_bytes_unpacked);
  if (!damage.empty()) {
    problems().add(location, "a chunk is " + damage);
  } else if (chunk->crc != 0 && chunk->crc != crc32_of(input().chunk_bytes())) {
    problems().add(location, "a chunk's checksum is wrong; its messages are read all the same");
  }
}

/// A record of a kind that a later version may define is passed where another one follows it.
void Mcap::pass_unknown() {
  ByteWindow& bytes = input().next_record();
  const auto head = read_unknown_mcap_head(bytes.available());
  if (!head || !is_followed_by_mcap_record(bytes, *head)) {
    resynchronise("no whole record begins here");
    return;
  }
  problems().add(input().location(),
                 fmt::format("a record of unknown kind {}", static_cast<int>(head->op)));
  pass(head->num_bytes());
}

/// The end, where the magic follows.
Mcap::Step Mcap::pass_footer(const McapHead& head) {
  ByteWindow& bytes = input().next_record();
  const auto num_bytes = static_cast<std::size_t>(head.num_bytes());
  has_footer_ = !input().is_in_chunk() && bytes.ensure(num_bytes + kMcapMagic.size()) &&
                bytes.available().substr(num_bytes).starts_with(kMcapMagic);
  if (has_footer_) return Step::kEnd;
  pass(head.num_bytes());
  return Step::kOther;
}

bool Mcap::has_fitting_body(const McapHead& head, std::string_view body) const {
  if (head.op == McapOp::kSchema) return read_mcap_schema(body).has_value();
  if (head.op == McapOp::kChannel) return read_mcap_channel(body).has_value();
  if (head.op != McapOp::kMessage) return true;
  const auto message = read_mcap_message_head(body);
  return message && is_known_channel(message->channel_id);
}

/// Whether a record begins here beyond doubt: not only an op code and a length that may be, which
/// numbers in a message are, too.
bool Mcap::is_record(ByteWindow& bytes) const {
  if (!bytes.ensure(McapHead::kBytes)) return false;
  const auto head = read_mcap_head(bytes.available());
  if (!head || head->op >= McapOp::kFirstPrivate) return false;
  if (head->op == McapOp::kChunk) {
    bytes.ensure(McapHead::kBytes + McapChunkHead::kMaxBytes);
    const auto chunk =
        read_mcap_chunk_head(bytes.available().substr(McapHead::kBytes), head->num_body_bytes);
    return chunk && chunk->num_bytes + chunk->num_bytes_packed == head->num_body_bytes &&
           (chunk->compression.empty() || packing_from_mcap(chunk->compression));
  }
  if (!is_followed_by_mcap_record(bytes, *head)) return false;
  return has_fitting_body(
      *head,
      bytes.available().substr(McapHead::kBytes, static_cast<std::size_t>(head->num_body_bytes)));
}

/// Whether the length of a record is so long that others are lost in it: one begins inside of it,
/// and none behind it.
bool Mcap::covers_others(ByteWindow& bytes, const McapHead& head) const {
  const bool may_be_jumped_over = head.op == McapOp::kMessage || head.op == McapOp::kAttachment;
  if (head.op == McapOp::kChunk) return false;
  if (may_be_jumped_over && head.num_bytes() > kMaxCheckedMcapBytes) return false;
  if (is_followed_by_mcap_record(bytes, head)) return false;
  ByteWindow inside(bytes.available());
  while (inside.skip(1) == 1 && inside.offset() < head.num_bytes()) {
    if (is_record(inside)) return true;
  }
  return false;
}

void Mcap::report_end() {
  if (!has_footer_) {
    problems().remarks.emplace_back("the file ends without a footer: the recording was cut short");
  }
  const std::string damage = input().file().source().damage();
  if (!damage.empty()) problems().remarks.push_back(damage);
}

}  // namespace setsquare
