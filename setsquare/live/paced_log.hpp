// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// A log whose records come when the robot had them: each as long behind the first as its stamp is,
/// or faster. A record that is asked for too late comes at once. Where stamps run backwards, or
/// forwards by more than kLongestWait_s, the time goes on from there.
class PacedLog final : public LogReader {
 public:
  static constexpr double kLongestWait_s = 5.0;

  using Clock = std::chrono::steady_clock;
  /// Waits until a moment; false where the log is to end instead.
  using WaitUntil = std::function<bool(Clock::time_point)>;

  /// `speed`: how many times faster than the robot; 0 for no waiting.
  PacedLog(std::unique_ptr<LogReader> log, double speed, WaitUntil wait_until);

  const LogRecord* next() override;
  [[nodiscard]] const LogProblems& problems() const override { return log_->problems(); }
  [[nodiscard]] std::string front_sensor() const override { return log_->front_sensor(); }
  [[nodiscard]] std::string format() const override { return log_->format(); }
  [[nodiscard]] std::optional<double> fraction_read() const override {
    return log_->fraction_read();
  }
  [[nodiscard]] RecordingOverview overview() const override { return log_->overview(); }

  /// When the last record was to come.
  [[nodiscard]] Clock::time_point due() const { return due_; }

 private:
  std::unique_ptr<LogReader> log_;
  double speed_;
  WaitUntil wait_until_;
  std::optional<Timestamp> last_stamp_;
  Clock::time_point due_;
};

}  // namespace setsquare
