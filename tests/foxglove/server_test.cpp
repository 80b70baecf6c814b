// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Our client at our server; others' are tried in tests/live_foxglove.
#include "setsquare/foxglove/server.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/foxglove/client.hpp"

namespace setsquare::foxglove {
namespace server_test {

/// What a client heard, to be waited for.
class Heard {
 public:
  void add(std::string_view data) {
    const std::lock_guard lock(mutex_);
    messages_.emplace_back(data);
    has_more_.notify_all();
  }
  [[nodiscard]] bool wait_for(std::size_t num) {
    std::unique_lock lock(mutex_);
    return has_more_.wait_for(
        lock, std::chrono::seconds(20), [&] { return messages_.size() >= num; });
  }
  [[nodiscard]] std::vector<std::string> messages() {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable has_more_;
  std::vector<std::string> messages_;
};

Client::Calls calls_of(Heard& heard, const std::string& topic) {
  return {.on_channel = [topic](const Channel& channel) -> std::optional<std::size_t> {
            if (channel.topic != topic) return std::nullopt;
            return 0;
          },
          .on_message = [&](std::size_t, std::string_view data) { heard.add(data); },
          .on_state = [](const std::string&) {}};
}

std::string url_of(const Server& server) {
  return "ws://127.0.0.1:" + std::to_string(server.port());
}

bool wait_until(const std::function<bool()>& is_so) {
  for (int i = 0; i < 400 && !is_so(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return is_so();
}

TEST(FoxgloveServer, MessagesComeInTheirOrder) {
  Server server({.port = 0});
  const std::uint32_t scan = server.add_channel("/scan", "sensor_msgs/msg/LaserScan", "");
  (void)server.add_channel("/tf", "tf2_msgs/msg/TFMessage", "");
  Heard heard;
  const Client client(url_of(server), calls_of(heard, "/scan"));
  ASSERT_TRUE(wait_until([&] { return server.is_wanted(scan); }));
  for (int i = 0; i < 100; ++i) server.publish(scan, {i}, std::to_string(i));
  ASSERT_TRUE(heard.wait_for(100));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(heard.messages()[i], std::to_string(i));
  EXPECT_EQ(server.num_clients(), 1U);
}

TEST(FoxgloveServer, WhoComesLateGetsTheLastMessageOfALatchedChannel) {
  Server server({.port = 0});
  const std::uint32_t map = server.add_channel("/map", "nav_msgs/msg/OccupancyGrid", "", true);
  server.publish(map, {1}, "old");
  server.publish(map, {2}, "new");
  Heard heard;
  const Client client(url_of(server), calls_of(heard, "/map"));
  ASSERT_TRUE(heard.wait_for(1));
  EXPECT_EQ(heard.messages(), std::vector<std::string>{"new"});
}

TEST(FoxgloveServer, AChannelMayComeLater) {
  Server server({.port = 0});
  Heard heard;
  const Client client(url_of(server), calls_of(heard, "/late"));
  ASSERT_TRUE(wait_until([&] { return server.num_clients() == 1; }));
  const std::uint32_t late = server.add_channel("/late", "std_msgs/msg/String", "");
  ASSERT_TRUE(wait_until([&] { return server.is_wanted(late); }));
  server.publish(late, {}, "x");
  EXPECT_TRUE(heard.wait_for(1));
}

TEST(FoxgloveServer, AClientComesBackWhereItsServerWent) {
  Heard heard;
  auto server = std::make_unique<Server>(ServerOptions{.port = 0});
  const std::uint16_t port = server->port();
  const Client client(url_of(*server), calls_of(heard, "/scan"));
  ASSERT_TRUE(wait_until([&] { return server->num_clients() == 1; }));
  server.reset();
  server = std::make_unique<Server>(ServerOptions{.port = port});
  const std::uint32_t scan = server->add_channel("/scan", "sensor_msgs/msg/LaserScan", "");
  ASSERT_TRUE(wait_until([&] { return server->is_wanted(scan); }));
  server->publish(scan, {}, "again");
  EXPECT_TRUE(heard.wait_for(1));
}

TEST(FoxgloveServer, NamesAnAddressThatIsTaken) {
  const Server server({.port = 0});
  EXPECT_THROW(Server({.address = "not an address"}), FileError);
}

TEST(FoxgloveAddress, IsReadOrRefused) {
  EXPECT_EQ(parse_server_address("ws://127.0.0.1").port, "8765");
  EXPECT_EQ(parse_server_address("ws://robot:9090/path").host, "robot");
  EXPECT_EQ(parse_server_address("ws://robot:9090/path").path, "/path");
  EXPECT_EQ(parse_server_address("ws://[::1]:9090").host, "::1");
  for (const char* bad : {"", "robot", "http://robot", "ws://", "ws://robot:", "ws://robot:x1"}) {
    EXPECT_THROW((void)parse_server_address(bad), ParameterError) << bad;
  }
}

}  // namespace server_test
}  // namespace setsquare::foxglove
