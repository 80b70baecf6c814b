// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "setsquare/io/logs/faults/checks.hpp"

namespace setsquare {
namespace {

struct StampScale {
  const char* name;
  const char* option;
  double ratio;  ///< How many of it make a second.
};
constexpr StampScale kStampScales[] = {{"milliseconds", "--stamp-unit ms", 1e3},
                                       {"microseconds", "--stamp-unit us", 1e6},
                                       {"nanoseconds", "--stamp-unit ns", 1e9}};

/// The unit in which a time that should be about `expected_s` reads as `time_s`.
const StampScale& scale_of(double time_s, double expected_s) {
  const double ratio = time_s / expected_s;
  if (ratio < 3e4) return kStampScales[0];
  return ratio < 3e7 ? kStampScales[1] : kStampScales[2];
}

LogFinding stamp_unit_finding(const std::string& what, const StampScale& scale) {
  return {.kind = FindingKind::kStampUnit,
          .sentence = fmt::format("{}: stamps in {}?", what, scale.name),
          .share = 1.0,
          .option = scale.option};
}

}  // namespace

std::optional<LogFinding> check_stamp_unit(const CheckedLaser& laser) {
  constexpr double kLeastPath_m = 1.0;
  constexpr double kSlowest_m_per_s = 0.01;
  constexpr double kUsual_m_per_s = 0.3;
  constexpr double kLongestPeriod_s = 16.0;
  constexpr double kUsualPeriod_s = 0.1;
  const OdometrySurvey& odometry = laser.odometry;
  if (odometry.path_m > kLeastPath_m && odometry.moving_s > 0.0) {
    const double speed_m_per_s = odometry.path_m / odometry.moving_s;
    if (speed_m_per_s > kSlowest_m_per_s) return std::nullopt;
    return stamp_unit_finding(
        fmt::format("{}: the robot would move at {:.2g} mm/s", laser.name, 1e3 * speed_m_per_s),
        scale_of(kUsual_m_per_s / speed_m_per_s, 1.0));
  }
  const double period_s = laser.sensor.stamps.octave_of_period_s();
  if (period_s < kLongestPeriod_s) return std::nullopt;
  return stamp_unit_finding(
      fmt::format("{}: about {:.2g} s lie between a scan and the next", laser.name, period_s),
      scale_of(period_s, kUsualPeriod_s));
}

std::optional<LogFinding> check_stamps_backward(const CheckedLaser& laser) {
  const StampSurvey& stamps = laser.sensor.stamps;
  if (stamps.num_backward == 0) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kStampsBackward,
      .sentence = fmt::format("{}: {} stamps run backwards, by up to {:.2f} s (scans are taken in "
                              "file order)",
                              laser.name,
                              stamps.num_backward,
                              stamps.largest_backward_s),
      .share = static_cast<double>(stamps.num_backward) / static_cast<double>(stamps.num_stamps)};
}

std::optional<LogFinding> check_stamps_repeated(const CheckedLaser& laser) {
  const StampSurvey& stamps = laser.sensor.stamps;
  if (stamps.num_repeated == 0) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kStampsRepeated,
      .sentence =
          fmt::format("{}: {} stamps equal the one before", laser.name, stamps.num_repeated),
      .share = static_cast<double>(stamps.num_repeated) / static_cast<double>(stamps.num_stamps)};
}

}  // namespace setsquare
