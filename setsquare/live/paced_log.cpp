// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/paced_log.hpp"

#include <algorithm>
#include <utility>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

PacedLog::PacedLog(std::unique_ptr<LogReader> log, double speed, WaitUntil wait_until)
    : log_(std::move(log)), speed_(speed), wait_until_(std::move(wait_until)) {
  require_not_negative(speed, "speed");
}

const LogRecord* PacedLog::next() {
  const LogRecord* record = log_->next();
  if (record == nullptr) return nullptr;
  if (!last_stamp_) due_ = Clock::now();
  if (last_stamp_ && speed_ > 0.0) {
    const double behind_s = seconds_between(*last_stamp_, record->stamp);
    const double wait_s = std::clamp(behind_s, 0.0, kLongestWait_s) / speed_;
    due_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s));
  }
  last_stamp_ = record->stamp;
  if (speed_ == 0.0) due_ = Clock::now();
  return wait_until_(due_) ? record : nullptr;
}

}  // namespace setsquare
