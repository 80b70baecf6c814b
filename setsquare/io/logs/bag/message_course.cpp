// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/message_course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace setsquare {
namespace {

constexpr double kMaxStampJump_s = 1.0;
/// Faster than any robot that is mapped indoors, by much; and what stamps may be off.
constexpr double kFastest_m_per_s = 20.0;
constexpr double kFastest_rad_per_s = 20.0;
constexpr double kCourseSlack_m = 0.2;
constexpr double kCourseSlack_rad = 0.3;

constexpr std::uint64_t kNumToTakeOver = 3;
constexpr double kTimeToTakeOver_s = 0.5;

bool is_too_fast(const CourseMessage& before, const CourseMessage& after) {
  if (!before.pose || !after.pose) return false;
  const double elapsed_s = std::abs(seconds_between(before.stamp, after.stamp));
  const Eigen::Isometry3d moved = before.pose->inverse() * *after.pose;
  const double turn_rad = Eigen::AngleAxisd(moved.linear()).angle();
  return moved.translation().norm() > kCourseSlack_m + kFastest_m_per_s * elapsed_s ||
         turn_rad > kCourseSlack_rad + kFastest_rad_per_s * elapsed_s;
}

}  // namespace

std::string_view MessageCourse::break_between(const CourseMessage& before,
                                              const CourseMessage& after) const {
  const double by_stamps_s = seconds_between(before.stamp, after.stamp);
  const double by_arrival_s = seconds_between(before.log_time, after.log_time);
  if (by_stamps_s < -kMaxStampJump_s) return "its stamp jumps back";
  if (by_stamps_s > longest_jump_ahead_s() &&
      std::abs(by_stamps_s - by_arrival_s) > kMaxStampJump_s) {
    return "its stamp jumps ahead";
  }
  if (!after.is_placed && before.frames != after.frames)
    return "its frames are not those of before";
  if (is_too_fast(before, after)) return "its pose jumps farther than a robot moves";
  return {};
}

double MessageCourse::longest_jump_ahead_s() const {
  constexpr double kLongestPause_s = 1000.0;
  constexpr double kLongEnough_s = 3.0;
  constexpr double kSameShare = 0.2;
  if (has_arrival_times_) return kMaxStampJump_s;
  const double by_stamps_s = seconds_between(taken_->first.stamp, taken_->last.stamp);
  const double by_arrival_s = seconds_between(taken_->first.log_time, taken_->last.log_time);
  const bool is_by_arrival = by_stamps_s > kLongEnough_s &&
                             std::abs(by_stamps_s - by_arrival_s) < kSameShare * by_stamps_s;
  return is_by_arrival ? kMaxStampJump_s : kLongestPause_s;
}

/// Of one that is new itself anything that goes on takes the place.
bool MessageCourse::may_take_over(const Line& other) const {
  if (taken_->num < kNumToTakeOver) return other.num > 1;
  const double time_s = std::max(seconds_between(other.first.stamp, other.last.stamp),
                                 seconds_between(other.first.log_time, other.last.log_time));
  return other.num >= kNumToTakeOver && time_s >= kTimeToTakeOver_s;
}

std::string_view MessageCourse::fault_of(CourseMessage message) {
  if (!taken_) {
    taken_ = Line{message, message};
    return {};
  }
  const std::string_view fault = break_between(taken_->last, message);
  if (fault.empty()) {
    others_.clear();
    taken_->last = std::move(message);
    ++taken_->num;
    return {};
  }
  if (!has_arrival_times_ && taken_->num < kNumToTakeOver) {
    taken_ = Line{message, message};
    return {};
  }
  add_other(std::move(message));
  if (!may_take_over(others_.back())) return fault;
  taken_ = std::move(others_.back());
  others_.clear();
  return {};
}

void MessageCourse::add_other(CourseMessage message) {
  auto line = std::find_if(others_.begin(), others_.end(), [&](const Line& other) {
    return break_between(other.last, message).empty();
  });
  if (line == others_.end()) {
    if (others_.size() == kMaxOthers) others_.erase(others_.begin());
    others_.push_back(Line{message, message});
    return;
  }
  line->last = std::move(message);
  ++line->num;
  std::rotate(line, line + 1, others_.end());
}

}  // namespace setsquare
