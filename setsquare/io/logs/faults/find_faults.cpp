// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/faults/find_faults.hpp"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <utility>

#include "setsquare/io/logs/faults/checks.hpp"

namespace setsquare {
namespace {

using LaserCheck = std::optional<LogFinding> (*)(const CheckedLaser&);

constexpr std::array<LaserCheck, 17> kLaserChecks = {check_range_unit,
                                                     check_error_codes,
                                                     check_repeated_range,
                                                     check_isolated_returns,
                                                     check_robot_parts,
                                                     check_returns,
                                                     check_number_of_beams,
                                                     check_beams_change,
                                                     check_first_bearing,
                                                     check_field_of_view,
                                                     check_mirrored,
                                                     check_scans_repeated,
                                                     check_scans_stand,
                                                     check_odometry_constant,
                                                     check_stamp_unit,
                                                     check_stamps_backward,
                                                     check_stamps_repeated};

void keep(std::optional<LogFinding> finding, std::vector<LogFinding>& found) {
  if (finding) found.push_back(std::move(*finding));
}

void check_odometry(const std::string& name,
                    const OdometrySurvey& odometry,
                    std::vector<LogFinding>& found) {
  keep(check_odometry_jumps(name, odometry), found);
  keep(check_odometry_speed(name, odometry), found);
}

}  // namespace

std::string percent(double share) {
  const double percents = 100.0 * share;
  return fmt::format("{:.{}f} %", percents, percents < 9.95 ? 1 : 0);
}

std::vector<LogFinding> find_faults(const LogSurvey& survey, const LogProblems& problems) {
  std::vector<LogFinding> found;
  for (const auto& [name, sensor] : survey.sensors) {
    const CheckedLaser laser{name, sensor, survey.scan_odometry.at(name)};
    for (const LaserCheck check : kLaserChecks) keep(check(laser), found);
  }
  for (const auto& [name, odometry] : survey.scan_odometry) {
    check_odometry(name, odometry, found);
  }
  check_odometry("odometry records", survey.wheel_odometry, found);
  for (const std::string& remark : problems.remarks) {
    found.push_back({.kind = FindingKind::kRemark, .sentence = remark});
  }
  if (problems.num_damaged > 0) {
    found.push_back({.kind = FindingKind::kDamagedRecords, .sentence = summary(problems)});
  }
  return found;
}

}  // namespace setsquare
