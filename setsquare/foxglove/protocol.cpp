// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/foxglove/protocol.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace setsquare::foxglove {
namespace {

using Json = nlohmann::json;

constexpr char kMessageData = 0x01;
constexpr std::size_t kNumBeforeData = 1 + 4 + 8;
static_assert(std::endian::native == std::endian::little, "byte order of the protocol");

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// An object with a word of the protocol; null otherwise.
Json object_of(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  const bool has_word = json.is_object() && json.contains("op") && json["op"].is_string();
  return has_word ? json : Json();
}

/// The elements of a list; none where it is no list.
const Json& list_of(const Json& object, const char* name) {
  static const Json kNone = Json::array();
  const auto found = object.find(name);
  return found != object.end() && found->is_array() ? *found : kNone;
}

std::optional<std::uint32_t> number_of(const Json& json) {
  if (!json.is_number_unsigned()) return std::nullopt;
  const auto number = json.get<std::uint64_t>();
  if (number > UINT32_MAX) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

std::optional<std::uint32_t> number_in(const Json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  return found == object.end() ? std::nullopt : number_of(*found);
}

std::string text_in(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::optional<std::string_view> common_subprotocol(std::string_view offered) {
  for (const std::string_view ours : kSubprotocols) {
    for (std::string_view rest = offered; !rest.empty();) {
      std::string_view name = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), name.size() + 1));
      name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
      name = name.substr(0, name.find_last_not_of(" \t") + 1);
      if (name == ours) return ours;
    }
  }
  return std::nullopt;
}

std::string server_info(const std::string& name, const std::string& session) {
  return text_of({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities", Json::array()},
                  {"supportedEncodings", {"cdr"}},
                  {"metadata", Json::object()},
                  {"sessionId", session}});
}

std::string advertisement(std::span<const Channel> channels) {
  Json list = Json::array();
  for (const Channel& channel : channels) {
    list.push_back({{"id", channel.id},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema_name},
                    {"schema", channel.schema},
                    {"schemaEncoding", "ros2msg"}});
  }
  return text_of({{"op", "advertise"}, {"channels", list}});
}

std::string subscription_request(std::span<const Subscription> subscriptions) {
  Json list = Json::array();
  for (const Subscription& one : subscriptions) {
    list.push_back({{"id", one.id}, {"channelId", one.channel}});
  }
  return text_of({{"op", "subscribe"}, {"subscriptions", list}});
}

std::string message_frame(const MessageFrame& frame) {
  std::string bytes(kNumBeforeData, kMessageData);
  const auto stamp_ns = static_cast<std::uint64_t>(frame.stamp.ns);
  std::memcpy(bytes.data() + 1, &frame.subscription, sizeof frame.subscription);
  std::memcpy(bytes.data() + 5, &stamp_ns, sizeof stamp_ns);
  return bytes.append(frame.data);
}

std::optional<ClientRequest> parse_client_request(std::string_view text) {
  const Json object = object_of(text);
  if (object.is_null()) return std::nullopt;
  ClientRequest request;
  const std::string word = object["op"].get<std::string>();
  if (word == "subscribe") {
    for (const Json& one : list_of(object, "subscriptions")) {
      const auto id = number_in(one, "id");
      const auto channel = number_in(one, "channelId");
      if (id && channel) request.subscribed.push_back({*id, *channel});
    }
  } else if (word == "unsubscribe") {
    for (const Json& one : list_of(object, "subscriptionIds")) {
      if (const auto id = number_of(one)) request.unsubscribed.push_back(*id);
    }
  }
  return request;
}

std::optional<std::vector<Channel>> parse_server_text(std::string_view text) {
  const Json object = object_of(text);
  if (object.is_null()) return std::nullopt;
  std::vector<Channel> channels;
  if (object["op"].get<std::string>() != "advertise") return channels;
  for (const Json& one : list_of(object, "channels")) {
    const auto id = number_in(one, "id");
    if (!id) continue;
    channels.push_back({.id = *id,
                        .topic = text_in(one, "topic"),
                        .encoding = text_in(one, "encoding"),
                        .schema_name = text_in(one, "schemaName"),
                        .schema = text_in(one, "schema")});
  }
  return channels;
}

std::optional<MessageFrame> parse_message_frame(std::string_view frame) {
  if (frame.size() < kNumBeforeData || frame.front() != kMessageData) return std::nullopt;
  MessageFrame parsed;
  std::uint64_t stamp_ns = 0;
  std::memcpy(&parsed.subscription, frame.data() + 1, sizeof parsed.subscription);
  std::memcpy(&stamp_ns, frame.data() + 5, sizeof stamp_ns);
  parsed.stamp.ns = static_cast<std::int64_t>(stamp_ns);
  parsed.data = frame.substr(kNumBeforeData);
  return parsed;
}

}  // namespace setsquare::foxglove
