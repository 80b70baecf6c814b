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

/// Standard error of a median, by the deviations from it.
double standard_error(std::vector<double> values, double middle) {
  constexpr double kOfNormal = 1.25 * 1.48;  // Of the median's; from a median deviation.
  const auto root_num = std::sqrt(static_cast<double>(values.size()));
  for (double& value : values) value = std::abs(value - middle);
  return kOfNormal * median(std::move(values)) / root_num;
}

}  // namespace

bool sees_all_around(const Scan& scan) { return scan.field_of_view_rad() > kAllAround_rad; }

SweepTrial::SweepTrial(const ScanTrackerParams& params)
    : params_(params.deskew.trial), tracker_(without_expectation(params)) {}

void SweepTrial::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  if (!is_open()) return;
  ++num_scans_;
  (void)repeated_.add(scan, T_wheels_base);
  if (repeated_.is_same()) return;  // It swept when it came first.
  const double period_s = last_stamp_ ? seconds_between(*last_stamp_, scan.stamp) : 0.0;
  last_stamp_ = scan.stamp;
  Scan swept = scan;
  swept.time_increment_s = 0.0;
  const bool is_next = period_s > 0.0 && period_s < params_.max_period_s && scan.num_beams() > 1;
  if (is_next) swept.time_increment_s = period_s / static_cast<double>(scan.num_beams() - 1);
  const TrackedPose tracked = tracker_.track(swept, T_wheels_base);
  const Observed now{tracked.status == TrackStatus::kTracked && tracked.score > params_.min_score,
                     tracked.T_odom_sensor.theta_rad,
                     tracker_.sweep_motion()};
  if (is_next) {
    periods_s_.push_back(period_s);
    compare(last_, now);
    judge(scan.num_beams());
  }
  last_ = now;
}

void SweepTrial::compare(const Observed& last, const Observed& now) {
  if (!last.is_tracked || !now.is_tracked) return;
  const double turn_rad = wrap_to_pi(now.heading_rad - last.heading_rad);
  if (std::abs(turn_rad) < params_.min_turn_rad) return;
  shares_.push_back((last.motion.turn_after_rad + now.motion.turn_before_rad) / turn_rad);
}

void SweepTrial::judge(std::size_t num_beams) {
  if (shares_.size() < params_.min_turns) return;
  const double share = median(shares_);
  const double doubt = params_.num_sigmas * standard_error(shares_, share);
  if (std::abs(share) + doubt < params_.max_share_at_once) {
    sweep_s_ = 0.0;
  } else if (std::abs(share) - doubt > params_.min_share) {
    const bool is_whole = std::abs(std::abs(share) - 1.0) < params_.max_off_whole;
    const double whole = 1.0 - 1.0 / static_cast<double>(num_beams);
    sweep_s_ = (is_whole ? std::copysign(whole, share) : share) * median(periods_s_);
  }
}

}  // namespace setsquare
