// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/paper_mapper.hpp"

#include <memory>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/is_beyond.hpp"

namespace setsquare {

void PaperMapperParams::validate() const {
  matcher.validate();
  if (!(keyframe_distance_m > 0.0)) {
    throw ParameterError("keyframe_distance_m", "must be positive");
  }
  if (!(keyframe_turn_rad > 0.0)) throw ParameterError("keyframe_turn_rad", "must be positive");
  if (max_rejected < 1) throw ParameterError("max_rejected", "must be at least 1");
  if (min_points < 1) throw ParameterError("min_points", "must be at least 1");
}

PaperMapper::PaperMapper(const PaperMapperParams& params) : params_(params) { params_.validate(); }

TrackedPose PaperMapper::add(const Scan& scan) {
  scan.validate();
  return add(scan, prepare_paper(scan, params_.matcher));
}

TrackedPose PaperMapper::add(const Scan& scan, PreparedPaperScan current) {
  const TrackedPose tracked = place(current);
  if (tracked.is_keyframe) {
    keyframe_ = std::move(current);
    T_map_keyframe_ = T_map_sensor_;
    num_rejected_ = 0;
    map_.keyframes.push_back(map_.scans.size());
  }
  map_.scans.push_back({.stamp = scan.stamp,
                        .status = tracked.status,
                        .T_map_sensor = T_map_sensor_,
                        .T_map_base = T_map_sensor_ * scan.T_base_sensor.inverse(),
                        .score = tracked.score});
  if (kept_.takes(tracked, scan.scanner)) {
    map_.kept_scans.push_back({map_.scans.size() - 1, std::make_shared<const Scan>(scan)});
  }
  return tracked;
}

TrackedPose PaperMapper::place(const PreparedPaperScan& current) {
  TrackedPose tracked;
  if (current.points.size() < params_.min_points) {
    tracked.status = TrackStatus::kLost;
    tracked.score = 0.0;
  } else if (!keyframe_) {
    // Eq. (8): theta_D is the heading against the building's walls.
    T_map_sensor_.theta_rad = wrap_to_period(current.direction.theta_rad, 0.5 * kPi);
    tracked.is_keyframe = true;
  } else {
    follow(match_paper(*keyframe_, current, params_.matcher), current, tracked);
  }
  tracked.T_odom_sensor = T_map_sensor_;
  tracked.T_odom_body = T_map_sensor_;
  return tracked;
}

void PaperMapper::follow(const MatchResult& match,
                         const PreparedPaperScan& current,
                         TrackedPose& tracked) {
  tracked.score = match.score;
  if (match.status == MatchStatus::kMatched) {
    num_rejected_ = 0;
    const Pose2& moved = *match.T_reference_current;
    T_map_sensor_ = T_map_keyframe_ * moved;
    tracked.is_keyframe = is_beyond(moved, params_.keyframe_distance_m, params_.keyframe_turn_rad);
    return;
  }
  tracked.status = TrackStatus::kLost;
  tracked.is_keyframe = ++num_rejected_ >= params_.max_rejected;
  if (tracked.is_keyframe) T_map_sensor_.theta_rad = measured_heading_rad(current);
}

/// Eq. (8) without a match: theta_D gives the heading modulo a quarter turn, the last heading the
/// rest.
double PaperMapper::measured_heading_rad(const PreparedPaperScan& current) const {
  const double turn_rad = current.direction.theta_rad - keyframe_->direction.theta_rad;
  const double change_rad = T_map_keyframe_.theta_rad + turn_rad - T_map_sensor_.theta_rad;
  return wrap_to_pi(T_map_sensor_.theta_rad + wrap_to_period(change_rad, 0.5 * kPi));
}

Map PaperMapper::finish() const { return map_; }

}  // namespace setsquare
