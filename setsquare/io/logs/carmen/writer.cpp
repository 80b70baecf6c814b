// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/carmen/writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {
namespace {

constexpr double kRangeUnit_m = 0.001;
constexpr int kRangeDecimals = 3;
constexpr int kPoseDecimals = 6;
constexpr int kBearingDecimals = 9;  // 1e-9 rad per step is 1e-6 rad over a thousand beams
constexpr std::string_view kHost = " setsquare ";

void append_number(std::string& text, double value, int num_decimals) {
  fmt::format_to(std::back_inserter(text), "{:.{}f}", value, num_decimals);
}

void append_pose(std::string& text, const Pose2& pose) {
  for (const double value : {pose.x_m, pose.y_m, wrap_to_pi(pose.theta_rad)}) {
    text += ' ';
    append_number(text, value, kPoseDecimals);
  }
}

void append_tail(std::string& log, Timestamp stamp) {
  const std::string text = exact_text(stamp);
  log += fmt::format(" {}{}{}\n", text, kHost, text);
}

/// The range to write, a multiple of the unit, so that the beam's outcome stays what it was.
double written_range_m(const Scan& scan, std::size_t beam, double max_range_m) {
  switch (scan.outcome(beam)) {
    case BeamOutcome::kInvalid:
      return 0.0;
    case BeamOutcome::kNoReturn:
      return max_range_m;
    case BeamOutcome::kReturn:
      break;
  }
  return std::max(kRangeUnit_m, std::min(scan.ranges_m[beam], max_range_m - kRangeUnit_m));
}

}  // namespace

void append_carmen_scan(std::string& log, const Scan& scan, const CarmenRobot& robot) {
  scan.validate();
  if (!std::isfinite(scan.max_range_m)) throw ParameterError("max_range_m", "must be finite");
  if (scan.num_beams() == 0) throw ParameterError("ranges_m", "must hold a beam");
  // Rounded up: a return just below the maximum range stays below what is written.
  const double max_range_m = kRangeUnit_m * std::ceil(scan.max_range_m / kRangeUnit_m - 1e-6);
  fmt::format_to(std::back_inserter(log), "ROBOTLASER{} 0", scan.scanner + 1);
  for (const double angle_rad :
       {scan.first_bearing_rad, scan.field_of_view_rad(), scan.bearing_step_rad}) {
    append_number(log += ' ', angle_rad, kBearingDecimals);
  }
  append_number(log += ' ', max_range_m, kRangeDecimals);
  log += " 0.01 0 ";  // accuracy in m; no remissions
  log += std::to_string(scan.num_beams());
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    append_number(log += ' ', written_range_m(scan, beam, max_range_m), kRangeDecimals);
  }
  log += " 0";
  append_pose(log, robot.T_odom_base * scan.T_base_sensor);
  append_pose(log, robot.T_odom_base);
  append_number(log += ' ', robot.forward_m_per_s, kPoseDecimals);
  append_number(log += ' ', robot.turn_rad_per_s, kPoseDecimals);
  log += " 0 0 0";  // safety distances and turn axis
  append_tail(log, scan.stamp);
}

void append_carmen_true_pose(std::string& log,
                             Timestamp stamp,
                             const Pose2& T_map_base,
                             const Pose2& T_odom_base) {
  log += "TRUEPOS";
  append_pose(log, T_map_base);
  append_pose(log, T_odom_base);
  append_tail(log, stamp);
}

}  // namespace setsquare
