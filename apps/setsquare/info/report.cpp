// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/info/report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "apps/setsquare/scans/findings.hpp"
#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

/// "180" or "180 to 181".
std::string text_of(const Interval& interval, int num_decimals, double unit = 1.0) {
  const std::string low = fmt::format("{:.{}f}", unit * interval.low, num_decimals);
  const std::string high = fmt::format("{:.{}f}", unit * interval.high, num_decimals);
  return low == high ? low : fmt::format("{} to {}", low, high);
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string text_of_codes(const SensorSurvey& sensor) {
  constexpr std::size_t kMaxShown = 8;
  std::vector<std::pair<double, std::uint64_t>> codes(sensor.codes.begin(), sensor.codes.end());
  std::stable_sort(
      codes.begin(), codes.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(codes.size(), kMaxShown); ++i) {
    text += fmt::format("{}{:.2f} m ({})", i == 0 ? "" : ", ", codes[i].first, codes[i].second);
  }
  return codes.size() > kMaxShown ? text + ", ..." : text;
}

void print_sensor(const std::string& name,
                  bool is_front,
                  const SensorSurvey& sensor,
                  std::ostream& out) {
  const double degrees = deg_from_rad(1.0);
  const double duration_s = sensor.stamps.duration_s();
  const std::uint64_t num_all = sensor.num_returns + sensor.num_no_returns + sensor.num_invalid;
  out << "\n" << name << (is_front ? " (the laser that is read by default)\n" : "\n");
  out << fmt::format("  scans      {} in {:.1f} s", sensor.stamps.num_stamps, duration_s);
  if (duration_s > 0.0) {
    out << fmt::format(", {:.2f} per second, longest gap {:.2f} s",
                       static_cast<double>(sensor.stamps.num_stamps - 1) / duration_s,
                       sensor.stamps.longest_gap_s);
  }
  out << "\n  stamps     " << to_string(sensor.stamps.first) << " to "
      << to_string(sensor.stamps.previous) << "\n";
  out << "  beams      " << text_of(sensor.num_beams, 0) << ", the first at "
      << text_of(sensor.first_bearing_rad, 2, degrees) << " deg, step "
      << text_of(sensor.bearing_step_rad, 4, degrees) << " deg, field of view "
      << text_of(sensor.field_of_view_rad, 2, degrees) << " deg\n";
  out << fmt::format("  mounting   x {:.3f} m, y {:.3f} m, heading {:.2f} deg on the robot\n",
                     sensor.T_base_sensor.x_m,
                     sensor.T_base_sensor.y_m,
                     deg_from_rad(sensor.T_base_sensor.theta_rad));
  out << fmt::format("  returns    {:.2f} %", percent(sensor.num_returns, num_all));
  if (!sensor.return_range_m.empty()) {
    out << " (" << text_of(sensor.return_range_m, 2) << " m)";
  }
  out << fmt::format(", nothing seen {:.2f} % (from {:.2f} m), invalid {:.2f} %\n",
                     percent(sensor.num_no_returns, num_all),
                     sensor.max_range_m,
                     percent(sensor.num_invalid, num_all));
  if (!sensor.codes.empty()) out << "  codes      " << text_of_codes(sensor) << "\n";
}

void print_recording(const RecordingOverview& recording, std::ostream& out) {
  if (recording.empty()) return;
  const double duration_s = seconds_between(recording.first, recording.last);
  out << fmt::format("\nrecording of {:.1f} s\n", duration_s);
  for (const RecordingTopic& topic : recording.topics) {
    out << fmt::format("  {:<28} {:<36} {:>8}", topic.name, topic.type, topic.num_messages);
    if (duration_s > 0.0 && topic.num_messages > 1) {
      out << fmt::format("  {:.1f} Hz", static_cast<double>(topic.num_messages) / duration_s);
    }
    out << (topic.is_read ? "\n" : "  (not read)\n");
  }
  if (!recording.frames.empty()) out << "frames\n";
  for (const RecordingFrame& frame : recording.frames) {
    out << fmt::format(
        "  {} -> {}{}: x {:.3f}, y {:.3f}, z {:.3f} m, roll {:.1f}, pitch {:.1f}, yaw {:.1f} deg\n",
        frame.parent,
        frame.name,
        frame.is_static ? "" : " (moving)",
        frame.x_m,
        frame.y_m,
        frame.z_m,
        deg_from_rad(frame.roll_rad),
        deg_from_rad(frame.pitch_rad),
        deg_from_rad(frame.yaw_rad));
  }
  out << "odometry is read from " << (recording.odometry.empty() ? "nothing" : recording.odometry)
      << "\n";
}

void print_odometry(const char* name, const OdometrySurvey& odometry, std::ostream& out) {
  if (odometry.num_poses == 0) return;
  out << fmt::format(
      "  {:<10} {} poses, path {:.1f} m, turns {:.0f} deg in sum, at rest {:.1f} %\n",
      name,
      odometry.num_poses,
      odometry.path_m,
      deg_from_rad(odometry.turn_rad),
      percent(odometry.num_still, odometry.num_poses));
}

void print_damage(const LogProblems& problems, std::ostream& out) {
  out << "\ndamaged records\n";
  for (const LogProblem& problem : problems.first) {
    out << "  " << problem.location << ": " << problem.reason << "\n";
  }
  if (problems.num_damaged > problems.first.size()) out << "  ...\n";
}

}  // namespace

void print_info(const InfoReport& report, std::ostream& out) {
  out << report.path << ": " << report.format << "\n";
  if (report.survey.sensors.empty()) out << "\nno scans\n";
  for (const auto& [name, sensor] : report.survey.sensors) {
    print_sensor(name, name == report.front_sensor, sensor, out);
  }
  print_recording(report.recording, out);
  out << "\nodometry\n";
  bool has_odometry = report.survey.wheel_odometry.num_poses > 0;
  for (const auto& [name, odometry] : report.survey.scan_odometry) {
    print_odometry(name.c_str(), odometry, out);
    has_odometry = has_odometry || odometry.num_poses > 0;
  }
  print_odometry("alone", report.survey.wheel_odometry, out);
  if (!has_odometry) out << "  none\n";
  out << "\nwhat is wrong\n";
  print_findings(report.findings, out);
  if (report.findings.empty()) out << "  nothing found\n";
  if (report.problems.num_damaged > 1) print_damage(report.problems, out);
}

}  // namespace setsquare::app
