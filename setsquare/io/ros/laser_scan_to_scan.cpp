// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/laser_scan_to_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/wider_clones.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare::ros {
namespace {

constexpr double kRoundingSlack_rad = 1e-3;
/// No driver counts bearings further round than this.
constexpr double kFarthestBearing_rad = 2.0 * kTwoPi;

/// Bearings of the beams while they are worked out.
struct Sweep {
  double first_rad = 0.0;
  double step_rad = 0.0;
  std::size_t num_beams = 0;

  [[nodiscard]] double span_rad() const {
    return std::abs(step_rad) * static_cast<double>(num_beams - 1);
  }
};

/// What angle_min and angle_max say about the step.
double stated_step_rad(const LaserScan& message, std::size_t num_beams) {
  return (message.angle_max_rad - message.angle_min_rad) / static_cast<double>(num_beams - 1);
}

bool spans_one_turn(const LaserScan& message, std::size_t num_beams) {
  const double span_rad = std::abs(message.angle_max_rad - message.angle_min_rad);
  const double step_rad = kTwoPi / static_cast<double>(num_beams);
  return span_rad > kTwoPi - 1.5 * step_rad && span_rad < kTwoPi + kRoundingSlack_rad;
}

/// angle_max against where the beams end.
void judge_angle_max(const LaserScan& message, const Sweep& sweep, ScanOddities& oddities) {
  const double last_rad =
      sweep.first_rad + sweep.step_rad * static_cast<double>(sweep.num_beams - 1);
  const double num_beams_off = std::abs((message.angle_max_rad - last_rad) / sweep.step_rad);
  if (num_beams_off <= 0.5) return;
  oddities.add(num_beams_off <= 1.5 ? ScanOddity::kAngleMaxOneBeamOff : ScanOddity::kAngleMaxOff);
}

/// The step, where angle_increment gives one that stays within a turn, or else the two angles do.
std::string_view settle_step(const LaserScan& message, Sweep& sweep, ScanOddities& oddities) {
  if (sweep.num_beams == 1) return {};
  const double slack_beams = sweep.num_beams > 2 ? 0.25 : 0.0;  // For a last beam that repeats.
  const double max_span_rad = kTwoPi + kRoundingSlack_rad;
  sweep.step_rad = message.angle_increment_rad;
  if (!std::isfinite(sweep.step_rad) || sweep.step_rad == 0.0) {
    oddities.add(ScanOddity::kNoIncrement);
    sweep.step_rad = stated_step_rad(message, sweep.num_beams);
    const bool is_usable = sweep.step_rad != 0.0 && sweep.span_rad() <= max_span_rad;
    return is_usable ? std::string_view{} : "no step from beam to beam";
  }
  if (sweep.span_rad() > max_span_rad + slack_beams * std::abs(sweep.step_rad)) {
    oddities.add(ScanOddity::kMoreThanOneTurn);
    if (!spans_one_turn(message, sweep.num_beams)) return "the beams sweep more than one turn";
    sweep.step_rad = stated_step_rad(message, sweep.num_beams);
  }
  judge_angle_max(message, sweep, oddities);
  return {};
}

std::string_view settle_bearings(LaserScan& message, Scan& scan, ScanOddities& oddities) {
  Sweep sweep{message.angle_min_rad, 0.0, message.ranges_m.size()};
  if (!std::isfinite(sweep.first_rad)) {
    oddities.add(ScanOddity::kNoAngles);
    return "angle_min is not finite";
  }
  const std::string_view fault = settle_step(message, sweep, oddities);
  if (!fault.empty()) return fault;
  if (std::abs(sweep.first_rad) > kFarthestBearing_rad) {
    oddities.add(ScanOddity::kNoAngles);
    return "angle_min is no angle";
  }
  if (sweep.step_rad < 0.0) oddities.add(ScanOddity::kClockwise);
  const bool is_last_repeated =
      sweep.num_beams > 2 && sweep.span_rad() > kTwoPi - 0.25 * std::abs(sweep.step_rad);
  if (is_last_repeated) {
    oddities.add(ScanOddity::kRepeatedBeam);
    --sweep.num_beams;
  }
  scan.first_bearing_rad = sweep.first_rad;
  scan.bearing_step_rad = sweep.step_rad;
  scan.ranges_m.swap(message.ranges_m);
  scan.ranges_m.resize(sweep.num_beams);
  return {};
}

void settle_range_limits(const LaserScan& message, Scan& scan, ScanOddities& oddities) {
  scan.min_range_m = message.range_min_m;
  scan.max_range_m = message.range_max_m;
  if (!(scan.min_range_m >= 0.0)) {
    oddities.add(ScanOddity::kNoRangeMin);
    scan.min_range_m = 0.0;
  }
  if (!(scan.max_range_m > 0.0)) {
    oddities.add(ScanOddity::kNoRangeMax);
    scan.max_range_m = std::numeric_limits<double>::infinity();
  }
  if (scan.min_range_m >= scan.max_range_m) {
    oddities.add(ScanOddity::kRangeLimitsReversed);
    scan.min_range_m = 0.0;
    scan.max_range_m = std::numeric_limits<double>::infinity();
  }
}

/// How many ranges lie above a limit; infinity is none. Counted without a branch, and for wider
/// instructions too, since every range of every scan passes here: a fifth of the time of reading
/// (timed by benchmarks/stages/reading_benchmark).
SETSQUARE_WIDER_CLONES std::size_t count_finite_above(const double* ranges_m,
                                                      std::size_t num_ranges,
                                                      double limit_m) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  std::size_t num_above = 0;
  for (std::size_t i = 0; i < num_ranges; ++i) {
    num_above += static_cast<std::size_t>(ranges_m[i] > limit_m) &
                 static_cast<std::size_t>(ranges_m[i] <= kLargest);
  }
  return num_above;
}

bool has_ranges_beyond(const std::vector<double>& ranges_m, double max_range_m) {
  const double slack_m = 1e-6 * max_range_m;  // range_max and the ranges are float32.
  return count_finite_above(ranges_m.data(), ranges_m.size(), max_range_m + slack_m) > 0;
}

/// A time that is not told is 0, or no number; one that no scanner takes says nothing, either.
void settle_times(const LaserScan& message, Scan& scan, ScanOddities& oddities) {
  const auto usable_s = [&](double time_s, std::size_t num_times) {
    if (!std::isfinite(time_s) || time_s <= 0.0) return 0.0;
    if (time_s * static_cast<double>(num_times) <= kLongestSweep_s) return time_s;
    oddities.add(ScanOddity::kEndlessSweep);
    return 0.0;
  };
  scan.time_increment_s = usable_s(message.time_increment_s, scan.num_beams() - 1);
  scan.scan_time_s = usable_s(message.scan_time_s, 1);
}

}  // namespace

OddityText describe(ScanOddity oddity) {
  constexpr std::array<OddityText, kNumScanOddities> kTexts = {{
      {"the stamp is zero", "the time of recording can be taken in its place"},
      {"angle_max is one beam off the last beam", "angle_increment and the beams were taken"},
      {"angle_max is far from the last beam", "angle_increment and the beams were taken"},
      {"angle_increment is zero or no number", "the step was taken from angle_min and angle_max"},
      {"angle_increment is negative", "the beams were taken as running clockwise"},
      {"the last beam of a full turn repeats the first", "it was left out"},
      {"the beams times angle_increment make more than one turn",
       "angle_min and angle_max were taken where they span one turn; other scans were left out"},
      {"range_max is zero, negative or NaN", "every range was taken; --max-range sets a limit"},
      {"range_min is negative or NaN", "it was taken as zero"},
      {"range_min is not below range_max", "both were left aside; --max-range sets a limit"},
      {"ranges lie above range_max", "they count as no return; --max-range sets a higher limit"},
      {"there are no ranges, or more than any scanner has", "the scan was left out"},
      {"angle_min is no angle", "the scan was left out"},
      {"a sweep would take more than 10 s", "the beams were taken as measured at once"},
  }};
  return kTexts[static_cast<std::size_t>(oddity)];
}

ScanConversion scan_from_laser_scan(LaserScan&& message, Scan& scan) {
  ScanConversion conversion;
  if (message.ranges_m.empty() || message.ranges_m.size() > kMaxBeams) {
    conversion.oddities.add(ScanOddity::kNoBeams);
    conversion.fault = message.ranges_m.empty() ? "it has no ranges" : "too many ranges";
    return conversion;
  }
  if (message.stamp == Timestamp{}) conversion.oddities.add(ScanOddity::kNoStamp);
  scan.stamp = message.stamp;
  conversion.fault = settle_bearings(message, scan, conversion.oddities);
  if (!conversion.fault.empty()) return conversion;
  settle_times(message, scan, conversion.oddities);
  settle_range_limits(message, scan, conversion.oddities);
  if (has_ranges_beyond(scan.ranges_m, scan.max_range_m)) {
    conversion.oddities.add(ScanOddity::kRangesBeyondMax);
  }
  return conversion;
}

}  // namespace setsquare::ros
