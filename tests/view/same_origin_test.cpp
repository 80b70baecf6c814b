// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/view/same_origin.hpp"

#include <gtest/gtest.h>

#include <string>

namespace setsquare::view::same_origin_test {

constexpr const char* kOwn[] = {"127.0.0.1",
                                "127.0.0.1:8765",
                                "localhost",
                                "LocalHost:80",
                                "192.168.1.7:8765",
                                "[::1]",
                                "[::1]:1"};
constexpr const char* kForeign[] = {"",
                                    "evil.example",
                                    "evil.example:8765",
                                    "localhost.evil.example",
                                    "127.0.0.1.evil.example",
                                    "127.0.0.1:8765.evil.example",
                                    "127.0.0.1:",
                                    "127.0.0.1:x",
                                    "127.0.0.1:123456",
                                    "user@127.0.0.1",
                                    "0x7f000001",
                                    "[::1",
                                    "[::1]evil",
                                    "[evil]"};

TEST(SameOrigin, AnAddressOrLocalhostIsOurs) {
  for (const char* host : kOwn) EXPECT_TRUE(is_own_host(host)) << host;
  for (const char* host : kForeign) EXPECT_FALSE(is_own_host(host)) << host;
}

// Law: a page's origin is its own host's and no other's.
TEST(SameOrigin, IsThatOfTheHostAlone) {
  for (const char* a : kOwn) {
    for (const char* b : kOwn) {
      EXPECT_EQ(is_same_origin("http://" + std::string(a), b), a == b) << a << " " << b;
    }
    EXPECT_FALSE(is_same_origin(a, a));
    EXPECT_FALSE(is_same_origin("https://" + std::string(a), a));
    EXPECT_FALSE(is_same_origin("", a));
    EXPECT_FALSE(is_same_origin("null", a));
  }
  // A name that leads here is not believed, though both agree.
  for (const char* host : kForeign) {
    EXPECT_FALSE(is_same_origin("http://" + std::string(host), host)) << host;
  }
}

}  // namespace setsquare::view::same_origin_test
