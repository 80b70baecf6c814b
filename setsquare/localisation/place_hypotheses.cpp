// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/finite_pose.hpp"
#include "setsquare/core/sort_by.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/place_covariance.hpp"
#include "setsquare/localisation/place_probability.hpp"
#include "setsquare/localisation/view_probability.hpp"

namespace setsquare {
namespace {

/// How tracking drifts: its variance grows with the way and with the turns.
constexpr double kDrift_m = 0.02;                      // Per root of a metre.
constexpr double kDrift_rad = rad_from_deg(0.3);       // Likewise.
constexpr double kTurnDrift_rad = rad_from_deg(1.0);   // Per root of a radian.
constexpr double kLostDrift_m = 0.5;                   // Of a scan that tracking has lost.
constexpr double kLostDrift_rad = rad_from_deg(10.0);  // Likewise.

/// Of a place against "elsewhere", below which it is not followed.
constexpr double kLeastLogOdds = -6.0;

bool has_moved(const Pose2& from, const Pose2& to, double way_m, double turn_rad) {
  return (to.translation() - from.translation()).norm() >= way_m ||
         std::abs(wrap_to_pi(to.theta_rad - from.theta_rad)) >= turn_rad;
}

/// Whether most of the wall that a scan shows, and of that which is expected, lies where the map
/// knows nothing: it speaks neither for the place nor against it.
bool is_outside_map(const VerifiedPlace& place) {
  constexpr double kMost = 0.6;
  const WallKinds& seen = place.kinds.forward;
  return seen.outside_m > kMost * seen.wall_m;
}

}  // namespace

PlaceHypotheses::PlaceHypotheses(std::shared_ptr<const KnownMap> map,
                                 const LocalisationParams& params)
    : map_(std::move(map)), params_(params) {
  if (map_ == nullptr) throw ParameterError("map", "must be given");
  params_.validate();
}

void PlaceHypotheses::set_pose(const Pose2& T_map_base) {
  require_finite_pose(T_map_base, "T_map_base");
  said_ = T_map_base;
}

void PlaceHypotheses::Hypothesis::hear(double said_log_odds, bool is_judged) {
  if (!is_judged && said_log_odds > 0.0) {
    said_log_odds = std::min(said_log_odds, kUnsure - unjudged_log_odds);
    unjudged_log_odds += said_log_odds;
  }
  log_odds += said_log_odds;
}

void PlaceHypotheses::move(const TrackedPose& tracked) {
  const Pose2 step = T_odom_sensor_.inverse() * tracked.T_odom_sensor;
  const double way_m = step.translation().norm();
  const double turn_rad = std::abs(wrap_to_pi(step.theta_rad));
  const bool is_lost = tracked.status == TrackStatus::kLost;
  double variance_m2 = kDrift_m * kDrift_m * way_m;
  double variance_rad2 =
      kDrift_rad * kDrift_rad * way_m + kTurnDrift_rad * kTurnDrift_rad * turn_rad;
  if (is_lost) {
    variance_m2 += kLostDrift_m * kLostDrift_m;
    variance_rad2 += kLostDrift_rad * kLostDrift_rad;
  }
  for (Hypothesis& hypothesis : hypotheses_) {
    const Pose2 before = hypothesis.T_grid_odom * T_odom_sensor_;
    const Pose2 after = hypothesis.T_grid_odom * tracked.T_odom_sensor;
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(0, 2) = -(after.y_m - before.y_m);
    F(1, 2) = after.x_m - before.x_m;
    Eigen::Matrix3d& covariance = hypothesis.covariance;
    covariance = F * covariance * F.transpose();
    covariance.diagonal() += Eigen::Vector3d(variance_m2, variance_m2, variance_rad2);
    if (tracked.status == TrackStatus::kDegenerate) {
      // Nothing but the prediction tells how far it went along the walls.
      const double sigma_m = std::max(tracked.open_sigma_m, 0.2 * way_m);
      const Eigen::Vector2d along =
          rotation_matrix(hypothesis.T_grid_odom.theta_rad) * tracked.open.direction;
      covariance.topLeftCorner<2, 2>() += sigma_m * sigma_m * along * along.transpose();
    }
  }
  unconfirmed_m_ += way_m;
  certain_m_ += way_m;
  T_odom_sensor_ = tracked.T_odom_sensor;
}

void PlaceHypotheses::weigh(const SoughtScan& sought, double weight, bool searches) {
  std::vector<VerifiedPlace> places;
  for (const Hypothesis& hypothesis : hypotheses_) {
    places.push_back(verified_place(*map_, sought, hypothesis.T_grid_odom * T_odom_sensor_));
  }
  const std::size_t num_before = hypotheses_.size();
  if (searches) {
    for (const VerifiedPlace& place : search_places(*map_, sought, params_.search)) {
      places.push_back(place);
    }
  }
  if (places.empty()) return;
  const PlaceScale scale = place_scale(places, searches);
  std::vector<double> log_odds;
  std::vector<SeenByViews> seen(places.size());
  if (searches && !map_->views().empty() && !is_certain()) {
    seen = seen_by_views(map_->views(), sought.prepared, places);
    log_odds = log_odds_by_views(places, seen);
  } else {
    for (const VerifiedPlace& place : places) log_odds.push_back(place_log_odds(place, scale));
  }
  const auto is_judged = [&](std::size_t i) {
    return places[i].unjudged_share <= kMaxUnjudged || seen[i].num_views > 0;
  };
  std::vector<Hypothesis> found;
  for (std::size_t i = num_before; i < places.size(); ++i) {
    if (log_odds[i] < kLeastLogOdds) continue;
    if (!is_another_place(places[i], log_odds[i], std::span(log_odds).first(num_before))) continue;
    Hypothesis hypothesis{.T_grid_odom = places[i].T_grid_sensor * T_odom_sensor_.inverse(),
                          .covariance = covariance_of(places[i])};
    hypothesis.log_odds = log_odds_of_past(hypothesis);
    hypothesis.hear(weight * log_odds[i], is_judged(i));
    found.push_back(hypothesis);
  }
  for (std::size_t i = 0; i < num_before; ++i) {
    Hypothesis& hypothesis = hypotheses_[i];
    if (!is_outside_map(places[i])) hypothesis.hear(weight * log_odds[i], is_judged(i));
    if (log_odds[i] <= 0.0) continue;
    fix(places[i], hypothesis);
    if (i == 0) {
      is_confirmed_ = true;
      unconfirmed_m_ = 0.0;
    }
  }
  hypotheses_.insert(hypotheses_.end(), found.begin(), found.end());
  if (weight == 0.0) return;
  if (past_.size() == kMaxPast) past_.erase(past_.begin());
  past_.push_back({sought, T_odom_sensor_, scale, weight});
}

bool PlaceHypotheses::is_another_place(const VerifiedPlace& place,
                                       double log_odds,
                                       std::span<const double> log_odds_of_hypotheses) const {
  // The walls about the right place show others that fit a little less.
  constexpr double kBeside_m = 1.0;
  constexpr double kBeside_rad = rad_from_deg(20.0);
  constexpr double kClearlyBetter = 2.0;
  for (std::size_t i = 0; i < log_odds_of_hypotheses.size(); ++i) {
    const Pose2 T = hypotheses_[i].T_grid_odom * T_odom_sensor_;
    if (is_one_place(T, place.T_grid_sensor)) return false;
    const bool is_beside = !has_moved(T, place.T_grid_sensor, kBeside_m, kBeside_rad);
    if (is_beside && log_odds < log_odds_of_hypotheses[i] + kClearlyBetter) return false;
  }
  return true;
}

double PlaceHypotheses::log_odds_of_past(const Hypothesis& hypothesis) const {
  double against_elsewhere = 0.0;
  double against_best = hypotheses_.empty() ? 0.0 : hypotheses_.front().log_odds;
  for (const PastScan& past : past_) {
    const VerifiedPlace place =
        verified_place(*map_, past.scan, hypothesis.T_grid_odom * past.T_odom_sensor);
    if (is_outside_map(place)) continue;
    const double log_odds = past.weight * place_log_odds(place, past.scale);
    against_elsewhere += log_odds;
    against_best += log_odds - past.weight * past.scale.presence;
  }
  return hypotheses_.empty() ? against_elsewhere : std::min(against_elsewhere, against_best);
}

void PlaceHypotheses::fix(const VerifiedPlace& place, Hypothesis& hypothesis) {
  const Pose2 predicted = hypothesis.T_grid_odom * T_odom_sensor_;
  const Eigen::Matrix3d information = information_of(place);
  const Eigen::Matrix3d before = hypothesis.covariance.inverse();
  hypothesis.covariance = (before + information).inverse();
  const Eigen::Vector3d apart(place.T_grid_sensor.x_m - predicted.x_m,
                              place.T_grid_sensor.y_m - predicted.y_m,
                              wrap_to_pi(place.T_grid_sensor.theta_rad - predicted.theta_rad));
  const Eigen::Vector3d change = hypothesis.covariance * information * apart;
  const Pose2 fixed{predicted.x_m + change.x(),
                    predicted.y_m + change.y(),
                    wrap_to_pi(predicted.theta_rad + change.z())};
  hypothesis.T_grid_odom = fixed * T_odom_sensor_.inverse();
}

void PlaceHypotheses::believe_said(const Scan& scan, const SoughtScan& sought) {
  constexpr double kNear_m = 1.5;
  constexpr double kNear_rad = rad_from_deg(40.0);
  constexpr double kBelief = 5.0;  // Log odds of being told.
  const Pose2 said = map_->T_map_grid().inverse() * *said_ * scan.T_base_sensor;
  said_.reset();
  hypotheses_.clear();
  past_.clear();
  has_weighed_ = false;
  weigh(sought, 1.0, true);
  const auto is_near = [&](const Hypothesis& hypothesis) {
    return !has_moved(said, hypothesis.T_grid_odom * T_odom_sensor_, kNear_m, kNear_rad);
  };
  if (std::ranges::any_of(hypotheses_, is_near)) {
    std::erase_if(hypotheses_, std::not_fn(is_near));
    for (Hypothesis& hypothesis : hypotheses_) hypothesis.log_odds += kBelief;
    return;
  }
  // The scan fits nowhere near: what is said is one place among those that it fits.
  const VerifiedPlace place = verified_place(*map_, sought, said);
  Hypothesis told{.T_grid_odom = said * T_odom_sensor_.inverse(),
                  .log_odds = kBelief + presence_log_odds(place_features(place))};
  told.covariance.diagonal() << 0.25, 0.25, 0.07;
  hypotheses_.push_back(told);
}

void PlaceHypotheses::drop_unlikely() {
  constexpr double kFarBehind = 9.0;  // Against the best one.
  if (hypotheses_.empty()) return;
  sort_by_greatest(hypotheses_, &Hypothesis::log_odds);
  const double excess = hypotheses_.front().log_odds - params_.max_log_odds;
  if (excess > 0.0) {
    for (Hypothesis& hypothesis : hypotheses_) hypothesis.log_odds -= excess;
  }
  const double floor = std::max(kLeastLogOdds, hypotheses_.front().log_odds - kFarBehind);
  std::erase_if(hypotheses_,
                [&](const Hypothesis& hypothesis) { return hypothesis.log_odds < floor; });
  // Two that came to one place are one.
  std::vector<Hypothesis> different;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const bool is_known = std::ranges::any_of(different, [&](const Hypothesis& other) {
      return is_one_place(other.T_grid_odom * T_odom_sensor_,
                          hypothesis.T_grid_odom * T_odom_sensor_);
    });
    if (!is_known) different.push_back(hypothesis);
  }
  hypotheses_ = std::move(different);
}

std::vector<double> PlaceHypotheses::probabilities() const {
  std::vector<double> log_odds;
  for (const Hypothesis& hypothesis : hypotheses_) log_odds.push_back(hypothesis.log_odds);
  return place_probabilities(log_odds);
}

bool PlaceHypotheses::is_certain() const {
  return !hypotheses_.empty() && probabilities().front() >= params_.min_probability;
}

LocalisedPose PlaceHypotheses::answer(const Scan& scan) const {
  LocalisedPose pose;
  pose.stamp = scan.stamp;
  pose.unconfirmed_m = unconfirmed_m_;
  pose.is_confirmed = is_confirmed_;
  if (hypotheses_.empty()) return pose;
  const std::vector<double> shares = probabilities();
  // How far the map's walls are off just there is the same for all scans: it does not average out.
  constexpr double kWalls_m = 0.015;
  constexpr double kWalls_rad = rad_from_deg(0.2);
  const Eigen::Matrix3d walls_own =
      Eigen::Vector3d(kWalls_m * kWalls_m, kWalls_m * kWalls_m, kWalls_rad * kWalls_rad)
          .asDiagonal();
  double in_map = 0.0;
  constexpr double kLeast = 0.001;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    in_map += shares[i];
    const PossiblePlace place{
        map_->T_map_grid() * hypotheses_[i].T_grid_odom * T_odom_sensor_,
        shares[i],
        turned_covariance(hypotheses_[i].covariance + walls_own, map_->T_map_grid().theta_rad)};
    if (i == 0) {
      pose.T_map_sensor = place.T_map_sensor;
      pose.T_map_base = place.T_map_sensor * scan.T_base_sensor.inverse();
      pose.probability = place.probability;
      pose.covariance = place.covariance;
    } else if (place.probability >= kLeast) {
      pose.alternatives.push_back(place);
    }
  }
  pose.status = status_of(pose.probability, params_.min_probability, in_map, params_);
  if (unconfirmed_m_ > params_.max_unconfirmed_m) pose.status = LocalisationStatus::kLost;
  return pose;
}

LocalisedPose PlaceHypotheses::add(const TrackedPose& tracked, const Scan& scan) {
  const bool is_first = num_scans_++ == 0;
  if (is_first) T_odom_sensor_ = tracked.T_odom_sensor;
  if (tracked.is_restart && !is_first && !tracked.has_odometry) {
    // Where it went meanwhile is not known: begin anew.
    hypotheses_.clear();
    past_.clear();
    has_weighed_ = false;
  }
  move(tracked);
  is_confirmed_ = false;

  const bool was_certain = is_certain() && unconfirmed_m_ <= params_.max_unconfirmed_m;
  // Places that look as well may have been missed so far.
  const bool is_settled = was_certain && certain_m_ > params_.settled_m;
  const bool is_evidence =
      !has_weighed_ || said_ ||
      has_moved(T_odom_weighed_, T_odom_sensor_, params_.evidence_m, params_.evidence_rad);
  const bool is_fix =
      is_evidence ||
      (was_certain && has_moved(T_odom_fixed_, T_odom_sensor_, params_.fix_m, params_.fix_rad));
  if (!is_fix) return answer(scan);

  const SoughtScan sought = sought_scan(scan);
  constexpr std::size_t kFewest = 10;
  if (sought.prepared.points().size() < kFewest) return answer(scan);
  T_odom_fixed_ = T_odom_sensor_;
  if (said_) {
    believe_said(scan, sought);
  } else {
    const double weight = !has_weighed_ ? 1.0 : is_evidence ? params_.evidence_weight : 0.0;
    weigh(sought, weight, is_evidence && !is_settled);
  }
  if (!is_certain()) certain_m_ = 0.0;
  if (is_evidence) {
    T_odom_weighed_ = T_odom_sensor_;
    has_weighed_ = true;
  }
  drop_unlikely();
  return answer(scan);
}

}  // namespace setsquare
