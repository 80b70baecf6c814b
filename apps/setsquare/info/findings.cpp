// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <string>

#include "apps/setsquare/info/report.hpp"

namespace setsquare::app {
namespace {

/// "line 12" in a text log, "offset 12" in a binary one.
std::string place(const InfoReport& report, std::uint64_t position) {
  return fmt::format("{} {}", report.format == "CARMEN log" ? "line" : "offset", position);
}

void add_stamp_findings(const std::string& name,
                        const SensorSurvey& sensor,
                        std::vector<std::string>& found) {
  const StampSurvey& stamps = sensor.stamps;
  if (stamps.num_backward > 0) {
    found.push_back(fmt::format(
        "{}: {} stamps run backwards, by up to {:.2f} s (scans are taken in file order)",
        name,
        stamps.num_backward,
        stamps.largest_backward_s));
  }
  if (stamps.num_repeated > 0) {
    found.push_back(fmt::format("{}: {} stamps equal the one before", name, stamps.num_repeated));
  }
  if (sensor.num_unchanged > 0) {
    found.push_back(fmt::format(
        "{}: {} scans repeat the one before, range by range", name, sensor.num_unchanged));
  }
  if (sensor.num_returns == 0) found.push_back(name + ": not one return");
}

void add_geometry_findings(const std::string& name,
                           const SensorSurvey& sensor,
                           std::vector<std::string>& found) {
  constexpr double kRounding_rad = 2e-6;
  const auto is_changing = [](const Interval& interval, double tolerance) {
    return interval.high - interval.low > tolerance;
  };
  if (is_changing(sensor.num_beams, 0.0)) {
    found.push_back(name + ": the number of beams changes from scan to scan");
  }
  if (is_changing(sensor.first_bearing_rad, kRounding_rad)) {
    found.push_back(name +
                    ": the first beam's direction changes from scan to scan (used as given)");
  }
}

void add_odometry_findings(const InfoReport& report,
                           const std::string& name,
                           const OdometrySurvey& odometry,
                           std::vector<std::string>& found) {
  if (odometry.num_jumps > 0) {
    found.push_back(
        fmt::format("{}: the odometry jumps {} times, faster than any robot, first at {}",
                    name,
                    odometry.num_jumps,
                    place(report, odometry.first_jump_position)));
  }
  if (odometry.num_sign_contradictions > 0) {
    found.push_back(
        fmt::format("{}: the odometry contradicts itself in {} of {} steps, first at {}: the pose "
                    "moves one way while the reported speed points the other",
                    name,
                    odometry.num_sign_contradictions,
                    odometry.num_poses,
                    place(report, odometry.first_contradiction_position)));
  }
}

}  // namespace

std::vector<std::string> findings(const InfoReport& report) {
  std::vector<std::string> found;
  for (const auto& [name, sensor] : report.survey.sensors) {
    add_stamp_findings(name, sensor, found);
    add_geometry_findings(name, sensor, found);
  }
  for (const auto& [name, odometry] : report.survey.scan_odometry) {
    add_odometry_findings(report, name, odometry, found);
  }
  add_odometry_findings(report, "odometry records", report.survey.wheel_odometry, found);
  const LogProblems& problems = report.problems;
  found.insert(found.end(), problems.remarks.begin(), problems.remarks.end());
  if (problems.num_damaged > 0) {
    found.push_back(fmt::format("{} damaged record{} skipped:",
                                problems.num_damaged,
                                problems.num_damaged == 1 ? "" : "s"));
  }
  for (const LogProblem& problem : problems.first) {
    found.push_back(fmt::format("  {}: {}", problem.location, problem.reason));
  }
  if (problems.num_damaged > problems.first.size()) found.emplace_back("  ...");
  return found;
}

}  // namespace setsquare::app
