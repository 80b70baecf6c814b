// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/time_window.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::time_window_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::SizeIs;

/// One scan per stamp.
std::string carmen_log(const std::vector<double>& stamps_s) {
  std::string log;
  for (const double stamp_s : stamps_s) {
    log += fmt::format("FLASER 3 1.0 2.0 1.5 0 0 0 0 0 0 {0:.6f} host {0:.6f}\n", stamp_s);
  }
  return log;
}

std::vector<double> stamps_of(LogReader& reader) {
  std::vector<double> stamps_s;
  while (const LogRecord* record = reader.next()) stamps_s.push_back(record->stamp.seconds());
  return stamps_s;
}

std::vector<double> within_window(const LogWindow& window, const std::vector<double>& stamps_s) {
  LogOptions options;
  options.window = window;
  const auto reader = open_log(make_memory_source(carmen_log(stamps_s)), "log", options);
  return stamps_of(*reader);
}

TEST(TimeWindow, CountsFromTheFirstScan) {
  const LogWindow window{.from_s = 1.0, .to_s = 2.0, .max_rate_hz = {}};
  EXPECT_THAT(within_window(window, {100.0, 100.5, 101.0, 102.0, 102.5}),
              ElementsAre(101.0, 102.0));
}

TEST(TimeWindow, TakesStampsFrom1e8On) {
  const LogWindow window{.from_s = 1e9 + 1.0, .to_s = {}, .max_rate_hz = {}};
  EXPECT_THAT(within_window(window, {1e9, 1e9 + 1.0, 1e9 + 2.0}),
              ElementsAre(DoubleNear(1e9 + 1.0, 1e-6), DoubleNear(1e9 + 2.0, 1e-6)));
}

TEST(TimeWindow, ThinsToARate) {
  std::vector<double> stamps_s;
  for (int i = 0; i < 40; ++i) stamps_s.push_back(0.1 * i);
  const LogWindow window{.from_s = {}, .to_s = {}, .max_rate_hz = 2.0};
  EXPECT_THAT(within_window(window, stamps_s), SizeIs(8));
}

TEST(TimeWindow, AnEmptyWindowIsAnError) {
  const LogWindow window{.from_s = 50.0, .to_s = {}, .max_rate_hz = {}};
  EXPECT_THROW(within_window(window, {0.0, 1.0}), FormatError);
}

}  // namespace
}  // namespace setsquare::time_window_test
