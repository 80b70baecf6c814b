// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/scanners/mounting_trial.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <limits>
#include <utility>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

/// Of the deviations from the median of normal noise, in standard deviations.
constexpr double kSigmaPerMedianDeviation = 1.4826;
/// Of the median of n values, in standard deviations of the mean.
constexpr double kMedianToMean = 1.2533;
/// Sightings near each other see the same walls: so many count for one.
constexpr double kNumAlike = 3.0;

struct RobustMean {
  double value = 0.0;
  double sigma = std::numeric_limits<double>::infinity();
};

RobustMean robust_mean(const std::vector<double>& values) {
  if (values.empty()) return {};
  const double middle = median(values);
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - middle));
  const double spread = kSigmaPerMedianDeviation * median(std::move(deviations));
  return {middle,
          kMedianToMean * spread / std::sqrt(static_cast<double>(values.size()) / kNumAlike)};
}

/// An angle that most of them are near: none is far from it by a turn of the circle.
double rough_direction_rad(const std::vector<double>& angles_rad) {
  std::vector<double> cosines;
  std::vector<double> sines;
  for (const double angle_rad : angles_rad) {
    cosines.push_back(std::cos(angle_rad));
    sines.push_back(std::sin(angle_rad));
  }
  return std::atan2(median(std::move(sines)), median(std::move(cosines)));
}

RobustMean robust_mean_of_angles(std::vector<double> angles_rad) {
  const double rough_rad = rough_direction_rad(angles_rad);
  for (double& angle_rad : angles_rad) angle_rad = wrap_to_pi(angle_rad - rough_rad);
  const RobustMean mean = robust_mean(angles_rad);
  return {wrap_to_pi(rough_rad + mean.value), mean.sigma};
}

}  // namespace

void MountingTrialParams::validate() const {
  require_positive(spacing_m, "mounting.spacing_m");
  require_positive(spacing_rad, "mounting.spacing_rad");
  require_positive(max_off_m, "mounting.max_off_m");
  require_positive(max_off_rad, "mounting.max_off_rad");
  require_positive(max_sigmas, "mounting.max_sigmas");
  require_positive(max_sigma_rad, "mounting.max_sigma_rad");
  require_at_least_one(max_tries_per_sighting, "mounting.max_tries_per_sighting");
}

MountingTrial::MountingTrial(const MountingTrialParams& params, const Pose2& T_base_sensor)
    : params_(params) {
  result_.T_base_sensor = T_base_sensor;
  result_.T_base_seen = T_base_sensor;
  result_.verdict =
      params.num_sightings == 0 ? MountingVerdict::kConfirmed : MountingVerdict::kOpen;
}

bool MountingTrial::wants(const Pose2& T_odom_body) const {
  if (result_.verdict != MountingVerdict::kOpen) return false;
  if (!T_odom_last_) return true;
  const Pose2 moved = T_odom_last_->inverse() * T_odom_body;
  return is_beyond(moved, params_.spacing_m, params_.spacing_rad);
}

void MountingTrial::add(const Pose2& T_odom_body,
                        const Pose2& T_odom_sensor_stated,
                        const std::optional<MountingSighting>& sighting) {
  T_odom_last_ = T_odom_body;
  ++num_tried_;
  if (sighting) {
    const Pose2 T_stated_seen = T_odom_sensor_stated.inverse() * sighting->T_odom_sensor;
    turned_rad_.push_back(T_stated_seen.theta_rad);
    if (sighting->is_bound) moved_m_.push_back(T_stated_seen.translation());
  }
  if (turned_rad_.size() >= params_.num_sightings) {
    estimate();
    if (result_.sigma_rad > params_.max_sigma_rad) return;
    result_.verdict = is_off() ? MountingVerdict::kRefuted : MountingVerdict::kConfirmed;
  } else if (num_tried_ >= params_.max_tries_per_sighting * params_.num_sightings) {
    result_.verdict = MountingVerdict::kUnfit;
  }
}

void MountingTrial::estimate() {
  std::vector<double> x_m;
  std::vector<double> y_m;
  for (const Eigen::Vector2d& moved_m : moved_m_) {
    x_m.push_back(moved_m.x());
    y_m.push_back(moved_m.y());
  }
  const RobustMean x = robust_mean(x_m);
  const RobustMean y = robust_mean(y_m);
  const RobustMean turn = robust_mean_of_angles(turned_rad_);
  T_stated_seen_ = {x.value, y.value, turn.value};
  result_.T_base_seen = result_.T_base_sensor * T_stated_seen_;
  result_.sigma_rad = turn.sigma;
  result_.sigma_m = std::max(x.sigma, y.sigma);
  result_.num_sightings = turned_rad_.size();
}

bool MountingTrial::is_off() const {
  const double off_m = T_stated_seen_.translation().norm();
  return std::abs(T_stated_seen_.theta_rad) >
             std::max(params_.max_off_rad, params_.max_sigmas * result_.sigma_rad) ||
         off_m > std::max(params_.max_off_m, params_.max_sigmas * result_.sigma_m);
}

}  // namespace setsquare
