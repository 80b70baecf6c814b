// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/growing_map.hpp"

#include <cmath>
#include <utility>

#include "setsquare/headings/proposals.hpp"

namespace setsquare {
namespace {

void write_sensors(const SensorReports& sensors, Map& map) {
  map.scanners = sensors.scanners;
  map.gyro = sensors.gyro;
  map.odometry = sensors.odometry;
  map.sweep = sensors.sweep;
  map.num_with_odometry = sensors.num_with_odometry;
}

}  // namespace

GrowingMap::GrowingMap(const MapperParams& params)
    : params_(params), turn_checks_(params.turns), closer_(params.closing) {}

void GrowingMap::add(TrackSteps&& steps) {
  if (steps.begins_again) *this = GrowingMap(params_);
  for (TrackStep& step : steps.steps) add(std::move(step));
}

void GrowingMap::add(TrackStep&& step) {
  scans_.push_back(step.scan);
  if (step.kept) kept_scans_.push_back({scans_.size() - 1, std::move(step.kept)});
  if (!step.keyframe) return;
  add_keyframe(*step.keyframe);
  if (track_.size() < next_closing(num_closed_, params_)) return;
  const FusedHeadings headings = turn_checks_.fuse(track_, evidence_, params_.heading);
  close_loops(track_, headings.heading_rad, track_.size(), params_, closer_);
  num_closed_ = track_.size();
}

void GrowingMap::add_keyframe(const TrackedKeyframe& keyframe) {
  const TrackedPose& tracked = scans_.back().tracked;
  const bool is_first = track_.keyframes.empty();
  track_.keyframes.push_back(keyframe.keyframe);
  track_.motions.push_back(keyframe.motion);
  const bool is_restart = tracked.is_restart && !is_first;
  const bool is_tied = keyframe.motion.has_odometry;
  const std::size_t stretch = is_first ? 0 : track_.stretches.back();
  const std::size_t piece = is_first ? 0 : track_.pieces.back();
  track_.stretches.push_back(stretch + (is_restart ? 1 : 0));
  track_.pieces.push_back(piece + (is_restart && !is_tied ? 1 : 0));

  evidence_.push_back({.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
                       .step_sigma_rad = std::sqrt(keyframe.motion.rotation_rad2),
                       .proposals = heading_proposals(
                           keyframe.keyframe->scan, params_.direction, params_.confident_margin)});
  share_place(keyframe.share_of_place, evidence_.back());
}

Map GrowingMap::finish(const SensorReports& sensors) const {
  if (track_.size() == 0) {
    Map map = assemble_map({.scans = scans_, .kept_scans = kept_scans_, .track = track_});
    write_sensors(sensors, map);
    return map;
  }
  const TrackedLog log{.scans = scans_,
                       .kept_scans = kept_scans_,
                       .track = track_,
                       .evidence = evidence_,
                       .turn_checks = turn_checks_,
                       .closer = closer_,
                       .add_sensors = [&](Map& map) { write_sensors(sensors, map); }};
  return MapMaker(log, params_).make();
}

}  // namespace setsquare
