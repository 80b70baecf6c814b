// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "setsquare/io/logs/faults/checks.hpp"
#include "setsquare/scan/housing.hpp"
#include "setsquare/scan/isolated_returns.hpp"

namespace setsquare {
namespace {

double share_of_ranges(const SensorSurvey& sensor, std::uint64_t count) {
  const std::uint64_t num_ranges = sensor.num_ranges();
  return num_ranges == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(num_ranges);
}

/// In another unit than metres every other check of ranges is out of place.
bool has_other_unit(const CheckedLaser& laser) { return check_range_unit(laser).has_value(); }

}  // namespace

std::optional<LogFinding> check_range_unit(const CheckedLaser& laser) {
  constexpr double kLeastShare = 0.3;
  // Rooms are metres wide: hundreds of centimetres, thousands of millimetres.
  constexpr double kMostCentimetres = 600.0;
  const FarRanges& far = laser.sensor.far;
  const double share = share_of_ranges(laser.sensor, far.num_measured());
  if (share < kLeastShare) return std::nullopt;
  const bool is_mm = far.octave_of_median() > kMostCentimetres;
  return LogFinding{
      .kind = FindingKind::kRangeUnit,
      .sentence = fmt::format("{}: {} of the ranges lie between {:.0f} and {:.0f} m: in {}?",
                              laser.name,
                              percent(share),
                              far.shortest_measured(),
                              far.longest_measured(),
                              is_mm ? "millimetres" : "centimetres"),
      .share = share,
      .option = is_mm ? "--range-scale 0.001" : "--range-scale 0.01"};
}

std::optional<LogFinding> check_error_codes(const CheckedLaser& laser) {
  constexpr double kLeastShare = 0.001;
  const double share = share_of_ranges(laser.sensor, laser.sensor.num_in_housing);
  if (share < kLeastShare) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kErrorCodes,
      .sentence = fmt::format("{}: {} of the ranges are below {:.0f} cm: error codes, taken for no "
                              "measurement",
                              laser.name,
                              percent(share),
                              100.0 * kHousingRadius_m),
      .share = share};
}

std::optional<LogFinding> check_repeated_range(const CheckedLaser& laser) {
  constexpr double kMostBeyond = 0.001;
  const auto repeated = laser.sensor.repeated.most_striking();
  if (!repeated || has_other_unit(laser)) return std::nullopt;
  const bool is_reach = repeated->share_beyond < kMostBeyond;
  return LogFinding{
      .kind = FindingKind::kRepeatedRange,
      .sentence = fmt::format("{}: {} of the returns are {} m to the last digit: a code for "
                              "\"nothing seen\"?",
                              laser.name,
                              percent(repeated->share),
                              repeated->range_m),
      .share = repeated->share,
      .option =
          fmt::format("{} {}", is_reach ? "--max-range" : "--ignore-range", repeated->range_m)};
}

std::optional<LogFinding> check_isolated_returns(const CheckedLaser& laser) {
  constexpr double kLeastShare = 0.01;
  const double share = share_of_ranges(laser.sensor, laser.sensor.num_isolated);
  if (share < kLeastShare) return std::nullopt;
  const bool is_fine = laser.sensor.bearing_step_rad.high < kFineStep_rad;
  return LogFinding{
      .kind = FindingKind::kIsolatedReturns,
      .sentence = fmt::format(
          "{}: {} of the ranges stand alone in front of all around them: sun, "
          "dust or drops? {}",
          laser.name,
          percent(share),
          is_fine ? "They are left out where a scan has many" : "They may keep loops from closing"),
      .share = share};
}

std::optional<LogFinding> check_robot_parts(const CheckedLaser& laser) {
  const double share = laser.sensor.robot_parts.share_of_circle();
  if (share == 0.0) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kRobotParts,
      .sentence = fmt::format("{}: {:.0f} deg of the circle show the robot itself, which never "
                              "moves away: left out",
                              laser.name,
                              deg_from_rad(share * kTwoPi)),
      .share = share};
}

std::optional<LogFinding> check_returns(const CheckedLaser& laser) {
  if (laser.sensor.num_returns > 0 || has_other_unit(laser)) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kNoReturns, .sentence = laser.name + ": not one return", .share = 1.0};
}

}  // namespace setsquare
