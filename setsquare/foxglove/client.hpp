// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/foxglove/protocol.hpp"

namespace setsquare::foxglove {

/// Where a server listens: "ws://127.0.0.1:8765".
struct ServerAddress {
  std::string host;
  std::string port = "8765";
  std::string path = "/";
};

/// Throws ParameterError where it is no "ws://HOST[:PORT][/PATH]".
[[nodiscard]] ServerAddress parse_server_address(const std::string& url);

/// Takes messages from a server of the Foxglove WebSocket protocol, foxglove_bridge for instance. A
/// thread of its own connects, and again, a second later, where the server goes.
class Client {
 public:
  /// Messages beyond it end the connection.
  static constexpr std::size_t kMaxMessageBytes = 64U << 20U;

  struct Calls {
    /// Whether messages of a channel are wanted, and by which number of ours they go.
    std::function<std::optional<std::size_t>(const Channel&)> on_channel;
    std::function<void(std::size_t number, std::string_view data)> on_message;
    /// Connected, or why not: once per change.
    std::function<void(const std::string&)> on_state;
  };

  /// All calls come on the client's thread. Throws ParameterError.
  Client(const std::string& url, Calls calls);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Frames that could not be read.
  [[nodiscard]] std::uint64_t num_refused() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare::foxglove
