// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_survey.hpp"

#include <bit>
#include <cmath>

#include "setsquare/core/jump.hpp"
#include "setsquare/core/same_numbers.hpp"
#include "setsquare/scan/housing.hpp"
#include "setsquare/scan/isolated_returns.hpp"

namespace setsquare {
namespace {

/// Shorter steps are none.
constexpr double kLeastStep_m = 0.001;

/// The wheels said one direction at both ends of a step that went in the other.
bool is_sign_contradiction(double forward_m, double speed_before_m_per_s, double speed_m_per_s) {
  constexpr double kSmallestStep_m = 0.002;
  constexpr double kSmallestSpeed_m_per_s = 0.01;
  const double slowest_forward = std::min(speed_before_m_per_s, speed_m_per_s);
  const double slowest_backward = std::max(speed_before_m_per_s, speed_m_per_s);
  return (forward_m > kSmallestStep_m && slowest_backward < -kSmallestSpeed_m_per_s) ||
         (forward_m < -kSmallestStep_m && slowest_forward > kSmallestSpeed_m_per_s);
}

}  // namespace

void StampSurvey::add(Timestamp stamp) {
  if (num_stamps == 0) {
    first = earliest = latest = stamp;
  } else {
    const double step_s = seconds_between(previous, stamp);
    num_backward += step_s < 0.0 ? 1 : 0;
    num_repeated += step_s == 0.0 ? 1 : 0;
    largest_backward_s = std::max(largest_backward_s, -step_s);
    longest_gap_s = std::max(longest_gap_s, step_s);
    const std::int64_t step_ns = stamp.ns - previous.ns;
    if (step_ns > 0) ++num_per_octave[std::bit_width(static_cast<std::uint64_t>(step_ns)) - 1];
    earliest = std::min(earliest, stamp);
    latest = std::max(latest, stamp);
  }
  previous = stamp;
  ++num_stamps;
}

double StampSurvey::octave_of_period_s() const {
  std::uint64_t num_below = 0;
  for (std::size_t octave = 0; octave < num_per_octave.size(); ++octave) {
    num_below += num_per_octave[octave];
    if (2 * num_below >= num_stamps) return 1e-9 * std::ldexp(1.0, static_cast<int>(octave));
  }
  return 0.0;
}

void SensorSurvey::count_code(double range_m, std::uint64_t count) {
  const auto found = codes.find(range_m);
  if (found != codes.end()) {
    found->second += count;
  } else if (count > 0 && codes.size() < kMaxCodes) {
    codes.emplace(range_m, count);
  }
}

void SensorSurvey::add_ranges(const Scan& scan) {
  double code_m = 0.0;
  std::uint64_t num_of_code = 0;  // of the same, beam after beam
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    far.add(range_m);
    switch (scan.outcome(beam)) {
      case BeamOutcome::kReturn:
        ++num_returns;
        return_range_m.include(range_m);
        break;
      case BeamOutcome::kNoReturn:
        ++num_no_returns;
        if (range_m != code_m) {
          count_code(code_m, num_of_code);
          code_m = range_m;
          num_of_code = 0;
        }
        ++num_of_code;
        break;
      case BeamOutcome::kInvalid:
        ++num_invalid;
        num_in_housing += range_m > 0.0 && range_m < kHousingRadius_m ? 1 : 0;
        break;
    }
  }
  count_code(code_m, num_of_code);
}

void SensorSurvey::add(const Scan& scan) {
  stamps.add(scan.stamp);
  num_beams.include(static_cast<double>(scan.num_beams()));
  first_bearing_rad.include(scan.first_bearing_rad);
  bearing_step_rad.include(scan.bearing_step_rad);
  field_of_view_rad.include(scan.field_of_view_rad());
  max_range_m = scan.max_range_m;
  T_base_sensor = scan.T_base_sensor;
  add_ranges(scan);
  repeated.add(scan);
  num_isolated += num_isolated_returns(scan);
  robot_parts.add(scan);
  num_unchanged += are_same_numbers(scan.ranges_m, previous_ranges_m_) ? 1 : 0;
  previous_ranges_m_ = scan.ranges_m;
}

void OdometrySurvey::add(const LogRecord& record) {
  if (!record.T_odom_base) return;
  ++num_poses;
  if (previous_) {
    const Pose2 T_before_after = previous_->T_odom_base.inverse() * *record.T_odom_base;
    const double seconds = std::abs(seconds_between(previous_->stamp, record.stamp));
    const double step_m = std::hypot(T_before_after.x_m, T_before_after.y_m);
    path_m += step_m;
    moving_s += step_m >= kLeastStep_m ? seconds : 0.0;
    turn_rad += std::abs(T_before_after.theta_rad);
    num_still += previous_->T_odom_base == *record.T_odom_base ? 1 : 0;
    if (is_jump(T_before_after, seconds) && num_jumps++ == 0) first_jump = record.stamp;
    const bool has_speeds = previous_->forward_m_per_s && record.forward_m_per_s;
    const bool is_contradiction =
        has_speeds && is_sign_contradiction(
                          T_before_after.x_m, *previous_->forward_m_per_s, *record.forward_m_per_s);
    if (is_contradiction && num_sign_contradictions++ == 0) {
      first_contradiction = record.stamp;
    }
  }
  previous_ = Previous{record.stamp, *record.T_odom_base, record.forward_m_per_s};
}

void LogSurvey::add(const LogRecord& record) {
  switch (record.kind) {
    case RecordKind::kScan: {
      SensorSurvey& sensor = sensors[record.sensor];
      sensor.add(record.scan);
      sensor.has_assumed_bearings = record.has_assumed_bearings;
      if (record.T_odom_base) sensor.motion.add(record.scan, *record.T_odom_base);
      scan_odometry[record.sensor].add(record);
      break;
    }
    case RecordKind::kOdometry:
      wheel_odometry.add(record);
      break;
    case RecordKind::kTurnRate:
      break;
    case RecordKind::kTruePose:
      ++num_true_poses;
      break;
  }
}

}  // namespace setsquare
