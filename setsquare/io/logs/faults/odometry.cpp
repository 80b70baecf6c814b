// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "setsquare/io/logs/faults/checks.hpp"
#include "setsquare/io/logs/stamp_text.hpp"

namespace setsquare {

std::optional<LogFinding> check_odometry_jumps(const std::string& name,
                                               const OdometrySurvey& odometry) {
  // A jump now and then is bridged by the scans; with many there is no odometry.
  constexpr double kManyJumps = 0.01;
  if (odometry.num_jumps == 0) return std::nullopt;
  const double share =
      static_cast<double>(odometry.num_jumps) / static_cast<double>(odometry.num_poses);
  return LogFinding{
      .kind = FindingKind::kOdometryJumps,
      .sentence = fmt::format("{}: the odometry jumps {} times ({} of its steps), faster than any "
                              "robot, first at the stamp {} s",
                              name,
                              odometry.num_jumps,
                              percent(share),
                              exact_text(odometry.first_jump)),
      .share = share,
      .option = share >= kManyJumps ? "--no-odometry" : ""};
}

std::optional<LogFinding> check_odometry_speed(const std::string& name,
                                               const OdometrySurvey& odometry) {
  if (odometry.num_sign_contradictions == 0) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kOdometrySpeed,
      .sentence = fmt::format(
          "{}: the odometry contradicts itself in {} of {} steps, first at the stamp {} s: "
          "the pose moves one way while the reported speed points the other",
          name,
          odometry.num_sign_contradictions,
          odometry.num_poses,
          exact_text(odometry.first_contradiction)),
      .share = static_cast<double>(odometry.num_sign_contradictions) /
               static_cast<double>(odometry.num_poses)};
}

}  // namespace setsquare
