// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/point_slice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/io/ros/mounting.hpp"

namespace setsquare::ros {
namespace {

constexpr double kAutoHalfHeight_m = 0.3;
constexpr double kMinBin_rad = rad_from_deg(0.05);
constexpr double kMaxBin_rad = rad_from_deg(2.0);
constexpr double kDefaultBin_rad = rad_from_deg(0.5);

/// Whether all points lie in one plane across the sensor's axis, up to noise.
bool is_flat(const SensorPoints& points) {
  constexpr float kThickness_m = 0.1F;
  const auto [lowest, highest] = std::minmax_element(points.z_m.begin(), points.z_m.end());
  return *highest - *lowest <= kThickness_m;
}

}  // namespace

void SliceParams::validate() const {
  if (!std::isfinite(low_m) || !std::isfinite(high_m) || low_m >= high_m) {
    throw ParameterError("high_m", "must be above low_m");
  }
  if (bin_width_rad && !(*bin_width_rad >= kMinBin_rad && *bin_width_rad <= kQuarterTurn)) {
    throw ParameterError("bin_width_rad", "must be from 0.05 to 90 degrees");
  }
}

PointSlicer::PointSlicer(const SliceParams& params) : params_(params) { params_.validate(); }

std::string_view PointSlicer::slice(const PointCloud2& message,
                                    const Eigen::Isometry3d& T_base_sensor,
                                    Scan& scan) {
  const std::string_view fault = read_points(message, points_);
  if (!fault.empty()) return fault;
  if (points_.size() == 0) return "it has no points";
  settle_kind(T_base_sensor.translation().z());
  if (params_.kind == SliceKind::kRing && points_.rings.empty()) {
    return "its points have no field \"ring\" or \"channel\"";
  }
  const bool needs_level_sensor = params_.kind != SliceKind::kHeights;
  if (needs_level_sensor && !mounting_from_transform(T_base_sensor).is_horizontal()) {
    return "the scanner is not horizontal";
  }
  select(T_base_sensor);
  if (selected_.size() < 2) return "no points in the slice";
  if (num_bins_ == 0) settle_bins();
  scan = {};
  scan.stamp = message.stamp;
  scan.first_bearing_rad = first_bearing_rad_;
  scan.bearing_step_rad = bin_width_rad_;
  scan.T_base_sensor = {T_base_sensor.translation().x(), T_base_sensor.translation().y(), 0.0};
  scan.ranges_m.assign(num_bins_, std::numeric_limits<double>::quiet_NaN());
  for (const PolarPoint& point : selected_) {
    const auto bin = bin_of(point.bearing_rad);
    if (bin) scan.ranges_m[*bin] = std::fmin(scan.ranges_m[*bin], point.range_m);
  }
  return {};
}

void PointSlicer::settle_kind(double sensor_height_m) {
  if (params_.kind != SliceKind::kAuto) return;
  params_.kind = is_flat(points_) ? SliceKind::kPlane : SliceKind::kHeights;
  params_.low_m = sensor_height_m - kAutoHalfHeight_m;
  params_.high_m = sensor_height_m + kAutoHalfHeight_m;
}

void PointSlicer::select(const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Matrix3d rotation = T_base_sensor.linear();
  const double sensor_height_m = T_base_sensor.translation().z();
  selected_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (params_.kind == SliceKind::kRing && points_.rings[i] != params_.ring) continue;
    const Eigen::Vector3d p_sensor =
        Eigen::Vector3f(points_.x_m[i], points_.y_m[i], points_.z_m[i]).cast<double>();
    const Eigen::Vector3d p_level = rotation * p_sensor;
    const double height_m = p_level.z() + sensor_height_m;
    const bool is_out = height_m < params_.low_m || height_m > params_.high_m;
    if (params_.kind == SliceKind::kHeights && is_out) continue;
    const double range_m = p_level.head<2>().norm();
    if (range_m > 0.0) selected_.push_back({std::atan2(p_level.y(), p_level.x()), range_m});
  }
}

/// The bins go once around from the first point's bearing on, so that the beams of a scanner with
/// even steps fall into the middle of bins.
void PointSlicer::settle_bins() {
  bin_width_rad_ = params_.bin_width_rad.value_or(kDefaultBin_rad);
  std::sort(selected_.begin(), selected_.end(), [](const PolarPoint& a, const PolarPoint& b) {
    return a.bearing_rad < b.bearing_rad;
  });
  const double first_rad = selected_.front().bearing_rad;
  if (!params_.bin_width_rad && params_.kind != SliceKind::kHeights) {
    const double gap_rad = std::clamp(median_gap_rad(), kMinBin_rad, kMaxBin_rad);
    const double span_rad = selected_.back().bearing_rad - first_rad;
    const double num_gaps = std::max(1.0, std::round(span_rad / gap_rad));
    bin_width_rad_ = std::clamp(span_rad / num_gaps, kMinBin_rad, kMaxBin_rad);
  }
  const double bins_in_turn = kTwoPi / bin_width_rad_;
  constexpr double kWholeNumberSlack = 0.1;
  const bool is_whole = std::abs(bins_in_turn - std::round(bins_in_turn)) < kWholeNumberSlack;
  num_bins_ = static_cast<std::size_t>(is_whole ? std::round(bins_in_turn) : bins_in_turn);
  if (is_whole) bin_width_rad_ = kTwoPi / static_cast<double>(num_bins_);
  first_bearing_rad_ = first_rad - std::floor((first_rad + kPi) / bin_width_rad_) * bin_width_rad_;
}

/// The middle one of the gaps between neighbouring bearings, which are sorted; points behind one
/// another do not count.
double PointSlicer::median_gap_rad() const {
  constexpr double kSameBearing_rad = 1e-4;
  std::vector<double> gaps_rad;
  for (std::size_t i = 1; i < selected_.size(); ++i) {
    const double gap_rad = selected_[i].bearing_rad - selected_[i - 1].bearing_rad;
    if (gap_rad > kSameBearing_rad) gaps_rad.push_back(gap_rad);
  }
  return gaps_rad.empty() ? kDefaultBin_rad : upper_median(std::move(gaps_rad));
}

/// Nothing between the last bin and the first where they do not meet.
std::optional<std::size_t> PointSlicer::bin_of(double bearing_rad) const {
  const double bins_in_turn = kTwoPi / bin_width_rad_;
  double bin = std::round((bearing_rad - first_bearing_rad_) / bin_width_rad_);
  const auto num_bins = static_cast<double>(num_bins_);
  if (bin < 0.0) bin = std::round((bearing_rad + kTwoPi - first_bearing_rad_) / bin_width_rad_);
  if (bin >= num_bins) bin = std::round(bin - bins_in_turn);
  if (bin < 0.0 || bin >= num_bins) return std::nullopt;
  return static_cast<std::size_t>(bin);
}

}  // namespace setsquare::ros
