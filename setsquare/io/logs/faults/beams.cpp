// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "setsquare/io/logs/faults/checks.hpp"
#include "setsquare/scan/few_beams.hpp"

namespace setsquare {

std::optional<LogFinding> check_number_of_beams(const CheckedLaser& laser) {
  const Interval& num_beams = laser.sensor.num_beams;
  if (num_beams.empty() || num_beams.high >= static_cast<double>(kFewestBeams)) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kFewBeams,
      .sentence = fmt::format("{}: {:.0f} beams a scan are too few to see walls (a map needs {} "
                              "or more); what comes out follows the odometry at best",
                              laser.name,
                              num_beams.high,
                              kFewestBeams),
      .share = 1.0};
}

std::optional<LogFinding> check_beams_change(const CheckedLaser& laser) {
  const Interval& num_beams = laser.sensor.num_beams;
  if (num_beams.empty() || num_beams.low == num_beams.high) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kBeamsChange,
      .sentence = fmt::format("{}: the number of beams changes from scan to scan, from {:.0f} to "
                              "{:.0f} (used as given)",
                              laser.name,
                              num_beams.low,
                              num_beams.high)};
}

std::optional<LogFinding> check_first_bearing(const CheckedLaser& laser) {
  constexpr double kRounding_rad = 2e-6;
  const Interval& bearing_rad = laser.sensor.first_bearing_rad;
  if (!(bearing_rad.high - bearing_rad.low > kRounding_rad)) return std::nullopt;
  return LogFinding{.kind = FindingKind::kFirstBearingChanges,
                    .sentence = laser.name +
                                ": the first beam's direction changes from scan to scan (used as "
                                "given)"};
}

}  // namespace setsquare
