// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/foxglove/protocol.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/seed.hpp"

namespace setsquare::foxglove {
namespace protocol_test {

Channel scans() {
  return {.id = 7,
          .topic = "/scan",
          .encoding = "cdr",
          .schema_name = "sensor_msgs/msg/LaserScan",
          .schema = "float32 angle_min\n\"quoted\"\n"};
}

TEST(FoxgloveProtocol, WhatAServerSaysItsClientUnderstands) {
  const std::vector<Channel> channels = {scans(), {8, "/tf", "json", "", ""}};
  EXPECT_EQ(parse_server_text(advertisement(channels)), channels);
  EXPECT_EQ(parse_server_text(server_info("setsquare", "1")), std::vector<Channel>{});
}

TEST(FoxgloveProtocol, WhatAClientAsksItsServerUnderstands) {
  const std::vector<Subscription> wanted = {{.id = 0, .channel = 7},
                                            {.id = 4000000000, .channel = 8}};
  const auto request = parse_client_request(subscription_request(wanted));
  ASSERT_TRUE(request);
  EXPECT_EQ(request->subscribed, wanted);
  const auto over = parse_client_request(R"({"op":"unsubscribe","subscriptionIds":[3,-1,"x",5]})");
  ASSERT_TRUE(over);
  EXPECT_EQ(over->unsubscribed, (std::vector<std::uint32_t>{3, 5}));
}

TEST(FoxgloveProtocol, AMessageComesBackAsItWent) {
  const std::string data("\0\1\0\0bytes", 9);
  const std::string frame = message_frame({.subscription = 5, .stamp = {-17}, .data = data});
  const auto parsed = parse_message_frame(frame);
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->subscription, 5U);
  EXPECT_EQ(parsed->stamp.ns, -17);
  EXPECT_EQ(parsed->data, data);
  EXPECT_EQ(frame.substr(0, 5), std::string("\1\5\0\0\0", 5));  // by the specification
}

TEST(FoxgloveProtocol, EitherSubprotocolIsAccepted) {
  EXPECT_EQ(common_subprotocol("foxglove.websocket.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(common_subprotocol("other, foxglove.sdk.v1 ,foxglove.websocket.v1"), "foxglove.sdk.v1");
  EXPECT_FALSE(common_subprotocol("foxglove.websocket.v2"));
  EXPECT_FALSE(common_subprotocol(""));
  EXPECT_FALSE(common_subprotocol(" , ,"));
}

TEST(FoxgloveProtocol, WhatIsNoneIsNothing) {
  for (const char* text :
       {"", "[]", "{}", "null", "{\"op\":1}", "{\"op\":\"subscribe\"", "\xff\xfe"}) {
    EXPECT_FALSE(parse_client_request(text)) << text;
    EXPECT_FALSE(parse_server_text(text)) << text;
  }
  EXPECT_FALSE(parse_message_frame(""));
  EXPECT_FALSE(parse_message_frame(std::string(12, '\1')));
  EXPECT_FALSE(parse_message_frame(std::string(20, '\2')));
}

/// 1,000 damaged texts of each kind, and 1,000 damaged frames: nothing, or something that is
/// written again and read as the same.
TEST(FoxgloveProtocol, DamagedTextsAreReadOrRefused) {
  auto random = testing::make_generator();
  SCOPED_TRACE(testing::test_seed());
  const std::string texts[] = {advertisement(std::vector<Channel>{scans()}),
                               subscription_request(std::vector<Subscription>{{1, 2}, {3, 4}}),
                               server_info("setsquare", "1"),
                               R"({"op":"unsubscribe","subscriptionIds":[3,5]})"};
  for (const std::string& whole : texts) {
    for (int i = 0; i < 1000; ++i) {
      std::string text = whole;
      for (std::size_t k = 1 + random() % 4; k > 0; --k) {
        text[random() % text.size()] = static_cast<char>(random());
      }
      if (random() % 3 == 0) text.resize(random() % text.size());
      if (const auto request = parse_client_request(text)) {
        const auto again = parse_client_request(subscription_request(request->subscribed));
        EXPECT_EQ(again->subscribed, request->subscribed);
      }
      if (const auto channels = parse_server_text(text)) {
        EXPECT_LE(channels->size(), 1U);
      }
      (void)parse_message_frame(text);
    }
  }
}

}  // namespace protocol_test
}  // namespace setsquare::foxglove
