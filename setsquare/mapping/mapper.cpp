// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapped_closures.hpp"

namespace setsquare {
namespace {

/// A closure of less weight does not tell which scans see the same place.
constexpr double kMinRevisitWeight = 0.5;
/// Tracked motion is made of the scans that registration compares again.
constexpr double kTrackedMotionWeight = 0.05;
/// Of the rotation between two pieces that were joined, as matches of scans tell it.
constexpr double kJointSigma_rad = rad_from_deg(3.0);

/// What the walls said of the headings, as measurements in the map frame.
std::vector<HeadingMeasurement> heading_measurements(const FusedHeadings& headings) {
  std::vector<HeadingMeasurement> measurements;
  for (std::size_t k = 0; k < headings.heading_rad.size(); ++k) {
    if (!(headings.measured_information[k] > 0.0)) continue;
    measurements.push_back(
        {k, wrap_to_pi(headings.measured_heading_rad[k]), headings.measured_information[k]});
  }
  return measurements;
}

/// The evidence with what the joints say of the headings: pieces that were joined are turned as a
/// whole, and the rotation from one to the next is known again.
std::vector<HeadingEvidence> evidence_of_joined(std::vector<HeadingEvidence> evidence,
                                                const KeyframeTrack& track,
                                                const JoinedPieces& joined) {
  for (std::size_t k = 0; k < track.size(); ++k) {
    const std::size_t piece = track.pieces[k];
    evidence[k].tracked_heading_rad += joined.turn_rad[piece];
    const bool is_begin = k > 0 && track.pieces[k - 1] != piece;
    if (is_begin && joined.is_joined[piece] && joined.is_joined[piece - 1]) {
      evidence[k].step_sigma_rad = kJointSigma_rad;
    }
  }
  return evidence;
}

}  // namespace

void MapperParams::validate() const {
  tracker.validate();
  direction.validate();
  motion.validate();
  heading.validate();
  closing.validate();
  robust.validate();
  joining.validate();
  registration.validate();
  if (!(confident_margin > 1.0)) throw ParameterError("confident_margin", "must be above 1");
  require_not_negative(closing_growth, "closing_growth");
  require_at_least_one(min_closing_growth, "min_closing_growth");
}

Mapper::Mapper(const MapperParams& params)
    : params_(params),
      tracker_(params.tracker),
      uncertainty_(params.motion),
      closer_(params.closing) {
  params_.validate();
}

TrackedPose Mapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  scan.validate();
  std::optional<Pose2> T_wheels_sensor;
  if (T_wheels_base) T_wheels_sensor = *T_wheels_base * scan.T_base_sensor;
  const TrackedPose tracked = tracker_.track(scan, T_wheels_sensor);
  uncertainty_.add(tracked);
  scans_.push_back({scan.stamp, tracked, scan.T_base_sensor});
  if (!tracked.is_keyframe) return tracked;

  add_keyframe(scan);
  if (track_.size() >= next_closing(num_closed_)) {
    close_loops(fuse_headings(evidence_, params_.heading).heading_rad, track_.size(), closer_);
    num_closed_ = track_.size();
  }
  return tracked;
}

void Mapper::add_keyframe(const Scan& scan) {
  const TrackedPose& tracked = scans_.back().tracked;
  const bool is_first = track_.keyframes.empty();
  track_.keyframes.push_back(tracker_.submap().back());
  track_.motions.push_back(uncertainty_.take());
  const bool is_restart = tracked.is_restart && !is_first;
  const bool is_tied = track_.motions.back().has_odometry;
  const std::size_t stretch = is_first ? 0 : track_.stretches.back();
  const std::size_t piece = is_first ? 0 : track_.pieces.back();
  track_.stretches.push_back(stretch + (is_restart ? 1 : 0));
  track_.pieces.push_back(piece + (is_restart && !is_tied ? 1 : 0));

  evidence_.push_back(
      {.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
       .step_sigma_rad = std::sqrt(track_.motions.back().rotation_rad2),
       .proposals = heading_proposals(scan, params_.direction, params_.confident_margin)});
}

PoseGraph Mapper::graph_along(std::span<const double> headings_rad,
                              const LoopCloser& closer) const {
  PoseGraph graph = pose_graph_of(track_, headings_rad);
  for (const ComparedPlaces& places : closer.compared()) {
    if (is_accepted(places.verdict.reason)) graph.constraints.push_back(closure_constraint(places));
  }
  return graph;
}

void Mapper::close_loops(std::span<const double> headings_rad,
                         std::size_t num_keyframes,
                         LoopCloser& closer) const {
  PoseGraph graph = graph_along(headings_rad, closer);
  const std::vector<Eigen::Vector2d> positions_m = solve_positions(graph);
  for (std::size_t k = 0; k < positions_m.size(); ++k) {
    graph.T_map_node[k].x_m = positions_m[k].x();
    graph.T_map_node[k].y_m = positions_m[k].y();
  }
  closer.extend(track_, num_keyframes, graph.T_map_node, params_.num_threads);
}

std::size_t Mapper::next_closing(std::size_t num_closed) const {
  const auto growth =
      static_cast<std::size_t>(params_.closing_growth * static_cast<double>(num_closed));
  return num_closed + std::max(params_.min_closing_growth, growth);
}

LoopCloser Mapper::close_across_pieces(FusedHeadings& headings, JoinedPieces& joined) const {
  const PoseGraph graph = pose_graph_of(track_, headings.heading_rad);
  joined =
      join_pieces(track_, graph.T_map_node, params_.closing, params_.joining, params_.num_threads);
  headings = fuse_headings(evidence_of_joined(evidence_, track_, joined), params_.heading);
  LoopCloser closer(params_.closing);
  closer.add_joints(joined.joints);
  for (std::size_t end = 0; end < track_.size();) {
    end = std::min(next_closing(end), track_.size());
    close_loops(headings.heading_rad, end, closer);
  }
  return closer;
}

MappedTrack Mapper::finish() const {
  MappedTrack mapped;
  mapped.headings = fuse_headings(evidence_, params_.heading);
  if (track_.size() == 0) return assemble(std::move(mapped), closer_, {}, {});
  const std::vector<double>& headings_rad = mapped.headings.heading_rad;
  LoopCloser closer = closer_;
  JoinedPieces joined{.turn_rad = {0.0}, .is_joined = {true}, .joints = {}};
  if (track_.pieces.back() > 0) {
    closer = close_across_pieces(mapped.headings, joined);
  } else {
    close_loops(headings_rad, track_.size(), closer);
  }
  PoseGraph graph = graph_along(headings_rad, closer);
  graph.headings = heading_measurements(mapped.headings);
  if (track_.size() > 1) {
    solve_robustly(graph, {}, params_.robust);
    register_all(closer, graph);
  }
  // Neighbours err alike: so many measurements tell no more than one. Registration takes each for
  // its own, which serves the poses; what is certain is told by this graph.
  for (HeadingMeasurement& heading : graph.headings) {
    heading.information_per_rad2 /= params_.heading.num_alike;
  }
  return assemble(std::move(mapped), closer, graph, joined);
}

void Mapper::register_all(const LoopCloser& closer, PoseGraph& graph) const {
  // Registration compares the places that closures tell again. Beside its own comparisons it relies
  // on the tracked motion, made of the same scans, for little, and on the other closures.
  PoseGraph to_register{
      .T_map_node = graph.T_map_node, .constraints = {}, .headings = graph.headings};
  std::vector<Constraint> revisits;
  std::size_t next = track_.size() - 1;  // behind the tracked motions stand the closures
  for (std::size_t k = 0; k < next; ++k) {
    to_register.constraints.push_back(graph.constraints[k]);
    to_register.constraints.back().weight *= kTrackedMotionWeight;
  }
  for (const ComparedPlaces& places : closer.compared()) {
    if (!is_accepted(places.verdict.reason)) continue;
    const Constraint& closure = graph.constraints[next++];
    if (places.verdict.axes == ClosureAxes::kXY && closure.weight >= kMinRevisitWeight) {
      revisits.push_back(closure);
    } else {
      to_register.constraints.push_back(closure);
    }
  }
  register_keyframes(track_, revisits, to_register, params_.registration, params_.num_threads);
  graph.T_map_node = std::move(to_register.T_map_node);
}

MappedTrack Mapper::assemble(MappedTrack mapped,
                             const LoopCloser& closer,
                             const PoseGraph& graph,
                             const JoinedPieces& joined) const {
  std::vector<MappedKeyframe> keyframes;
  for (std::size_t k = 0; k < track_.size(); ++k) {
    const bool begins_piece = k > 0 && track_.pieces[k] != track_.pieces[k - 1];
    keyframes.push_back({track_.keyframes[k]->scan_index, graph.T_map_node[k], begins_piece});
    mapped.keyframes.push_back(track_.keyframes[k]->scan_index);
  }
  std::vector<Pose2> T_odom_sensor;
  T_odom_sensor.reserve(scans_.size());
  for (const ScanEntry& entry : scans_) T_odom_sensor.push_back(entry.tracked.T_odom_sensor);
  const std::vector<Pose2> T_map_sensor = assemble_track(T_odom_sensor, keyframes);
  mapped.scans.reserve(scans_.size());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const ScanEntry& entry = scans_[i];
    mapped.scans.push_back({.stamp = entry.stamp,
                            .status = entry.tracked.status,
                            .T_map_sensor = T_map_sensor[i],
                            .T_map_base = T_map_sensor[i] * entry.T_base_sensor.inverse(),
                            .score = entry.tracked.score,
                            .effective_points = entry.tracked.open.effective_points,
                            .has_odometry = entry.tracked.has_odometry});
  }
  mapped.pieces = pieces_of(track_, joined.is_joined, scans_.size());
  mapped.closures = mapped_closures(track_, closer.compared(), graph);
  mapped.graph = graph_of_base(track_, graph);
  return mapped;
}

}  // namespace setsquare
