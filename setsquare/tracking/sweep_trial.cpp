// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/sweep_trial.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/tracking/deskew.hpp"

namespace setsquare {
namespace {

constexpr double kAllAround_rad = rad_from_deg(350.0);

ScanTrackerParams without_expectation(ScanTrackerParams params) {
  params.deskew.is_on = true;
  params.deskew.is_sweep_known = false;
  return params;
}

double deviation(std::vector<double> values, double middle) {
  for (double& value : values) value = std::abs(value - middle);
  return median(std::move(values));
}

}  // namespace

bool sees_all_around(const Scan& scan) { return scan.field_of_view_rad() > kAllAround_rad; }

SweepTrial::SweepTrial(const ScanTrackerParams& params)
    : params_(params.deskew.trial), tracker_(without_expectation(params)) {}

void SweepTrial::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  if (!is_open()) return;
  ++num_scans_;
  const double period_s = last_stamp_ ? seconds_between(*last_stamp_, scan.stamp) : 0.0;
  last_stamp_ = scan.stamp;
  Scan swept = scan;
  swept.time_increment_s = 0.0;
  const bool is_next = period_s > 0.0 && period_s < params_.max_period_s && scan.num_beams() > 1;
  if (is_next) swept.time_increment_s = period_s / static_cast<double>(scan.num_beams() - 1);
  const TrackedPose tracked = tracker_.track(swept, T_wheels_base);
  if (!is_next) observed_.clear();
  const SweepMotion& motion = tracker_.sweep_motion();
  observed_.push_back({tracked.status == TrackStatus::kTracked && tracked.score > params_.min_score,
                       tracked.T_odom_sensor.theta_rad,
                       motion.turn_before_rad + motion.turn_after_rad});
  if (!is_next) return;
  periods_s_.push_back(period_s);
  compare();
  judge(scan.num_beams());
}

void SweepTrial::compare() {
  if (observed_.size() > 3) observed_.pop_front();
  if (observed_.size() < 3) return;
  for (const Observed& scan : observed_) {
    if (!scan.is_tracked) return;
  }
  // From scan to scan, so that none is wrapped.
  const double turn_rad = 0.5 * (wrap_to_pi(observed_[1].heading_rad - observed_[0].heading_rad) +
                                 wrap_to_pi(observed_[2].heading_rad - observed_[1].heading_rad));
  if (std::abs(turn_rad) < params_.min_turn_rad) return;
  shares_.push_back(observed_[1].turn_in_sweep_rad / turn_rad);
}

void SweepTrial::judge(std::size_t num_beams) {
  if (shares_.size() < params_.min_turns) return;
  const double share = median(shares_);
  if (deviation(shares_, share) > params_.max_deviation) return;
  if (std::abs(share) < params_.max_share_at_once) {
    sweep_s_ = 0.0;
  } else if (std::abs(share) > params_.min_share) {
    const bool is_whole = std::abs(std::abs(share) - 1.0) < params_.max_off_whole;
    const double whole = 1.0 - 1.0 / static_cast<double>(num_beams);
    sweep_s_ = (is_whole ? std::copysign(whole, share) : share) * median(periods_s_);
  }
}

}  // namespace setsquare
