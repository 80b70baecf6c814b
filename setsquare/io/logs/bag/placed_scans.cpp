// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/placed_scans.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/wider_clones.hpp"

namespace setsquare {
namespace {

/// As std::nearbyint for numbers below 2^51, but without a call, so that loops vectorise: a double
/// above 2^52 has no places for a fraction.
double nearest_whole(double value) {
  constexpr double kNoFraction = 6755399441055744.0;  // 1.5 * 2^52
  return (value + kNoFraction) - kNoFraction;
}

/// The decimal number that was meant by a float32, to the unit's inverse: where the nearest
/// multiple of the unit is the same float32, that multiple, else the float32 itself. So a range
/// that a sensor gives as 1.23 m is 1.23 here, too, and not 1.2300000190734863: the same log gives
/// the same map from a text and from a bag.
double meant_decimal(double value, double per_unit) {
  const double rounded = nearest_whole(value * per_unit) / per_unit;
  return static_cast<float>(rounded) == static_cast<float>(value) ? rounded : value;
}

/// For wider instructions too: a sixth of the time of reading (timed by
/// benchmarks/stages/reading_benchmark).
SETSQUARE_WIDER_CLONES void restore_decimals(double* values,
                                             std::size_t num_values,
                                             double per_unit) {
  for (std::size_t i = 0; i < num_values; ++i) values[i] = meant_decimal(values[i], per_unit);
}

void restore_decimals(Scan& scan) {
  constexpr double kRangesPerMetre = 1e4;
  constexpr double kAnglesPerDegree = 1e4;
  restore_decimals(scan.ranges_m.data(), scan.ranges_m.size(), kRangesPerMetre);
  for (double* angle_rad : {&scan.first_bearing_rad, &scan.bearing_step_rad}) {
    const double degrees =
        nearest_whole(deg_from_rad(*angle_rad) * kAnglesPerDegree) / kAnglesPerDegree;
    const double meant_rad = rad_from_deg(degrees);
    if (static_cast<float>(meant_rad) == static_cast<float>(*angle_rad)) *angle_rad = meant_rad;
  }
  scan.min_range_m = meant_decimal(scan.min_range_m, kRangesPerMetre);
  scan.max_range_m = meant_decimal(scan.max_range_m, kRangesPerMetre);
}

bool has_measurement_beyond_max(const Scan& scan, RangeCodes& codes) {
  return std::any_of(scan.ranges_m.begin(), scan.ranges_m.end(), [&](double range_m) {
    return range_m > scan.max_range_m && std::isfinite(range_m) && !codes.is_code(range_m);
  });
}

}  // namespace

std::string_view PlacedScans::place(ros::LaserScan&& message,
                                    const Eigen::Isometry3d& T_base_sensor,
                                    Scan& scan) {
  ++num_scans_;
  const ros::ScanConversion converted = ros::scan_from_laser_scan(std::move(message), scan);
  count_oddities(converted.oddities, scan);
  if (!converted.fault.empty()) return converted.fault;
  restore_decimals(scan);
  if (T_base_sensor.matrix() != T_base_sensor_) {
    T_base_sensor_ = T_base_sensor.matrix();
    mounting_ = ros::mounting_from_transform(T_base_sensor);
  }
  if (!mounting_.is_horizontal()) return "the scanner does not look along the floor";
  mounted_.mount(mounting_, scan);
  return {};
}

void PlacedScans::count_oddities(ros::ScanOddities oddities, const Scan& scan) {
  for (std::size_t k = 0; k < num_odd_.size(); ++k) {
    const auto oddity = static_cast<ros::ScanOddity>(k);
    if (!oddities.has(oddity)) continue;
    const bool is_of_codes = oddity == ros::ScanOddity::kRangesBeyondMax &&
                             !has_measurement_beyond_max(scan, codes_beyond_max_);
    if (!is_of_codes) ++num_odd_[k];
  }
}

std::vector<std::string> PlacedScans::remarks() const {
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < num_odd_.size(); ++k) {
    if (num_odd_[k] == 0 || static_cast<ros::ScanOddity>(k) == ros::ScanOddity::kNoStamp) continue;
    const ros::OddityText text = ros::describe(static_cast<ros::ScanOddity>(k));
    sentences.push_back(
        fmt::format("{} in {:.3g} % of the scans; {}",
                    text.what,
                    100.0 * static_cast<double>(num_odd_[k]) / static_cast<double>(num_scans_),
                    text.remedy));
  }
  if (const std::string remark = mounting_.remark(); !remark.empty()) sentences.push_back(remark);
  return sentences;
}

}  // namespace setsquare
