// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/mapper.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "setsquare/slam/track_assembly.hpp"

namespace setsquare {

void MapperParams::validate() const {
  tracker.validate();
  direction.validate();
  heading.validate();
  if (!(rotation.step_sigma_rad > 0.0)) {
    throw ParameterError("step_sigma_rad", "must be positive");
  }
  if (!(confident_margin > 1.0)) throw ParameterError("confident_margin", "must be above 1");
}

Mapper::Mapper(const MapperParams& params) : params_(params), tracker_(params.tracker) {
  params_.validate();
}

TrackedPose Mapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  scan.validate();
  std::optional<Pose2> T_wheels_sensor;
  if (T_wheels_base) T_wheels_sensor = *T_wheels_base * scan.T_base_sensor;
  const TrackedPose tracked = tracker_.track(scan, T_wheels_sensor);
  const TrackedRotationParams& rotation = params_.rotation;
  if (tracked.status == TrackStatus::kLost) {
    step_variance_rad2_ += rotation.lost_sigma_rad * rotation.lost_sigma_rad;
  } else if (tracked.status == TrackStatus::kRecovered) {
    step_variance_rad2_ += rotation.recovered_sigma_rad * rotation.recovered_sigma_rad;
  }
  if (tracked.is_restart) {
    step_variance_rad2_ += rotation.restart_sigma_rad * rotation.restart_sigma_rad;
  }
  if (tracked.is_keyframe) measure_heading(scan, tracked);
  tracked_.push_back({scan.stamp, tracked, scan.T_base_sensor});
  return tracked;
}

void Mapper::measure_heading(const Scan& scan, const TrackedPose& tracked) {
  HeadingEvidence evidence{.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
                           .step_sigma_rad = 0.0,
                           .proposals = {}};
  if (!keyframes_.empty()) {
    const TrackedRotationParams& rotation = params_.rotation;
    const double turn_rad =
        std::abs(wrap_to_pi(evidence.tracked_heading_rad -
                            tracked_[keyframes_.back()].tracked.T_odom_sensor.theta_rad));
    const double sigma_rad = rotation.step_sigma_rad + rotation.sigma_per_turn * turn_rad;
    evidence.step_sigma_rad = std::sqrt(sigma_rad * sigma_rad + step_variance_rad2_);
  }
  const SquareDirections directions =
      square_directions(points_from_scan(scan), scan.bearing_step_rad, params_.direction);
  const double confidence =
      std::clamp((directions.margin() - 1.0) / (params_.confident_margin - 1.0), 0.0, 1.0);
  if (!directions.peaks.empty() && confidence > 0.0) {
    const SquareDirection& peak = directions.peaks.front();
    evidence.proposals.push_back({peak.theta_rad, peak.sigma_rad, confidence});
  }
  evidence_.push_back(std::move(evidence));
  keyframes_.push_back(tracked_.size());
  step_variance_rad2_ = 0.0;
}

MappedTrack Mapper::finish() const {
  MappedTrack track;
  track.keyframes = keyframes_;
  track.headings = fuse_headings(evidence_, params_.heading);
  std::vector<DriftAtScan> drifts;
  for (std::size_t k = 0; k < keyframes_.size(); ++k) {
    drifts.push_back({keyframes_[k], track.headings.drift_rad[k]});
  }
  std::vector<Pose2> T_odom_sensor;
  T_odom_sensor.reserve(tracked_.size());
  for (const Entry& entry : tracked_) T_odom_sensor.push_back(entry.tracked.T_odom_sensor);
  const std::vector<Pose2> T_map_sensor = assemble_track(T_odom_sensor, drifts);

  track.scans.reserve(tracked_.size());
  for (std::size_t i = 0; i < tracked_.size(); ++i) {
    const Entry& entry = tracked_[i];
    track.scans.push_back({.stamp = entry.stamp,
                           .status = entry.tracked.status,
                           .T_map_sensor = T_map_sensor[i],
                           .T_map_base = T_map_sensor[i] * entry.T_base_sensor.inverse(),
                           .score = entry.tracked.score,
                           .effective_points = entry.tracked.weak.effective_points});
  }
  return track;
}

}  // namespace setsquare
