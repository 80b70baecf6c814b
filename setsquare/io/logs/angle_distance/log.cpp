// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/angle_distance/log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// More than jitter throws an angle back by.
constexpr double kSmallestReturn_rad = kPi / 36.0;

}  // namespace

AngleDistanceLog::AngleDistanceLog(std::unique_ptr<InputBuffer> input,
                                   const AngleDistanceOptions& options)
    : LineLog(std::move(input)), options_(options) {}

LineOutcome AngleDistanceLog::fail(std::string_view reason) {
  reason_ = reason;
  return LineOutcome::kDamaged;
}

double AngleDistanceLog::radians(double angle) const {
  return options_.is_in_degrees ? rad_from_deg(angle) : angle;
}

void AngleDistanceLog::add(double angle_rad, double distance) {
  const double units_per_m = 1.0 / options_.range_unit_m;  // 1000 is exact, 0.001 is not
  const double bearing_rad = wrap_to_pi(options_.is_clockwise ? -angle_rad : angle_rad);
  beams_.push_back({bearing_rad, distance / units_per_m});
}

LineOutcome AngleDistanceLog::read_line(std::string_view line, LogRecord& record) {
  const bool is_blank = line.find_first_not_of(" \t") == std::string_view::npos;
  if (is_blank || line.front() == '#') return LineOutcome::kNoRecord;
  if (!read_angle_distance_row(line, row_)) {
    return has_rows_ ? fail("no row of angle and distance") : LineOutcome::kNoRecord;
  }
  has_rows_ = true;
  for (std::size_t i = 0; i < row_.numbers.size(); i += 2) {
    constexpr double kMaxAngle_rad = 1e3;
    if (!(std::abs(radians(row_.numbers[i])) < kMaxAngle_rad)) return fail("not an angle");
    if (options_.layout == AngleDistanceOptions::Layout::kPairs) break;
  }
  if (options_.layout == AngleDistanceOptions::Layout::kPairs) return add_beam(record);
  if (row_.numbers.size() % 2 != 0) return fail("an angle without its distance");
  if (row_.numbers.size() > 2 * kMaxBeams) return fail("more beams than a scanner has");
  beams_.clear();
  for (std::size_t i = 0; i < row_.numbers.size(); i += 2) {
    add(radians(row_.numbers[i]), row_.numbers[i + 1]);
  }
  return finish_revolution(record);
}

LineOutcome AngleDistanceLog::add_beam(LogRecord& record) {
  if (row_.numbers.size() > 3) return fail("expected angle, distance and perhaps a quality");
  const double angle_rad = radians(row_.numbers[0]);
  auto outcome = LineOutcome::kNoRecord;
  if (starts_revolution(angle_rad)) {
    outcome = finish_revolution(record);
    beams_.clear();
    smallest_rad_ = largest_rad_ = angle_rad;
  }
  previous_rad_ = angle_rad;
  smallest_rad_ = std::min(smallest_rad_, angle_rad);
  largest_rad_ = std::max(largest_rad_, angle_rad);
  if (beams_.size() == kMaxBeams) return fail("more beams than a revolution has");
  add(angle_rad, row_.numbers[1]);
  return outcome;
}

/// Whether the row is the first of a revolution that follows another.
bool AngleDistanceLog::starts_revolution(double angle_rad) {
  const bool had_marks = std::exchange(has_marks_, has_marks_ || row_.starts_revolution);
  if (beams_.empty()) {
    smallest_rad_ = largest_rad_ = angle_rad;
    return false;
  }
  if (row_.starts_revolution || had_marks) return row_.starts_revolution;
  const double step_rad = angle_rad - previous_rad_;
  const double back_rad = num_steps_up_ > 0 ? -step_rad : step_rad;
  const double swept_rad = largest_rad_ - smallest_rad_;
  const bool is_return = back_rad > std::max(kSmallestReturn_rad, 0.5 * swept_rad);
  if (is_return && num_steps_up_ != 0) return true;
  constexpr int kMaxCount = 1000;
  if (step_rad != 0.0) num_steps_up_ += step_rad > 0.0 ? 1 : -1;
  num_steps_up_ = std::clamp(num_steps_up_, -kMaxCount, kMaxCount);
  return false;
}

LineOutcome AngleDistanceLog::finish_revolution(LogRecord& record) {
  start_record(record, "laser");
  const double seconds = static_cast<double>(num_revolutions_++) / options_.rate_hz;
  if (seconds > static_cast<double>(kMaxStamp_ns) * 1e-9) return fail("its stamp is out of range");
  record.stamp = record.scan.stamp = timestamp_from_seconds(seconds);
  record.scan.max_range_m = kUnstatedMaxRange_m;
  record.scan.scan_time_s = 1.0 / options_.rate_hz;
  if (!resample(beams_, record.scan)) return fail("a revolution of fewer than two bearings");
  return LineOutcome::kRecord;
}

bool AngleDistanceLog::read_end(LogRecord& record) {
  const bool is_done =
      options_.layout == AngleDistanceOptions::Layout::kRevolutions || beams_.empty();
  if (is_done || finish_revolution(record) != LineOutcome::kRecord) return false;
  beams_.clear();
  record.position = lines().line_number();
  return true;
}

}  // namespace setsquare
