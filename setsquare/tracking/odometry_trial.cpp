// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/odometry_trial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/core/jump.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

/// Of a normal distribution, over the median of its absolute values.
constexpr double kSigmaOfMedian = 1.4826;

double way_m(const Pose2& motion) { return std::hypot(motion.x_m, motion.y_m); }

/// Turned by half the turn, so that the chord of an arc points where the robot went.
Eigen::Vector2d chord(const Pose2& motion) {
  return rotation_matrix(-0.5 * motion.theta_rad) * motion.translation();
}

}  // namespace

bool moves(const Pose2& step) { return is_beyond(step, 0.01, rad_from_deg(0.5)); }

void OdometryTrialParams::validate() const {
  require_positive(stretch_m, "odometry.stretch_m");
  require_positive(stretch_rad, "odometry.stretch_rad");
  require_positive(min_way_m, "odometry.min_way_m");
  require_positive(min_turn_rad, "odometry.min_turn_rad");
  require_finite(min_score, "odometry.min_score");
  require_not_negative(min_effective_points, "odometry.min_effective_points");
  require_at_least_one(num_stretches, "odometry.num_stretches");
  require_at_least_one(min_stretches, "odometry.min_stretches");
  require_not_negative(still_share, "odometry.still_share");
  require_positive(max_deviation, "odometry.max_deviation");
  if (!(usual_scale > 1.0)) throw ParameterError("odometry.usual_scale", "must be above 1");
  if (!(largest_scale > 1.0)) throw ParameterError("odometry.largest_scale", "must be above 1");
  require_not_negative(proved_deviation, "odometry.proved_deviation");
  require_positive(proved_sigmas, "odometry.proved_sigmas");
  require_positive(least_reach_m, "odometry.least_reach_m");
  require_positive(least_reach_rad, "odometry.least_reach_rad");
  require_not_negative(wheels_at_rest_m, "odometry.wheels_at_rest_m");
  require_not_negative(wheels_at_rest_rad, "odometry.wheels_at_rest_rad");
}

void MotionOnTrial::add(const Eigen::Vector2d& by_scans, const Eigen::Vector2d& by_wheels) {
  ++comparison_.num_compared;
  stretches_.push_back({by_scans, by_wheels});
  if (stretches_.size() > params_.num_stretches) stretches_.pop_front();
  if (stretches_.size() >= params_.min_stretches) judge();
}

void MotionOnTrial::judge() {
  std::vector<double> ratios;
  for (const Stretch& stretch : stretches_) {
    const double wheels = stretch.by_wheels.norm();
    if (wheels < params_.still_share * stretch.by_scans.norm()) continue;
    ratios.push_back(stretch.by_scans.dot(stretch.by_wheels) / (wheels * wheels));
  }
  if (2 * ratios.size() < stretches_.size()) {
    finding_ = Finding::kStill;
    return;
  }
  const double scale = median(std::move(ratios));
  std::vector<double> deviations;
  for (const auto& [by_scans, by_wheels] : stretches_) {
    const double larger = std::max(by_scans.norm(), std::abs(scale) * by_wheels.norm());
    deviations.push_back((by_scans - scale * by_wheels).norm() / larger);
  }
  const double deviation = median(std::move(deviations));
  comparison_.scale = scale;
  comparison_.deviation = kSigmaOfMedian * deviation;
  const bool is_scale =
      std::abs(scale) * params_.largest_scale > 1.0 && std::abs(scale) < params_.largest_scale;
  finding_ = is_scale && deviation < params_.max_deviation ? Finding::kFits : Finding::kUnlike;
}

bool MotionOnTrial::is_true() const {
  return finding_ == Finding::kFits && comparison_.deviation < params_.proved_deviation;
}

double MotionOnTrial::correction() const {
  const double scale = comparison_.scale;
  const bool is_usual = scale < params_.usual_scale && scale * params_.usual_scale > 1.0;
  return finding_ == Finding::kFits && !is_usual ? scale : 1.0;
}

std::optional<Pose2> OdometryTrial::believed(const std::optional<Pose2>& T_wheels_base,
                                             Timestamp stamp) const {
  if (!T_wheels_base || !params_.is_on) return T_wheels_base;
  if (is_refuted()) return std::nullopt;
  if (!last_) return T_wheels_base;
  const Pose2 step = mended(last_->T_wheels_base.inverse() * *T_wheels_base);
  if (is_ignored(step, stamp)) return std::nullopt;
  return is_mended_ ? last_->T_mended_base * step : *T_wheels_base;
}

void OdometryTrial::add(const std::optional<Pose2>& T_wheels_base, const PlacedBase& placed) {
  if (!T_wheels_base || !params_.is_on) {
    last_.reset();
    stretch_.reset();
    T_wheels_placed_.reset();
    return;
  }
  Pose2 T_mended_base = *T_wheels_base;
  bool is_jump = false;
  if (last_) {
    const Pose2 step = mended(last_->T_wheels_base.inverse() * *T_wheels_base);
    is_jump = is_ignored(step, placed.stamp);
    if (is_jump && is_confirmed(step, placed)) ++num_confirmed_jumps_;
    if (is_mended_) T_mended_base = last_->T_mended_base * step;
  }
  if (is_jump) ++report_.num_jumps;
  if (is_jump || is_refuted()) ++report_.num_ignored;
  last_ = Last{*T_wheels_base, T_mended_base, placed};
  if (placed.is_restart && is_at_rest(T_wheels_base) && !is_refuted()) ++report_.num_carried;
  if (placed.is_placed) T_wheels_placed_ = T_wheels_base;
  grow();
}

std::optional<Pose2> OdometryTrial::moved_since_placed(
    const std::optional<Pose2>& T_wheels_base) const {
  if (!T_wheels_base || !T_wheels_placed_) return std::nullopt;
  return T_wheels_placed_->inverse() * *T_wheels_base;
}

bool OdometryTrial::is_at_rest(const std::optional<Pose2>& T_wheels_base) const {
  const auto moved = moved_since_placed(T_wheels_base);
  return moved && !is_beyond(*moved, params_.wheels_at_rest_m, params_.wheels_at_rest_rad);
}

bool OdometryTrial::has_not_moved(const std::optional<Pose2>& T_wheels_base) const {
  const auto moved = moved_since_placed(T_wheels_base);
  return moved && !moves(*moved);
}

std::optional<StepReach> OdometryTrial::proved_reach(const Pose2& step) const {
  const bool has_proved = params_.is_on && !is_refuted() && ways_.is_true() && turns_.is_true();
  if (!has_proved) return std::nullopt;
  const double way_sigmas = params_.proved_sigmas * report_.way.deviation;
  const double turn_sigmas = params_.proved_sigmas * report_.turn.deviation;
  return StepReach{std::max(params_.least_reach_m, way_sigmas * way_m(step)),
                   std::max(params_.least_reach_rad, turn_sigmas * std::abs(step.theta_rad))};
}

OdometryTrial OdometryTrial::judged() const {
  OdometryTrial judged = *this;
  judged.last_.reset();
  judged.stretch_.reset();
  judged.T_wheels_placed_.reset();
  judged.report_.num_ignored = 0;
  judged.report_.num_jumps = 0;
  judged.report_.num_carried = 0;
  return judged;
}

bool OdometryTrial::is_refuted() const {
  return report_.verdict != OdometryVerdict::kOpen &&
         report_.verdict != OdometryVerdict::kBelieved &&
         report_.verdict != OdometryVerdict::kScaled;
}

bool OdometryTrial::is_ignored(const Pose2& step, Timestamp stamp) const {
  constexpr std::size_t kEnough = 3;
  const double seconds = seconds_between(last_->placed.stamp, stamp);
  return seconds > 0.0 && num_confirmed_jumps_ < kEnough && is_jump(step, seconds);
}

bool OdometryTrial::is_confirmed(const Pose2& step, const PlacedBase& placed) const {
  constexpr double kSame = 0.2;
  if (!last_->placed.is_certain || !placed.is_certain) return false;
  const Pose2 by_scans = last_->placed.T_odom_base.inverse() * placed.T_odom_base;
  const Pose2 off = by_scans.inverse() * step;
  return way_m(off) <= kSame * way_m(step) &&
         std::abs(off.theta_rad) <= kSame * std::max(1.0, std::abs(step.theta_rad));
}

Pose2 OdometryTrial::mended(const Pose2& step) const {
  const double way = ways_.correction();
  const double turn = turns_.correction();
  if (way == 1.0 && turn == 1.0) return step;
  return {way * step.x_m, way * step.y_m, wrap_to_pi(turn * step.theta_rad)};
}

void OdometryTrial::grow() {
  const PlacedBase& placed = last_->placed;
  if (!placed.is_certain) {
    stretch_.reset();
    return;
  }
  if (stretch_) {
    const Pose2 by_scans = stretch_->placed.T_odom_base.inverse() * placed.T_odom_base;
    const bool is_long =
        way_m(by_scans) >= params_.stretch_m || std::abs(by_scans.theta_rad) >= params_.stretch_rad;
    if (!is_long) return;
    compare(by_scans, stretch_->T_wheels_base.inverse() * last_->T_wheels_base);
  }
  stretch_ = last_;
}

void OdometryTrial::compare(const Pose2& by_scans, const Pose2& by_wheels) {
  const bool is_way = way_m(by_scans) >= params_.min_way_m;
  const double largest_turn_rad =
      std::max(std::abs(by_scans.theta_rad), is_way ? std::abs(by_wheels.theta_rad) : 0.0);
  if (is_way) ways_.add(chord(by_scans), chord(by_wheels));
  if (largest_turn_rad >= params_.min_turn_rad) {
    turns_.add({by_scans.theta_rad, 0.0}, {by_wheels.theta_rad, 0.0});
  }
  report_.way = ways_.comparison();
  report_.turn = turns_.comparison();
  report_.verdict = verdict();
  is_mended_ = is_mended_ || report_.verdict == OdometryVerdict::kScaled;
}

OdometryVerdict OdometryTrial::verdict() const {
  using Finding = MotionOnTrial::Finding;
  const auto has = [&](Finding finding) {
    return ways_.finding() == finding || turns_.finding() == finding;
  };
  if (has(Finding::kStill)) return OdometryVerdict::kStill;
  const bool is_mirrored = turns_.finding() == Finding::kFits && turns_.comparison().scale < 0.0;
  if (is_mirrored) return OdometryVerdict::kMirrored;
  const bool is_backward = ways_.finding() == Finding::kFits && ways_.comparison().scale < 0.0;
  if (has(Finding::kUnlike) || is_backward) return OdometryVerdict::kUnlike;
  const bool is_scaled = ways_.correction() != 1.0 || turns_.correction() != 1.0;
  if (is_scaled) return OdometryVerdict::kScaled;
  // Turns that fit say nothing of the ways.
  return ways_.finding() == Finding::kFits ? OdometryVerdict::kBelieved : OdometryVerdict::kOpen;
}

}  // namespace setsquare
