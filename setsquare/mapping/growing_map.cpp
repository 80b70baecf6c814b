// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/growing_map.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <span>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/forgetting.hpp"

namespace setsquare {
namespace {

/// The motion to the first keyframe of another session: nothing is known of it.
MotionCovariance unknown_motion(const MotionUncertaintyParams& params) {
  return {.translation_m2 =
              params.restart_sigma_m * params.restart_sigma_m * Eigen::Matrix2d::Identity(),
          .rotation_rad2 = params.restart_sigma_rad * params.restart_sigma_rad,
          .slip_sigma_m = params.restart_sigma_m,
          .has_odometry = false};
}

/// The scan as tracking left it; `T_base_sensor`: its mounting.
TrackedScan tracked_scan(const MappedScan& mapped,
                         const Pose2& T_odom_sensor,
                         const Pose2& T_base_sensor) {
  const Eigen::Rotation2Dd to_odom(T_odom_sensor.theta_rad - mapped.T_map_sensor.theta_rad);
  TrackedScan scan{.stamp = mapped.stamp,
                   .status = mapped.status,
                   .has_odometry = mapped.has_odometry,
                   .score = static_cast<float>(mapped.score),
                   .T_odom_sensor = T_odom_sensor,
                   .T_base_sensor = T_base_sensor,
                   .open = {.sigma_m = mapped.open_sigma_m.norm(),
                            .is_turn_open = mapped.is_turn_open,
                            .turn_sigma_rad = mapped.open_turn_sigma_rad,
                            .turn_motion_m = to_odom * mapped.open_turn_motion_m}};
  if (scan.open.sigma_m > 0.0) {
    scan.open.direction = to_odom * mapped.open_sigma_m / scan.open.sigma_m;
  }
  return scan;
}

void require_track(const Map& map) {
  const bool has_track = !map.sessions.empty() &&
                         map.track.T_odom_sensor.size() == map.scans.size() &&
                         map.track.motions.size() == map.keyframes.size();
  if (!has_track) {
    throw ParameterError("map", "does not tell its track: the preset \"paper\" makes none");
  }
  validate(map);
  const bool is_in_order = std::ranges::adjacent_find(
                               map.keyframes, std::ranges::greater_equal{}) == map.keyframes.end();
  if (!is_in_order) throw ParameterError("keyframes", "are not in the order of the scans");
  for (const TrackedMotion& motion : map.track.motions) {
    const MotionCovariance& covariance = motion.covariance;
    if (covariance.translation_m2.determinant() > 0.0 && covariance.rotation_rad2 > 0.0) continue;
    throw ParameterError("track.motions", "have a covariance that is none");
  }
}

/// The first of the map's keyframes that is not before a scan.
std::size_t keyframe_at(const Map& map, std::size_t scan) {
  return static_cast<std::size_t>(std::ranges::lower_bound(map.keyframes, scan) -
                                  map.keyframes.begin());
}

/// The piece of track, from 0, that each of the map's keyframes belongs to.
std::vector<std::size_t> pieces_of_keyframes(const Map& map) {
  std::vector<std::size_t> pieces;
  std::size_t piece = 0;
  for (const std::size_t scan : map.keyframes) {
    while (piece + 1 < map.pieces.size() && map.pieces[piece + 1].first_scan <= scan) ++piece;
    pieces.push_back(piece);
  }
  return pieces;
}

SensorReports sensors_of(const Map& map) {
  return {.scanners = map.scanners,
          .gyro = map.gyro,
          .odometry = map.odometry,
          .sweep = map.sweep,
          .num_with_odometry = map.num_with_odometry};
}

void write_sensors(const SensorReports& sensors, Map& map) {
  map.scanners = sensors.scanners;
  map.gyro = sensors.gyro;
  map.odometry = sensors.odometry;
  map.sweep = sensors.sweep;
  map.num_with_odometry = sensors.num_with_odometry;
}

/// Kept scans of an index less than this.
std::size_t num_kept_before(std::span<const KeptScan> kept, std::size_t index) {
  return static_cast<std::size_t>(std::ranges::lower_bound(kept, index, {}, &KeptScan::index) -
                                  kept.begin());
}

}  // namespace

GrowingMap::GrowingMap(const MapperParams& params)
    : params_(params),
      turn_checks_(params.turns),
      closer_(params.closing),
      known_(params.forgetting) {}

// --- Sessions ------------------------------------------------------------------------------------

bool GrowingMap::is_last_session_empty() const {
  if (sessions_.empty()) return false;
  return track_.size() == 0 || track_.keyframes.back()->scan_index < sessions_.back().first_scan;
}

void GrowingMap::forget_last_session() {
  settled_.reset();
  const std::size_t first_scan = sessions_.back().first_scan;
  sessions_.pop_back();
  scans_.resize(first_scan);
  kept_scans_.resize(num_kept_before(kept_scans_, first_scan));
  std::size_t num_keyframes = track_.size();
  while (num_keyframes > 0 && track_.keyframes[num_keyframes - 1]->scan_index >= first_scan) {
    --num_keyframes;
  }
  std::erase_if(gaps_, [&](const ForgottenPoses& gap) { return gap.next_scan >= first_scan; });
  track_.keyframes.resize(num_keyframes);
  track_.motions.resize(num_keyframes);
  track_.stretches.resize(num_keyframes);
  track_.pieces.resize(num_keyframes);
  std::erase_if(track_.session_begins, [&](std::size_t k) { return k >= num_keyframes; });
  shares_of_place_.resize(num_keyframes);
  evidence_.resize(num_keyframes);
  T_odom_tracked_ = {};
  if (num_closed_ <= num_keyframes) return;
  known_ = KnownKeyframes(params_.forgetting);
  hung_scans_.clear();
  num_forgotten_ = num_forgotten_before_;
  turn_checks_ = TurnChecks(params_.turns);
  closer_ = LoopCloser(params_.closing);
  num_closed_ = 0;
}

void GrowingMap::open_session() {
  if (is_last_session_empty()) forget_last_session();
  is_session_waiting_ = false;
  T_odom_tracked_ = {};
  std::size_t recency = 0;
  for (const MapSession& session : sessions_) recency = std::max(recency, session.recency + 1);
  sessions_.push_back({.first_scan = scans_.size(), .recency = recency, .search = {}});
}

// --- The log that is tracked ---------------------------------------------------------------------

void GrowingMap::add(TrackSteps&& steps) {
  if (steps.begins_again && !is_session_waiting_) {
    forget_last_session();
    is_session_waiting_ = true;
  }
  for (TrackStep& step : steps.steps) add(std::move(step));
}

void GrowingMap::add(TrackStep&& step) {
  if (is_session_waiting_) open_session();
  const std::size_t index = scans_.size();
  if (T_odom_tracked_ != Pose2{}) take_drift_off(step);
  scans_.add(step.scan);
  ++sessions_.back().num_scans;
  if (step.keyframe && step.keyframe->keyframe->scan_index != index) {
    // Tracking counts from the begin of its log.
    Keyframe numbered = *step.keyframe->keyframe;
    numbered.scan_index = index;
    step.keyframe->keyframe = std::make_shared<const Keyframe>(std::move(numbered));
  }
  if (step.kept) kept_scans_.push_back({index, std::move(step.kept)});
  if (!step.keyframe) return;
  const bool is_restart = step.scan.is_restart;
  const bool is_tied = step.keyframe->motion.has_odometry;
  add_keyframe(std::move(*step.keyframe), {is_restart, is_restart && !is_tied});
}

void GrowingMap::take_drift_off(TrackStep& step) const {
  move_to_odom(T_odom_tracked_ * step.scan.T_odom_sensor, step.scan);
  if (!step.keyframe) return;
  TrackedKeyframe& tracked = *step.keyframe;
  tracked.keyframe = moved_to_odom(
      *tracked.keyframe, T_odom_tracked_ * tracked.keyframe->T_odom_sensor, tracked.motion);
}

void GrowingMap::add_keyframe(TrackedKeyframe tracked, Begins begins) {
  const bool is_first = track_.size() == 0;
  const bool begins_session =
      is_first || track_.keyframes.back()->scan_index < sessions_.back().first_scan;
  if (begins_session && !is_first) {
    track_.session_begins.push_back(track_.size());
    const std::size_t open_stretch = track_.motions.back().open_stretch + 1;
    tracked.motion = unknown_motion(params_.motion);
    tracked.motion.open_stretch = open_stretch;
    begins = {true, true};
  } else if (!track_.session_begins.empty()) {
    tracked.motion.open_stretch += track_.motions[track_.session_begins.back()].open_stretch;
  }
  const std::size_t stretch = is_first ? 0 : track_.stretches.back();
  const std::size_t piece = is_first ? 0 : track_.pieces.back();
  track_.keyframes.push_back(tracked.keyframe);
  track_.motions.push_back(tracked.motion);
  track_.stretches.push_back(stretch + (!is_first && begins.stretch ? 1 : 0));
  track_.pieces.push_back(piece + (!is_first && begins.piece ? 1 : 0));
  shares_of_place_.push_back(tracked.share_of_place);
  evidence_.push_back({.tracked_heading_rad = tracked.keyframe->T_odom_sensor.theta_rad,
                       .step_sigma_rad = std::sqrt(tracked.motion.rotation_rad2),
                       .proposals = heading_proposals(
                           *tracked.keyframe->scan, params_.direction, params_.confident_margin)});
  share_place(tracked.share_of_place, evidence_.back());
  close_while_growing();
}

void GrowingMap::close_while_growing() {
  if (!track_.session_begins.empty()) return;
  if (track_.size() < next_closing(num_closed_, params_)) return;
  try {
    const FusedHeadings headings = turn_checks_.fuse(track_, evidence_, params_.heading);
    close_loops(track_, headings.heading_rad, track_.size(), params_, closer_);
    if (params_.forgetting.is_on && !is_map_coming_) forget_known(headings.heading_rad);
  } catch (const Error&) {
    // Tracking goes on; MapMaker tries again, and tells where it cannot.
  }
  num_closed_ = track_.size();
}

void GrowingMap::forget_known(std::span<const double> headings_rad) {
  const PoseGraph graph = robust_graph(track_, headings_rad, closer_, params_);
  known_.examine(track_, graph.T_map_node, params_.num_threads);
  const std::vector<std::size_t> kept =
      keyframes_to_keep(track_, known_.places(), revisits_in(graph, closer_), params_.forgetting);
  if (kept.size() == track_.size()) return;
  settled_.reset();  // It names keyframes.
  num_forgotten_ += track_.size() - kept.size();
  hang_forgotten(track_, kept, known_.places(), hung_scans_);
  const std::vector<Pose2> T_map_sensor = poses_of_known(track_, known_.places(), graph.T_map_node);
  const Pose2 T_new_old =
      forget_keyframes(kept,
                       T_map_sensor,
                       params_.forgetting,
                       {scans_, kept_scans_, track_, shares_of_place_, evidence_});
  T_odom_tracked_ = T_new_old * T_odom_tracked_;
  turn_checks_.keep_only(kept);
  closer_.keep_only(kept, track_);
  known_.keep_only(kept);
  if (params_.forgetting.max_known_poses > 0) forget_oldest_poses();
}

void GrowingMap::forget_oldest_poses() {
  const std::vector<KnownScans> excess =
      oldest_known_scans(track_, hung_scans_, params_.forgetting.max_known_poses);
  for (auto range = excess.rbegin(); range != excess.rend(); ++range) {
    const std::size_t num_gone = range->end - range->first;
    add_gap(*range, scans_, gaps_);
    scans_.erase(range->first, range->end);
    sessions_.back().num_scans -= num_gone;
    renumber_behind(*range, track_, kept_scans_, hung_scans_);
    known_.renumber(range->end, num_gone);
  }
}

// --- Maps that are gone on with ------------------------------------------------------------------

bool GrowingMap::holds(const Map& map, const MapSession& session) const {
  return std::ranges::any_of(sessions_, [&](const MapSession& known) {
    if (known.num_scans != session.num_scans) return false;
    for (std::size_t i = 0; i < session.num_scans; ++i) {
      const std::size_t here = known.first_scan + i;
      const std::size_t there = session.first_scan + i;
      if (scans_.stamp(here) != map.scans[there].stamp ||
          scans_.T_odom_sensor(here) != map.track.T_odom_sensor[there]) {
        return false;
      }
    }
    return true;
  });
}

void GrowingMap::add(const Map& map) {
  require_track(map);
  const bool is_first = sessions_.empty();
  is_map_coming_ = true;
  for (const MapSession& session : map.sessions) {
    if (holds(map, session)) continue;
    add_session(map, session);
    if (is_first) sessions_.back().recency = session.recency;
  }
  is_map_coming_ = false;
  is_session_waiting_ = true;
  num_forgotten_before_ += map.num_forgotten;
  num_forgotten_ = num_forgotten_before_;
  if (known_sensors_) {
    known_sensors_->num_with_odometry += map.num_with_odometry;
  } else {
    known_sensors_ = sensors_of(map);
  }
  if (!is_first) return;
  const auto& begins = track_.session_begins;
  track_.num_known = begins.empty() ? track_.size() : begins.front();
  for (std::size_t k = 0; k < track_.size(); ++k) {
    const MappedScan& scan = map.scans[map.keyframes[k]];
    if (scan.is_placed) anchors_.push_back({k, scan.T_map_sensor});
  }
}

void GrowingMap::add_session(const Map& map, const MapSession& session) {
  open_session();
  const std::size_t end = session.first_scan + session.num_scans;
  ScansByIndex kept;
  for (const KeptScan& scan : map.kept_scans) {
    if (scan.index >= session.first_scan && scan.index < end) kept.emplace(scan.index, scan.scan);
  }
  for (std::size_t i = session.first_scan; i < end; ++i) {
    const MappedScan& scan = map.scans[i];
    const auto whole = kept.find(i);
    const Pose2 T_base_sensor = whole != kept.end() ? whole->second->T_base_sensor
                                                    : scan.T_map_base.inverse() * scan.T_map_sensor;
    scans_.add(tracked_scan(scan, map.track.T_odom_sensor[i], T_base_sensor));
  }
  sessions_.back().num_scans = session.num_scans;
  add_keyframes(map, session, kept);
  for (const auto& [index, scan] : kept) {
    kept_scans_.push_back({index - session.first_scan + sessions_.back().first_scan, scan});
  }
  for (ForgottenPoses gap : map.forgotten_poses) {
    if (gap.next_scan < session.first_scan || gap.next_scan >= end) continue;
    gap.next_scan = gap.next_scan - session.first_scan + sessions_.back().first_scan;
    gaps_.push_back(gap);
  }
}

void GrowingMap::add_keyframes(const Map& map,
                               const MapSession& session,
                               const ScansByIndex& kept) {
  const std::size_t first = keyframe_at(map, session.first_scan);
  const std::size_t end = keyframe_at(map, session.first_scan + session.num_scans);
  std::vector<KeyframePtr> keyframes(end - first);
  run_in_parallel(keyframes.size(), params_.num_threads, [&](std::size_t i) {
    const std::size_t scan_index = map.keyframes[first + i];
    const auto whole = kept.find(scan_index);
    if (whole == kept.end()) return;
    auto surfaces = scan_surfaces(*whole->second, params_.tracker.surfaces, params_.tracker.image);
    keyframes[i] = std::make_shared<const Keyframe>(
        Keyframe{.scan_index = scan_index - session.first_scan + sessions_.back().first_scan,
                 .T_odom_sensor = map.track.T_odom_sensor[scan_index],
                 .T_odom_body = map.track.motions[first + i].T_odom_body,
                 .scan = whole->second,
                 .surfaces = std::move(surfaces)});
  });
  const std::vector<std::size_t> pieces = pieces_of_keyframes(map);
  const auto& motions = map.track.motions;
  for (std::size_t k = first; k < end; ++k) {
    const KeyframePtr& keyframe = keyframes[k - first];
    if (!keyframe) throw ParameterError("map", "does not keep the scan of a keyframe");
    MotionCovariance motion = motions[k].covariance;
    Begins begins;
    if (k > first) {
      begins = {motions[k].stretch != motions[k - 1].stretch, pieces[k] != pieces[k - 1]};
      // Open stretches are counted from the begin of their session.
      if (first > 0) motion.open_stretch -= motions[first].covariance.open_stretch;
    }
    add_keyframe({keyframe, motion, motions[k].share_of_place}, begins);
  }
}

void GrowingMap::date_by_stamps() {
  struct Span {
    Timestamp first;
    Timestamp last;
    std::size_t session = 0;
  };
  std::vector<Span> spans;
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    const auto& [first_scan, num_scans, recency, search] = sessions_[s];
    if (num_scans == 0) return;
    Span span{scans_.stamp(first_scan), scans_.stamp(first_scan), s};
    for (std::size_t i = first_scan; i < first_scan + num_scans; ++i) {
      span.first = std::min(span.first, scans_.stamp(i));
      span.last = std::max(span.last, scans_.stamp(i));
    }
    spans.push_back(span);
  }
  std::ranges::sort(spans, {}, &Span::first);
  for (std::size_t i = 1; i < spans.size(); ++i) {
    if (!(spans[i - 1].last < spans[i].first)) return;
  }
  for (std::size_t i = 0; i < spans.size(); ++i) sessions_[spans[i].session].recency = i;
}

// --- The map -------------------------------------------------------------------------------------

Map GrowingMap::make(const SensorReports& sensors) const {
  return made(sensors, [](const MapMaker& maker) { return maker.make(); });
}

Map GrowingMap::make_next(const SensorReports& sensors) {
  return made(sensors, [&](const MapMaker& maker) { return maker.make_next(settled_); });
}

template <typename MakeOf>
Map GrowingMap::made(const SensorReports& sensors, const MakeOf& make_of) const {
  SensorReports told = sensors;
  if (known_sensors_ && is_session_waiting_) {
    told = *known_sensors_;
  } else if (known_sensors_) {
    told.num_with_odometry += known_sensors_->num_with_odometry;
  }
  std::span<const MapSession> sessions = sessions_;
  std::size_t num_scans = scans_.size();
  std::span<const KeptScan> kept = kept_scans_;
  if (sessions.size() > 1 && is_last_session_empty()) {
    num_scans = sessions.back().first_scan;
    kept = kept.first(num_kept_before(kept, num_scans));
    sessions = sessions.first(sessions.size() - 1);
  }
  if (track_.size() == 0) {
    Map map = assemble_map({.scans = scans_,
                            .num_scans = num_scans,
                            .kept_scans = kept,
                            .track = track_,
                            .shares_of_place = shares_of_place_,
                            .sessions = sessions,
                            .gaps = gaps_});
    write_sensors(told, map);
    map.num_forgotten = num_forgotten_;
    return map;
  }
  const TrackedLog log{.scans = scans_,
                       .num_scans = num_scans,
                       .kept_scans = kept,
                       .track = track_,
                       .shares_of_place = shares_of_place_,
                       .hung_scans = hung_scans_,
                       .sessions = sessions,
                       .gaps = gaps_,
                       .anchors = anchors_,
                       .evidence = evidence_,
                       .turn_checks = turn_checks_,
                       .closer = closer_,
                       .add_sensors = [&](Map& map) { write_sensors(told, map); }};
  Map map = make_of(MapMaker(log, params_));
  map.num_forgotten = num_forgotten_;
  return map;
}

}  // namespace setsquare
