// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace setsquare::view {

/// What browsers are shown, one text of each kind: a newer one replaces the last.
enum class Shown { kReport, kMap, kWay, kPose };
inline constexpr std::size_t kNumShown = 4;

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< To listen on; "0.0.0.0" for all of the machine's.
  std::uint16_t port = 8765;          ///< 0: one that is free.
};

/// Serves one page and keeps every browser that has it open up to date.
///
/// GET / is the page; GET /live a WebSocket, by which texts come and commands go. A thread of its
/// own serves all. Memory is bounded by the texts' size: of each kind a browser is sent the newest
/// alone, when it has read what came before. Requests whose Host is none of this machine's, and
/// WebSockets that another site's page opens, are refused: no other site can command the robot.
class Server {
 public:
  static constexpr std::size_t kMaxClients = 16;
  static constexpr std::size_t kMaxRequestBytes = 8192;  ///< Of HTTP's head; of a command.
  static constexpr std::size_t kMaxCommands = 16;        ///< That wait; more are refused.

  /// A command's text in, the text that the one who gave it is sent out. One at a time, on a thread
  /// of its own: it may take its time. Must not throw.
  using OnCommand = std::function<std::string(const std::string& command)>;

  /// Listens from now on. Throws FileError where the address is not free.
  Server(const ServerOptions& options, std::string page, OnCommand on_command);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // By any thread; returns at once.

  /// The newest text of its kind; who comes later gets it, too.
  void show(Shown kind, std::string text);
  [[nodiscard]] std::size_t num_clients() const;
  [[nodiscard]] std::uint16_t port() const;
  /// Requests that were refused or could not be read.
  [[nodiscard]] std::uint64_t num_refused() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare::view
