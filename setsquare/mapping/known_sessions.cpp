// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/known_sessions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/mapping/forgetting.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/known_keyframes.hpp"
#include "setsquare/mapping/loops/verdict.hpp"
#include "setsquare/mapping/map_sessions.hpp"

namespace setsquare {
namespace {

/// Keyframes or scans, one after the other.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< Behind the last.
};

Range scans_of(const MapSession& session) {
  return {session.first_scan, session.first_scan + session.num_scans};
}

Range keyframes_in(const Map& map, const Range& scans) {
  return {keyframe_at(map, scans.begin), keyframe_at(map, scans.end)};
}

/// The session of a scan.
const MapSession& session_of(const Map& map, std::size_t scan) {
  const auto next = std::ranges::upper_bound(map.sessions, scan, {}, &MapSession::first_scan);
  return *(next - 1);
}

/// Whether the walls tell where all of it lies.
bool is_wholly_placed(const Map& map, const MapSession& session) {
  const Range scans = scans_of(session);
  return std::all_of(map.scans.begin() + static_cast<std::ptrdiff_t>(scans.begin),
                     map.scans.begin() + static_cast<std::ptrdiff_t>(scans.end),
                     [](const MappedScan& scan) { return scan.is_placed; });
}

/// The map's pieces of track with a keyframe, as ranges of these.
std::vector<Range> pieces_in(const Map& map) {
  const std::vector<std::size_t> pieces = pieces_of_keyframes(map);
  std::vector<Range> ranges;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool begins = k == 0 || pieces[k] != pieces[k - 1] ||
                        map.keyframes[k - 1] < session_of(map, map.keyframes[k]).first_scan;
    if (begins) ranges.push_back({k, k});
    ranges.back().end = k + 1;
  }
  return ranges;
}

/// The track in the map: what is placed is one piece.
KeyframeTrack track_in(const Map& map, const MapperParams& params) {
  KeyframeTrack track;
  track.keyframes = keyframes_of(map, 0, map.keyframes.size(), params);
  const std::vector<std::size_t> pieces = pieces_of_keyframes(map);
  for (std::size_t k = 0; k < track.keyframes.size(); ++k) {
    track.motions.push_back(map.track.motions[k].covariance);
    track.stretches.push_back(map.track.motions[k].stretch);
    track.pieces.push_back(map.scans[map.keyframes[k]].is_placed ? 0 : 1 + pieces[k]);
  }
  for (const MapSession& session : map.sessions) {
    const Range keyframes = keyframes_in(map, scans_of(session));
    if (keyframes.begin > 0 && keyframes.begin < keyframes.end) {
      track.session_begins.push_back(keyframes.begin);
    }
  }
  return track;
}

/// Closures of both axes that the map believes, between keyframes.
std::vector<Constraint> revisits_of(const Map& map) {
  std::vector<Constraint> revisits;
  for (const MappedClosure& mapped : map.closures) {
    const LoopClosure& closure = mapped.closure;
    if (!closure.is_accepted || closure.axes != ClosureAxes::kXY) continue;
    if (closure.weight < kMinRevisitWeight) continue;
    Constraint& revisit = revisits.emplace_back();
    revisit.from = keyframe_at(map, mapped.scan_i);
    revisit.to = keyframe_at(map, mapped.scan_j);
  }
  return revisits;
}

/// Forgets in a piece of a session that has ended: runs of keyframes that are known, and those
/// beside them, too. Within the piece the track goes on from a keyframe that a closure holds; at
/// its end it need not.
void forget_in_piece(const Range& piece,
                     std::span<const std::optional<KnownPlace>> places,
                     const std::vector<bool>& is_held,
                     std::size_t margin,
                     std::size_t shortest_run,
                     std::vector<bool>& stays) {
  const auto is_inside = [&](std::size_t k) {
    const std::size_t first = std::max(piece.begin + margin, k) - margin;
    const std::size_t end = std::min(k + margin + 1, piece.end);
    for (std::size_t i = first; i < end; ++i) {
      if (!places[i]) return false;
    }
    return true;
  };
  for (std::size_t k = piece.begin; k < piece.end; ++k) {
    std::size_t end = k;
    std::size_t goes_on = k;  // The keyframe from which the track goes on.
    for (; end < piece.end && is_inside(end); ++end) {
      if (is_held[end]) goes_on = end;
    }
    if (end == piece.end) goes_on = end;
    const bool is_whole = k == piece.begin && goes_on == piece.end;
    if (goes_on - k >= shortest_run || is_whole) {
      std::fill(stays.begin() + static_cast<std::ptrdiff_t>(k),
                stays.begin() + static_cast<std::ptrdiff_t>(goes_on),
                false);
    }
    k = std::max(k, std::max(end, goes_on + 1) - 1);
  }
}

/// Of each keyframe, whether it stays.
std::vector<bool> keyframes_that_stay(const Map& map,
                                      const KeyframeTrack& track,
                                      const MapperParams& params) {
  std::vector<bool> stays(map.keyframes.size(), true);
  std::vector<Pose2> T_map_sensor;
  for (const std::size_t scan : map.keyframes) T_map_sensor.push_back(map.scans[scan].T_map_sensor);
  KnownKeyframes known(params.forgetting);
  for (const MapSession& session : map.sessions) {
    known.examine(
        track, keyframes_in(map, scans_of(session)).end, T_map_sensor, params.num_threads);
  }
  const std::vector<bool> is_held = held_keyframes(known.places(), revisits_of(map));
  const std::size_t num_scanners = track.num_scanners();
  for (const Range& piece : pieces_in(map)) {
    const MapSession& session = session_of(map, map.keyframes[piece.begin]);
    if (session.first_scan == map.sessions.front().first_scan || !is_wholly_placed(map, session))
      continue;
    forget_in_piece(piece,
                    known.places(),
                    is_held,
                    params.forgetting.margin_keyframes * num_scanners,
                    params.forgetting.shortest_run * num_scanners,
                    stays);
  }
  return stays;
}

/// The map without keyframes that were chosen.
class Thinning {
 public:
  Thinning(const Map& map,
           const KeyframeTrack& track,
           const std::vector<bool>& stays,
           const ForgettingParams& params)
      : map_(map),
        track_(track),
        stays_(stays),
        params_(params),
        T_odom_sensor_(map.track.T_odom_sensor),
        motions_(map.track.motions),
        has_pose_(map.scans.size(), true),
        is_whole_(map.scans.size(), true) {}

  Map thinned() {
    const std::vector<Range> pieces = pieces_in(map_);
    for (std::size_t p = 0; p < pieces.size(); ++p) thin(pieces[p], scans_about(pieces, p));
    for (const MapSession& session : map_.sessions) keep_ends_of(session);
    leave_oldest_out();
    return left(pieces);
  }

 private:
  [[nodiscard]] const Pose2& T_map_sensor(std::size_t scan) const {
    return map_.scans[scan].T_map_sensor;
  }

  /// The scans of a piece.
  [[nodiscard]] Range scans_about(const std::vector<Range>& pieces, std::size_t p) const {
    const Range session = scans_of(session_of(map_, map_.keyframes[pieces[p].begin]));
    const bool is_first =
        p == 0 || map_.keyframes[pieces[p - 1].begin] < session.begin;  // Of its session.
    const bool is_last =
        p + 1 == pieces.size() || map_.keyframes[pieces[p + 1].begin] >= session.end;
    return {is_first ? session.begin : map_.keyframes[pieces[p].begin],
            is_last ? session.end : map_.keyframes[pieces[p + 1].begin]};
  }

  void thin(const Range& piece, const Range& scans) {
    std::optional<std::size_t> last;  // Keyframe that stays.
    T_new_old_ = {};
    for (std::size_t k = piece.begin; k < piece.end; ++k) {
      if (!stays_[k]) continue;
      const std::size_t scan = map_.keyframes[k];
      if (!last) {
        begin_with(k, piece, scans);
      } else if (k != *last + 1) {
        go_over_run(*last, k);
      } else {
        const Range between{map_.keyframes[*last] + 1, scan};
        if (was_forgotten_between(*last, k)) known_.push_back(between);
        move(between);
        move_motion(k);
      }
      T_odom_sensor_[scan] = T_new_old_ * map_.track.T_odom_sensor[scan];
      last = k;
    }
    if (!last) {
      leave_out(scans);
    } else if (*last + 1 < piece.end) {
      leave_out({map_.keyframes[*last] + 1, scans.end});
    } else {
      move({map_.keyframes[*last] + 1, scans.end});
    }
  }

  /// The first keyframe of a piece that stays. What comes before the first one of all stays, too.
  void begin_with(std::size_t k, const Range& piece, const Range& scans) {
    if (k == piece.begin) return;
    leave_out({scans.begin, map_.keyframes[k]});
    motions_[k].covariance = map_.track.motions[piece.begin].covariance;
  }

  /// From keyframe `from` to the next one that stays: as if tracking had followed the map.
  void go_over_run(std::size_t from, std::size_t to) {
    const std::size_t first = map_.keyframes[from];
    const std::size_t last = map_.keyframes[to];
    for (std::size_t i = first + 1; i <= last; ++i) {
      T_odom_sensor_[i] = seen_from(first, i);
      if (i < last) is_whole_[i] = false;
    }
    T_new_old_ = T_odom_sensor_[last] * map_.track.T_odom_sensor[last].inverse();
    known_.push_back({first + 1, last});
    motions_[to].covariance = joined_motion(track_, from + 1, to, params_);
    motions_[to].T_odom_body = T_new_old_ * map_.track.motions[to].T_odom_body;
  }

  /// Where a scan stands in the odom frame, by where the map has it and another one.
  [[nodiscard]] Pose2 seen_from(std::size_t other, std::size_t scan) const {
    return T_odom_sensor_[other] * (T_map_sensor(other).inverse() * T_map_sensor(scan));
  }

  /// Scans between keyframes that stay.
  void move(const Range& scans) {
    for (std::size_t i = scans.begin; i < scans.end; ++i) {
      T_odom_sensor_[i] = T_new_old_ * map_.track.T_odom_sensor[i];
    }
  }

  void move_motion(std::size_t k) {
    motions_[k].T_odom_body = T_new_old_ * map_.track.motions[k].T_odom_body;
    turn_by(T_new_old_.theta_rad, motions_[k].covariance);
  }

  void leave_out(const Range& scans) {
    for (std::size_t i = scans.begin; i < scans.end; ++i) has_pose_[i] = is_whole_[i] = false;
  }

  /// Whether keyframes between two that follow each other were forgotten before: a new stretch
  /// begins, and nothing was lost.
  [[nodiscard]] bool was_forgotten_between(std::size_t from, std::size_t to) const {
    if (motions_[from].stretch == motions_[to].stretch) return false;
    return std::none_of(map_.scans.begin() + static_cast<std::ptrdiff_t>(map_.keyframes[from] + 1),
                        map_.scans.begin() + static_cast<std::ptrdiff_t>(map_.keyframes[to]),
                        [](const MappedScan& scan) { return scan.status == TrackStatus::kLost; });
  }

  /// Of a session that has keyframes the first scan and the last one stay: they tell which log it
  /// is of.
  void keep_ends_of(const MapSession& session) {
    const Range keyframes = keyframes_in(map_, scans_of(session));
    const Range scans = scans_of(session);
    std::optional<std::size_t> last;
    for (std::size_t k = keyframes.begin; k < keyframes.end; ++k) {
      if (!stays_[k]) continue;
      if (!last) keep(scans.begin, map_.keyframes[k]);
      last = k;
    }
    if (last) keep(scans.end - 1, map_.keyframes[*last]);
  }
  void keep(std::size_t scan, std::size_t beside) {
    if (has_pose_[scan]) return;
    T_odom_sensor_[scan] = seen_from(beside, scan);
    has_pose_[scan] = true;
  }

  void leave_oldest_out() {
    std::size_t num_known = 0;
    for (const Range& scans : known_) num_known += scans.end - scans.begin;
    for (const Range& scans : known_) {
      if (num_known <= params_.max_poses_before) break;
      leave_out(scans);
      num_known -= scans.end - scans.begin;
    }
  }

  [[nodiscard]] Map left(const std::vector<Range>& pieces) const {
    Map left;
    const std::vector<std::size_t> numbers = add_scans(left);
    std::size_t stretch = 0;
    std::optional<std::size_t> last;
    for (std::size_t k = 0; k < stays_.size(); ++k) {
      if (!stays_[k]) continue;
      const bool is_over_run = last && *last + 1 != k;
      if (is_over_run || (last && motions_[*last].stretch != motions_[k].stretch)) ++stretch;
      left.keyframes.push_back(numbers[map_.keyframes[k]]);
      left.track.motions.push_back(motions_[k]);
      left.track.motions.back().stretch = stretch;
      last = k;
    }
    for (const KeptScan& kept : map_.kept_scans) {
      if (is_whole_[kept.index]) left.kept_scans.push_back({numbers[kept.index], kept.scan});
    }
    add_sessions(numbers, left);
    add_pieces(pieces, numbers, left);
    left.scanners = map_.scanners;
    left.gyro = map_.gyro;
    left.odometry = map_.odometry;
    left.sweep = map_.sweep;
    left.num_with_odometry = map_.num_with_odometry;
    left.num_forgotten = map_.num_forgotten + stays_.size() - left.keyframes.size();
    return left;
  }

  /// Returns what number each scan has now, or the next one that is left; one more: of all.
  std::vector<std::size_t> add_scans(Map& left) const {
    std::vector<std::size_t> numbers;
    numbers.reserve(map_.scans.size() + 1);
    ForgottenPoses pending;
    auto gap = map_.forgotten_poses.begin();
    for (std::size_t i = 0; i < map_.scans.size(); ++i) {
      numbers.push_back(left.scans.size());
      double step_m = 0.0;
      if (gap != map_.forgotten_poses.end() && gap->next_scan == i) {
        pending.num_scans += gap->num_scans;
        step_m = gap->way_m;
        ++gap;
      } else if (!begins_anew(map_, i) && i > 0) {
        step_m =
            (map_.scans[i].T_map_base.translation() - map_.scans[i - 1].T_map_base.translation())
                .norm();
      }
      if (!has_pose_[i]) ++pending.num_scans;
      if (pending.num_scans > 0) pending.way_m += step_m;
      if (!has_pose_[i]) continue;
      end_gap(pending, left);
      left.scans.push_back(map_.scans[i]);
      left.track.T_odom_sensor.push_back(T_odom_sensor_[i]);
    }
    numbers.push_back(left.scans.size());
    end_gap(pending, left);
    return numbers;
  }
  static void end_gap(ForgottenPoses& pending, Map& left) {
    if (pending.num_scans == 0) return;
    left.forgotten_poses.push_back({left.scans.size(), pending.num_scans, pending.way_m});
    pending = {};
  }

  void add_sessions(const std::vector<std::size_t>& numbers, Map& left) const {
    for (MapSession session : map_.sessions) {
      const Range scans = scans_of(session);
      session.first_scan = numbers[scans.begin];
      session.num_scans = numbers[scans.end] - session.first_scan;
      if (session.num_scans > 0 || scans.begin == scans.end) left.sessions.push_back(session);
    }
  }

  void add_pieces(const std::vector<Range>& pieces,
                  const std::vector<std::size_t>& numbers,
                  Map& left) const {
    for (const Range& piece : pieces) {
      for (std::size_t k = piece.begin; k < piece.end; ++k) {
        if (!stays_[k]) continue;
        const std::size_t scan = map_.keyframes[k];
        const Range session = scans_of(session_of(map_, scan));
        const bool is_first =
            left.pieces.empty() || left.pieces.back().first_scan < numbers[session.begin];
        const std::size_t first = is_first ? numbers[session.begin] : numbers[scan];
        if (!left.pieces.empty()) {
          left.pieces.back().num_scans = first - left.pieces.back().first_scan;
        }
        left.pieces.push_back({first, left.scans.size() - first, map_.scans[scan].is_placed});
        break;
      }
    }
  }

  const Map& map_;
  const KeyframeTrack& track_;
  const std::vector<bool>& stays_;
  const ForgettingParams& params_;
  Pose2 T_new_old_;  ///< Between the odom frames, behind the runs of a piece so far.
  std::vector<Pose2> T_odom_sensor_;
  std::vector<TrackedMotion> motions_;
  std::vector<bool> has_pose_;
  std::vector<bool> is_whole_;  ///< Whether its scan, if the map keeps that, stays.
  std::vector<Range> known_;    ///< Scans between keyframes that were forgotten.
};

}  // namespace

Map without_known_places(const Map& map, const MapperParams& params) {
  require_track(map);
  std::vector<bool> stays(map.keyframes.size(), true);
  KeyframeTrack track;
  if (map.sessions.size() > 1) {
    track = track_in(map, params);
    stays = keyframes_that_stay(map, track, params);
  }
  return Thinning(map, track, stays, params.forgetting).thinned();
}

}  // namespace setsquare
