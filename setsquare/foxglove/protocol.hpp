// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The words of the Foxglove WebSocket protocol, version 1, both sides: texts in JSON that say what
// there is and what is wanted, and binary frames with messages. No network here. What comes from a
// peer may be anything: what cannot be read is nothing.
// https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/core/timestamp.hpp"

namespace setsquare::foxglove {

/// What a connection may be called in its handshake: newer bridges demand the first, Lichtblick the
/// second.
inline constexpr std::string_view kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// The first of ours that a list with commas names; nothing where it names none.
[[nodiscard]] std::optional<std::string_view> common_subprotocol(std::string_view offered);

/// A topic that a server has.
struct Channel {
  std::uint32_t id = 0;
  std::string topic;        ///< "/scan"
  std::string encoding;     ///< "cdr"
  std::string schema_name;  ///< "sensor_msgs/msg/LaserScan"
  std::string schema;       ///< Its definition, with those of its parts.

  bool operator==(const Channel&) const = default;
};

struct Subscription {
  std::uint32_t id = 0;  ///< The client's number for it.
  std::uint32_t channel = 0;

  bool operator==(const Subscription&) const = default;
};

/// What a client wants.
struct ClientRequest {
  std::vector<Subscription> subscribed;
  std::vector<std::uint32_t> unsubscribed;
};

/// A message of a subscription.
struct MessageFrame {
  std::uint32_t subscription = 0;
  Timestamp stamp;
  std::string_view data;
};

[[nodiscard]] std::string server_info(const std::string& name, const std::string& session);
[[nodiscard]] std::string advertisement(std::span<const Channel> channels);
[[nodiscard]] std::string subscription_request(std::span<const Subscription> subscriptions);
[[nodiscard]] std::string message_frame(const MessageFrame& frame);

/// Nothing where the text is no JSON object with a word of the protocol; a word that a server need
/// not know is an empty request.
[[nodiscard]] std::optional<ClientRequest> parse_client_request(std::string_view text);
/// The channels that a server's text adds: none for its other words. Nothing as above.
[[nodiscard]] std::optional<std::vector<Channel>> parse_server_text(std::string_view text);
/// Nothing for other binary frames; `data` points into the frame.
[[nodiscard]] std::optional<MessageFrame> parse_message_frame(std::string_view frame);

}  // namespace setsquare::foxglove
