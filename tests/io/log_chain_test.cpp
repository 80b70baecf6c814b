// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_chain.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::log_chain_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

std::string flaser_line(double stamp_s) {
  return fmt::format("FLASER 3 1.0 2.0 1.5 0 0 0 0 0 0 {0:.6f} host {0:.6f}\n", stamp_s);
}

std::string carmen_log(const std::vector<double>& stamps_s) {
  std::string log;
  for (const double stamp_s : stamps_s) log += flaser_line(stamp_s);
  return log;
}

/// One scan a second of each scanner, in this order.
std::string log_of_scanners(const std::vector<std::string>& names) {
  std::string log;
  for (std::size_t i = 0; i < names.size(); ++i) {
    log += fmt::format(
        R"({{"stamp": {}, "sensor": "{}", "angle_min": -1, "angle_step": 1, "ranges": [1, 2, 1]}})"
        "\n",
        i + 1,
        names[i]);
  }
  return log;
}

std::vector<double> stamps_of(LogReader& reader) {
  std::vector<double> stamps_s;
  while (const LogRecord* record = reader.next()) stamps_s.push_back(record->stamp.seconds());
  return stamps_s;
}

TEST(LogChain, ReadsLogsOneAfterTheOther) {
  const testing::TemporaryFolder folder;
  const std::string first = folder.path() / "first.clf";
  const std::string second = folder.path() / "second.clf";
  std::ofstream(first) << carmen_log({1.0, 2.0});
  std::ofstream(second) << carmen_log({3.0, 4.0});
  EXPECT_THAT(stamps_of(*open_logs({first, second})), ElementsAre(1.0, 2.0, 3.0, 4.0));
  LogOptions options;
  options.window.from_s = 2.0;
  EXPECT_THAT(stamps_of(*open_logs({first, second}, options)), ElementsAre(3.0, 4.0));
}

TEST(LogChain, GoesOnBehindALogThatCannotBeRead) {
  const testing::TemporaryFolder folder;
  const std::string first = folder.path() / "first.clf";
  const std::string broken = folder.path() / "broken.clf";
  const std::string last = folder.path() / "last.clf";
  std::ofstream(first) << carmen_log({1.0});
  std::ofstream(broken) << "nothing that we know\n";
  std::ofstream(last) << carmen_log({2.0});
  const auto reader = open_logs({first, broken, last});
  EXPECT_THAT(stamps_of(*reader), ElementsAre(1.0, 2.0));
  EXPECT_THAT(reader->problems().remarks, ElementsAre(HasSubstr("broken.clf")));
  EXPECT_EQ(reader->front_sensor(), "FLASER");
}

TEST(LogChain, TheFirstLogMustBeThere) {
  EXPECT_THROW(static_cast<void>(open_logs({"/no/such/log", "/nor/this"})), FileError);
}

/// Of three parts of a drive the second begins with the other scanner, the third has one more.
TEST(LogChain, AScannerKeepsItsNumberFromLogToLog) {
  const testing::TemporaryFolder folder;
  const std::vector<std::vector<std::string>> parts = {
      {"front", "rear", "front"}, {"rear", "front", "rear"}, {"left", "rear", "front"}};
  std::vector<std::string> paths;
  for (const auto& names : parts) {
    paths.push_back(folder.path() / fmt::format("{}.jsonl", paths.size()));
    std::ofstream(paths.back()) << log_of_scanners(names);
  }
  LogOptions options;
  options.sensor = "all";
  const auto reader = open_logs(paths, options);
  std::vector<std::pair<std::string, std::uint32_t>> numbers;
  while (const LogRecord* record = reader->next()) {
    numbers.emplace_back(record->sensor, record->scan.scanner);
    EXPECT_EQ(record->scan.num_beams(), 3U);
  }
  EXPECT_THAT(numbers,
              ElementsAre(Pair("front", 0U),
                          Pair("rear", 1U),
                          Pair("front", 0U),
                          Pair("rear", 1U),
                          Pair("front", 0U),
                          Pair("rear", 1U),
                          Pair("left", 2U),
                          Pair("rear", 1U),
                          Pair("front", 0U)));
}

}  // namespace
}  // namespace setsquare::log_chain_test
