// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/growing_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/forgetting.hpp"
#include "setsquare/mapping/known_sessions.hpp"
#include "setsquare/mapping/map_sessions.hpp"

namespace setsquare {
namespace {

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

GrowingMap::LastSession::LastSession(const MapperParams& params)
    : loops{TurnChecks(params.turns), LoopCloser(params.closing)}, known(params.forgetting) {}

GrowingMap::GrowingMap(const MapperParams& params)
    : params_(params),
      loops_of_first_{TurnChecks(params.turns), LoopCloser(params.closing)},
      last_(params) {}

// --- Sessions ------------------------------------------------------------------------------------

bool GrowingMap::is_last_session_empty() const {
  return sessions_.size() > before_.num_sessions() && last_.parts.size() == 0;
}

void GrowingMap::forget_last_session() {
  settled_.reset();
  const std::size_t first_scan = sessions_.back().first_scan;
  sessions_.pop_back();
  scans_.resize(first_scan);
  kept_scans_.resize(num_kept_before(kept_scans_, first_scan));
  // One before its first scan is of the sessions before.
  std::erase_if(gaps_, [&](const ForgottenPoses& gap) { return gap.next_scan > first_scan; });
  std::erase_if(hung_scans_, [&](const HungScan& hung) { return hung.scan_index >= first_scan; });
  last_ = LastSession(params_);
}

void GrowingMap::close_session() {
  if (last_.parts.size() == 0) return;
  num_forgotten_before_ += last_.num_forgotten;
  if (before_.size() == 0) loops_of_first_ = std::move(last_.loops);
  append_session(last_.parts, params_.motion, before_);
  last_ = LastSession(params_);
}

void GrowingMap::open_session() {
  if (is_last_session_empty()) forget_last_session();
  close_session();
  is_session_waiting_ = false;
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
  if (last_.T_odom_tracked != Pose2{}) take_drift_off(step);
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
  move_to_odom(last_.T_odom_tracked * step.scan.T_odom_sensor, step.scan);
  if (!step.keyframe) return;
  TrackedKeyframe& tracked = *step.keyframe;
  tracked.keyframe = moved_to_odom(
      *tracked.keyframe, last_.T_odom_tracked * tracked.keyframe->T_odom_sensor, tracked.motion);
}

void GrowingMap::add_keyframe(TrackedKeyframe tracked, Begins begins) {
  auto& [track, shares_of_place, evidence] = last_.parts;
  const bool is_first = track.size() == 0;
  const std::size_t stretch = is_first ? 0 : track.stretches.back();
  const std::size_t piece = is_first ? 0 : track.pieces.back();
  track.keyframes.push_back(tracked.keyframe);
  track.motions.push_back(tracked.motion);
  track.stretches.push_back(stretch + (!is_first && begins.stretch ? 1 : 0));
  track.pieces.push_back(piece + (!is_first && begins.piece ? 1 : 0));
  shares_of_place.push_back(tracked.share_of_place);
  evidence.push_back({.tracked_heading_rad = tracked.keyframe->T_odom_sensor.theta_rad,
                      .step_sigma_rad = std::sqrt(tracked.motion.rotation_rad2),
                      .proposals = heading_proposals(
                          *tracked.keyframe->scan, params_.direction, params_.confident_margin)});
  share_place(tracked.share_of_place, evidence.back());
  close_while_growing();
}

void GrowingMap::close_while_growing() {
  // Of sessions behind the first all loops are closed at the end.
  const bool forgets = params_.forgetting.is_on && !is_map_coming_;
  if (before_.size() > 0 && !forgets) return;
  const auto& [track, shares_of_place, evidence] = last_.parts;
  if (track.size() < next_closing(last_.num_closed, params_)) return;
  try {
    auto& [turn_checks, closer] = last_.loops;
    const FusedHeadings headings = turn_checks.fuse(track, evidence, params_.heading);
    close_loops(track, headings.heading_rad, track.size(), params_, closer);
    if (forgets) forget_known(headings.heading_rad);
  } catch (const Error&) {
    // Tracking goes on; MapMaker tries again, and tells where it cannot.
  }
  last_.num_closed = track.size();
}

void GrowingMap::forget_known(std::span<const double> headings_rad) {
  auto& [track, shares_of_place, evidence] = last_.parts;
  auto& [turn_checks, closer] = last_.loops;
  KnownKeyframes& known = last_.known;
  const PoseGraph graph = robust_graph(track, headings_rad, closer, params_);
  known.examine(track, track.size(), graph.T_map_node, params_.num_threads);
  const std::vector<std::size_t> kept =
      keyframes_to_keep(track, known.places(), revisits_in(graph, closer), params_.forgetting);
  if (kept.size() == track.size()) return;
  settled_.reset();  // It names keyframes.
  last_.num_forgotten += track.size() - kept.size();
  hang_forgotten(track, kept, known.places(), hung_scans_);
  const std::vector<Pose2> T_map_sensor = poses_of_known(track, known.places(), graph.T_map_node);
  const Pose2 T_new_old = forget_keyframes(kept,
                                           T_map_sensor,
                                           params_.forgetting,
                                           {scans_, kept_scans_, track, shares_of_place, evidence});
  last_.T_odom_tracked = T_new_old * last_.T_odom_tracked;
  turn_checks.keep_only(kept);
  closer.keep_only(kept, track);
  known.keep_only(kept);
  if (params_.forgetting.max_known_poses > 0) forget_oldest_poses();
}

void GrowingMap::forget_oldest_poses() {
  const std::vector<KnownScans> excess =
      oldest_known_scans(last_.parts.track, hung_scans_, params_.forgetting.max_known_poses);
  for (auto range = excess.rbegin(); range != excess.rend(); ++range) {
    const std::size_t num_gone = range->end - range->first;
    add_gap(*range, scans_, gaps_);
    scans_.erase(range->first, range->end);
    sessions_.back().num_scans -= num_gone;
    renumber_behind(*range, last_.parts.track, kept_scans_, hung_scans_);
    last_.known.renumber(range->end, num_gone);
  }
}

// --- Maps that are gone on with ------------------------------------------------------------------

bool GrowingMap::holds(const Map& map, const MapSession& session) const {
  const LoggedScans there{
      session, map.forgotten_poses, [&](std::size_t i) {
        return LoggedScans::Scan{map.scans[i].stamp, map.track.T_odom_sensor[i]};
      }};
  return std::ranges::any_of(sessions_, [&](const MapSession& known) {
    return is_same_log({known,
                        gaps_,
                        [&](std::size_t i) {
                          return LoggedScans::Scan{scans_.stamp(i), scans_.T_odom_sensor(i)};
                        }},
                       there);
  });
}

void GrowingMap::go_on_with(const Map& map) {
  if (params_.forgetting.is_on) {
    add(without_known_places(map, params_));
  } else {
    add(map);
  }
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
  close_session();
  num_forgotten_before_ += map.num_forgotten;
  if (known_sensors_) {
    known_sensors_->num_with_odometry += map.num_with_odometry;
  } else {
    known_sensors_ = sensors_of(map);
  }
  if (!is_first) return;
  if (!map.forgotten_poses.empty() && map.forgotten_poses.back().next_scan == map.scans.size()) {
    gaps_.push_back(map.forgotten_poses.back());
  }
  KeyframeTrack& track = before_.track;
  track.num_known = track.session_begins.empty() ? track.size() : track.session_begins.front();
  for (std::size_t k = 0; k < track.size(); ++k) {
    const MappedScan& scan = map.scans[map.keyframes[k]];
    if (scan.is_placed) anchors_.push_back({k, scan.T_map_sensor});
  }
}

void GrowingMap::add_session(const Map& map, const MapSession& session) {
  open_session();
  const std::size_t first_scan = sessions_.back().first_scan;
  const std::size_t end = session.first_scan + session.num_scans;
  const auto is_of_session = [&](std::size_t scan) {
    return scan >= session.first_scan && scan < end;
  };
  for (std::size_t i = session.first_scan; i < end; ++i) scans_.add(tracked_scan(map, i));
  sessions_.back().num_scans = session.num_scans;
  add_keyframes(map, session);
  for (const KeptScan& kept : map.kept_scans) {
    if (!is_of_session(kept.index)) continue;
    kept_scans_.push_back({kept.index - session.first_scan + first_scan, kept.scan});
  }
  for (ForgottenPoses gap : map.forgotten_poses) {
    if (!is_of_session(gap.next_scan)) continue;
    gap.next_scan = gap.next_scan - session.first_scan + first_scan;
    gaps_.push_back(gap);
  }
}

void GrowingMap::add_keyframes(const Map& map, const MapSession& session) {
  const std::size_t first = keyframe_at(map, session.first_scan);
  const std::size_t end = keyframe_at(map, session.first_scan + session.num_scans);
  const std::vector<KeyframePtr> keyframes = keyframes_of(map, first, end, params_);
  const std::vector<std::size_t> pieces = pieces_of_keyframes(map);
  const auto& motions = map.track.motions;
  for (std::size_t k = first; k < end; ++k) {
    Keyframe numbered = *keyframes[k - first];
    numbered.scan_index += sessions_.back().first_scan - session.first_scan;
    MotionCovariance motion = motions[k].covariance;
    // Open stretches are counted from the begin of their session.
    motion.open_stretch -= motions[first].covariance.open_stretch;
    Begins begins;
    if (k > first) {
      begins = {motions[k].stretch != motions[k - 1].stretch, pieces[k] != pieces[k - 1]};
    }
    add_keyframe(
        {std::make_shared<const Keyframe>(std::move(numbered)), motion, motions[k].share_of_place},
        begins);
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
  const bool is_one = before_.size() == 0;
  SessionTrack several;
  if (!is_one) {
    several = before_;
    if (last_.parts.size() > 0) append_session(last_.parts, params_.motion, several);
  }
  const auto& [track, shares_of_place, evidence] = is_one ? last_.parts : several;
  std::vector<ComparedPlaces> loops_of_last;
  if (!is_one && num_forgotten_before_ > 0) {
    loops_of_last = last_.loops.closer.compared();
    for (ComparedPlaces& places : loops_of_last) {
      places.from += before_.size();
      places.to += before_.size();
    }
  }
  const Loops& loops = is_one ? last_.loops : loops_of_first_;
  if (track.size() == 0) {
    Map map = assemble_map({.scans = scans_,
                            .num_scans = num_scans,
                            .kept_scans = kept,
                            .track = track,
                            .shares_of_place = shares_of_place,
                            .sessions = sessions,
                            .gaps = gaps_});
    write_sensors(told, map);
    map.num_forgotten = num_forgotten();
    return map;
  }
  const TrackedLog log{.scans = scans_,
                       .num_scans = num_scans,
                       .kept_scans = kept,
                       .track = track,
                       .shares_of_place = shares_of_place,
                       .hung_scans = hung_scans_,
                       .sessions = sessions,
                       .gaps = gaps_,
                       .anchors = anchors_,
                       .stays_joined = num_forgotten_before_ > 0,
                       .loops_of_last = loops_of_last,
                       .evidence = evidence,
                       .turn_checks = loops.turn_checks,
                       .closer = loops.closer,
                       .add_sensors = [&](Map& map) { write_sensors(told, map); }};
  Map map = make_of(MapMaker(log, params_));
  map.num_forgotten = num_forgotten();
  return map;
}

}  // namespace setsquare
