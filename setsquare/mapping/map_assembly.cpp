// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/map_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/matching/base_frame.hpp"

namespace setsquare {
namespace {

/// Which axes of the final map a closure binds: the map may have turned since it was judged.
ClosureAxes axes_of(const ComparedPlaces& places, const PoseGraph& graph) {
  if (places.verdict.reason != ClosureReason::kOneAxis) return places.verdict.axes;
  const Eigen::Matrix2d bound = places.information.topLeftCorner<2, 2>();
  const Eigen::Vector2d open = open_direction(bound).direction;
  return axis_across(std::atan2(open.y(), open.x()) + graph.T_map_node[places.from].theta_rad);
}

std::vector<MapSession> sessions_of(const MapParts& parts) {
  if (!parts.sessions.empty()) return {parts.sessions.begin(), parts.sessions.end()};
  if (parts.num_scans == 0) return {};
  return {{.first_scan = 0, .num_scans = parts.num_scans, .search = {}}};
}

/// Appends the scans that hang on keyframes and come before `end_scan`, from the `next` one on.
void append_hung(const MapParts& parts,
                 std::size_t end_scan,
                 std::size_t first_scan,
                 std::size_t& next,
                 std::vector<MappedKeyframe>& keyframes) {
  for (; next < parts.hung_scans.size() && parts.hung_scans[next].scan_index < end_scan; ++next) {
    const auto& [scan_index, reference_scan, T_reference_this] = parts.hung_scans[next];
    const std::size_t reference = keyframe_of_scan(parts.track, reference_scan);
    keyframes.push_back(
        {scan_index - first_scan, parts.graph.T_map_node[reference] * T_reference_this, false});
  }
}

/// Session by session: what one saw says nothing of where another one's scans lie.
std::vector<Pose2> poses_of_scans(const MapParts& parts, const std::vector<MapSession>& sessions) {
  const KeyframeTrack& track = parts.track;
  std::vector<Pose2> T_map_sensor;
  T_map_sensor.reserve(parts.num_scans);
  std::size_t k = 0;
  std::size_t next_hung = 0;
  for (const MapSession& session : sessions) {
    const std::size_t end = session.first_scan + session.num_scans;
    std::vector<MappedKeyframe> keyframes;
    for (; k < track.size() && track.keyframes[k]->scan_index < end; ++k) {
      const bool begins_piece = k > 0 && track.pieces[k] != track.pieces[k - 1];
      append_hung(parts, track.keyframes[k]->scan_index, session.first_scan, next_hung, keyframes);
      keyframes.push_back({track.keyframes[k]->scan_index - session.first_scan,
                           parts.graph.T_map_node[k],
                           begins_piece});
    }
    std::vector<Pose2> T_odom_sensor;
    T_odom_sensor.reserve(session.num_scans);
    for (std::size_t i = session.first_scan; i < end; ++i) {
      T_odom_sensor.push_back(parts.scans.T_odom_sensor(i));
    }
    const std::vector<Pose2> of_session = assemble_track(T_odom_sensor, keyframes);
    T_map_sensor.insert(T_map_sensor.end(), of_session.begin(), of_session.end());
  }
  return T_map_sensor;
}

/// What the map keeps of the track, to go on with.
void add_track(const MapParts& parts, Map& map) {
  const KeyframeTrack& track = parts.track;
  map.track.T_odom_sensor.reserve(parts.num_scans);
  for (std::size_t i = 0; i < parts.num_scans; ++i) {
    map.track.T_odom_sensor.push_back(parts.scans.T_odom_sensor(i));
  }
  for (std::size_t k = 0; k < track.size(); ++k) {
    map.track.motions.push_back(
        {.T_odom_body = track.keyframes[k]->T_odom_body,
         .covariance = track.motions[k],
         .stretch = track.stretches[k],
         .share_of_place = parts.shares_of_place.empty() ? 1.0 : parts.shares_of_place[k]});
  }
}

/// Whether the robot went farther, or turned more, from one scan to another than it would in a
/// step.
bool has_moved(const TrackedScan& from, const TrackedScan& to, const Pose2& step) {
  constexpr double kMoved_m = 0.1;
  constexpr double kMoved_rad = rad_from_deg(2.0);
  constexpr double kSteps = 1.5;
  const Pose2 moved = from.T_odom_sensor.inverse() * to.T_odom_sensor;
  return is_beyond(moved,
                   std::max(kMoved_m, kSteps * std::hypot(step.x_m, step.y_m)),
                   std::max(kMoved_rad, kSteps * std::abs(step.theta_rad)));
}

/// How far the robot would go from the last repeat of a scan to the next scan, `end`, as fast as it
/// was before the scan that is repeated from `first` on.
Pose2 step_behind(const TrackedScans& scans, std::size_t first, std::size_t end) {
  const std::size_t repeated = first - 1;
  std::size_t before = repeated;
  if (before > 0) --before;
  while (before > 0 && scans.is_same_again(before)) --before;
  const Pose2 step = scans.T_odom_sensor(before).inverse() * scans.T_odom_sensor(repeated);
  const double step_s = seconds_between(scans.stamp(before), scans.stamp(repeated));
  const double behind_s = seconds_between(scans.stamp(end - 1), scans.stamp(end));
  const double share = step_s > 0.0 && behind_s > 0.0 ? std::min(1.0, behind_s / step_s) : 1.0;
  return {share * step.x_m, share * step.y_m, share * step.theta_rad};
}

/// Repeated scans that tell nothing of where the robot was: behind them it is elsewhere, or nothing
/// is, for seconds. Where it is found where it was, it stood, and its scanner has no noise.
std::vector<bool> unseen_repeats(const TrackedScans& scans, std::size_t num_scans) {
  constexpr double kLongest_s = 3.0;
  std::vector<bool> is_unseen(num_scans, false);
  for (std::size_t first = 1; first < num_scans; ++first) {
    if (!scans.is_same_again(first)) continue;
    std::size_t end = first;
    while (end < num_scans && scans.is_same_again(end)) ++end;
    bool is_unknown = seconds_between(scans.stamp(first), scans.stamp(end - 1)) > kLongest_s;
    if (end < num_scans) {
      const TrackedScan behind = scans[end];
      is_unknown = behind.status == TrackStatus::kLost || behind.is_restart ||
                   has_moved(scans[first], behind, step_behind(scans, first, end));
    }
    std::fill_n(is_unseen.begin() + static_cast<std::ptrdiff_t>(first), end - first, is_unknown);
    first = end;
  }
  return is_unseen;
}

void add_scans(const MapParts& parts, Map& map) {
  const std::vector<Pose2> T_map_sensor = poses_of_scans(parts, map.sessions);
  const std::vector<bool> is_unseen = unseen_repeats(parts.scans, parts.num_scans);
  map.scans.reserve(parts.num_scans);
  for (std::size_t i = 0; i < parts.num_scans; ++i) {
    const TrackedScan scan = parts.scans[i];
    const double to_map_rad = T_map_sensor[i].theta_rad - scan.T_odom_sensor.theta_rad;
    const Eigen::Rotation2Dd to_map(to_map_rad);
    map.scans.push_back({.stamp = scan.stamp,
                         .status = is_unseen[i] ? TrackStatus::kLost : scan.status,
                         .T_map_sensor = T_map_sensor[i],
                         .T_map_base = T_map_sensor[i] * scan.T_base_sensor.inverse(),
                         .score = scan.score,
                         .has_odometry = scan.has_odometry,
                         .open_sigma_m = scan.open.sigma_m * (to_map * scan.open.direction),
                         .is_turn_open = scan.open.is_turn_open,
                         .open_turn_sigma_rad = scan.open.turn_sigma_rad,
                         .open_turn_motion_m = to_map * scan.open.turn_motion_m});
  }
  for (const TrackPiece& piece : map.pieces) {
    for (std::size_t i = 0; i < piece.num_scans; ++i) {
      map.scans[piece.first_scan + i].is_placed = piece.is_joined;
    }
  }
}

void add_headings(const FusedHeadings& fused, Map& map) {
  for (const HeadingFrame& frame : fused.frames) {
    map.frames.push_back({frame.offset_rad, frame.sigma_rad, frame.support});
  }
  for (std::size_t k = 0; k < fused.heading_rad.size(); ++k) {
    MappedHeading heading{.tracked_rad = fused.heading_rad[k] - fused.drift_rad[k],
                          .measured_rad = std::nullopt,
                          .information_per_rad2 = fused.measured_information[k],
                          .weight = fused.weight[k]};
    if (fused.frame[k] >= 0) {
      heading.measured_rad = fused.measured_heading_rad[k];
      heading.frame = static_cast<std::size_t>(fused.frame[k]);
    }
    map.headings.push_back(heading);
  }
  for (const DoubtedTurn& turn : distinct_turns(fused.doubted)) {
    map.undecided_turns.push_back({.first_scan = map.keyframes[turn.from],
                                   .last_scan = map.keyframes[turn.to],
                                   .turned_rad = turn.turned_rad});
  }
}

}  // namespace

Map assemble_map(const MapParts& parts) {
  Map map;
  for (const KeyframePtr& keyframe : parts.track.keyframes) {
    map.keyframes.push_back(keyframe->scan_index);
  }
  map.sessions = sessions_of(parts);
  map.pieces = pieces_of(parts.track, parts.is_joined, parts.num_scans, map.sessions);
  add_scans(parts, map);
  add_track(parts, map);
  add_headings(parts.headings, map);
  map.closures = mapped_closures(parts.track, parts.compared, parts.graph);
  map.graph = graph_of_base(parts.track, parts.graph);
  map.kept_scans.assign(parts.kept_scans.begin(), parts.kept_scans.end());
  map.forgotten_poses.assign(parts.gaps.begin(), parts.gaps.end());
  return map;
}

std::vector<MappedClosure> mapped_closures(const KeyframeTrack& track,
                                           std::span<const ComparedPlaces> compared,
                                           const PoseGraph& graph) {
  std::vector<double> weights(compared.size(), 0.0);
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind == ConstraintKind::kLoopClosure) {
      weights[constraint.source] = constraint.weight;
    }
  }
  std::vector<MappedClosure> closures;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const ComparedPlaces& places = compared[i];
    const Scan& scan_i = *track.keyframes[places.from]->scan;
    const Scan& scan_j = *track.keyframes[places.to]->scan;
    MappedClosure mapped;
    mapped.scan_i = track.keyframes[places.from]->scan_index;
    mapped.scan_j = track.keyframes[places.to]->scan_index;
    mapped.closure = {
        .stamp_i = scan_i.stamp,
        .stamp_j = scan_j.stamp,
        .T_i_j = scan_i.T_base_sensor * places.T_from_to * scan_j.T_base_sensor.inverse(),
        .axes = axes_of(places, graph),
        .is_accepted = is_accepted(places.verdict.reason),
        .weight = weights[i],
        .reason = std::string(to_string(places.verdict.reason))};
    closures.push_back(std::move(mapped));
  }
  return closures;
}

std::vector<TrackPiece> pieces_of(const KeyframeTrack& track,
                                  const std::vector<bool>& is_joined,
                                  std::size_t num_scans,
                                  std::span<const MapSession> sessions) {
  std::vector<TrackPiece> pieces;
  std::size_t session = 0;
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (track.pieces[k] < pieces.size()) continue;
    std::size_t first = pieces.empty() ? 0 : track.keyframes[k]->scan_index;
    while (session + 1 < sessions.size() &&
           sessions[session + 1].first_scan <= track.keyframes[k]->scan_index) {
      first = sessions[++session].first_scan;
    }
    if (!pieces.empty()) pieces.back().num_scans = first - pieces.back().first_scan;
    pieces.push_back({first, num_scans - first, is_joined[track.pieces[k]]});
  }
  return pieces;
}

PoseGraph graph_of_base(const KeyframeTrack& track, const PoseGraph& graph) {
  PoseGraph of_base = graph;
  for (std::size_t k = 0; k < track.size(); ++k) {
    of_base.T_map_node[k] = graph.T_map_node[k] * track.keyframes[k]->scan->T_base_sensor.inverse();
  }
  for (Constraint& constraint : of_base.constraints) {
    const Pose2& from = track.keyframes[constraint.from]->scan->T_base_sensor;
    const Pose2& to = track.keyframes[constraint.to]->scan->T_base_sensor;
    constraint.information =
        information_of_base(constraint.information, constraint.T_from_to, from, to);
    constraint.T_from_to = from * constraint.T_from_to * to.inverse();
  }
  for (HeadingMeasurement& heading : of_base.headings) {
    heading.heading_rad = wrap_to_pi(heading.heading_rad -
                                     track.keyframes[heading.node]->scan->T_base_sensor.theta_rad);
  }
  return of_base;
}

}  // namespace setsquare
