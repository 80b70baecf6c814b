// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "setsquare/core/timestamp.hpp"

namespace setsquare::foxglove {

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< To listen on; "0.0.0.0" for all of the machine's.
  std::uint16_t port = 8765;          ///< 0: one that is free.
  std::string name = "setsquare";
};

/// Shows messages to Foxglove, Lichtblick and others by the Foxglove WebSocket protocol. A thread
/// of its own serves all clients; one that does not read loses messages, and nobody waits for it.
class Server {
 public:
  static constexpr std::size_t kMaxClients = 16;
  /// Waiting for one client; beyond it new messages are left out for it.
  static constexpr std::size_t kMaxBytesWaiting = 32U << 20U;

  /// Listens from now on. Throws FileError where the address is not free.
  explicit Server(const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// A topic of ROS 2 messages; `type`: "nav_msgs/msg/OccupancyGrid", `definition` as recordings
  /// carry it. `is_latched`: who subscribes gets the last message.
  [[nodiscard]] std::uint32_t add_channel(const std::string& topic,
                                          const std::string& type,
                                          const std::string& definition,
                                          bool is_latched = false);
  /// A serialised message (CDR). By any thread; returns at once.
  void publish(std::uint32_t channel, Timestamp stamp, std::string_view cdr);
  /// Whether anybody would get a message of it: else it need not be made.
  [[nodiscard]] bool is_wanted(std::uint32_t channel) const;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] std::size_t num_clients() const;
  /// Messages left out since a client did not read.
  [[nodiscard]] std::uint64_t num_left_out() const;
  /// Frames of clients that could not be read.
  [[nodiscard]] std::uint64_t num_refused() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare::foxglove
