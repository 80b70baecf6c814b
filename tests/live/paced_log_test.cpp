// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/paced_log.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace paced_log_test {

/// Records of these stamps, in s.
class StampedLog final : public LogReader {
 public:
  explicit StampedLog(std::vector<double> stamps_s) : stamps_s_(std::move(stamps_s)) {}

  const LogRecord* next() override {
    if (num_read_ == stamps_s_.size()) return nullptr;
    record_.stamp = timestamp_from_seconds(stamps_s_[num_read_++]);
    return &record_;
  }
  [[nodiscard]] const LogProblems& problems() const override { return problems_; }
  [[nodiscard]] std::string front_sensor() const override { return "LASER"; }
  [[nodiscard]] std::string format() const override { return "stamps"; }
  [[nodiscard]] std::optional<double> fraction_read() const override { return std::nullopt; }

 private:
  std::vector<double> stamps_s_;
  std::size_t num_read_ = 0;
  LogRecord record_;
  LogProblems problems_;
};

/// When each record is due behind the first, in s, by a clock that nobody waits for.
std::vector<double> due_times_s(std::vector<double> stamps_s, double speed) {
  PacedLog log(std::make_unique<StampedLog>(std::move(stamps_s)), speed, [](auto) { return true; });
  std::vector<double> times_s;
  std::optional<PacedLog::Clock::time_point> first;
  while (log.next() != nullptr) {
    if (!first) first = log.due();
    times_s.push_back(std::chrono::duration<double>(log.due() - *first).count());
  }
  return times_s;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
}

TEST(PacedLog, RecordsAreDueWhenTheRobotHadThem) {
  expect_near(due_times_s({100.0, 100.1, 100.5}, 1.0), {0.0, 0.1, 0.5});
}

TEST(PacedLog, OrSoManyTimesFaster) {
  expect_near(due_times_s({100.0, 100.1, 100.5}, 10.0), {0.0, 0.01, 0.05});
}

TEST(PacedLog, TimeGoesOnBehindAStampThatRunsBackwards) {
  expect_near(due_times_s({100.0, 100.4, 50.0, 50.1}, 1.0), {0.0, 0.4, 0.4, 0.5});
}

TEST(PacedLog, NobodyWaitsForHoursOfNothing) {
  expect_near(due_times_s({100.0, 9000.0, 9000.1}, 1.0),
              {0.0, PacedLog::kLongestWait_s, PacedLog::kLongestWait_s + 0.1});
}

TEST(PacedLog, EndsWhereWaitingIsBrokenOff) {
  int num_waits = 0;
  PacedLog log(std::make_unique<StampedLog>(std::vector<double>(10, 1.0)), 1.0, [&](auto) {
    return ++num_waits < 4;
  });
  int num = 0;
  while (log.next() != nullptr) ++num;
  EXPECT_EQ(num, 3);
}

TEST(PacedLog, RefusesASpeedThatIsNone) {
  EXPECT_THROW(PacedLog(std::make_unique<StampedLog>(std::vector<double>{}), -1.0, {}),
               ParameterError);
}

}  // namespace paced_log_test
}  // namespace setsquare
