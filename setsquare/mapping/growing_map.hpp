// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/known_keyframes.hpp"
#include "setsquare/mapping/log_tracker.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/map_assembly.hpp"
#include "setsquare/mapping/map_maker.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/session_track.hpp"
#include "setsquare/mapping/tracked_scans.hpp"
#include "setsquare/mapping/turn_checks.hpp"

namespace setsquare {

/// The second half of Mapper: what tracking tells of each scan in (LogTracker), map out. It grows
/// session after session (MapSession): each is a log that is being tracked, or one of a map that
/// was made before and is taken whole.
///
/// 1. Headings: each keyframe's walls measure its heading in the building.
/// 2. Loops: as the track of a session grows, places near each other are compared (close_loops).
/// 3. Memory: of places that several visits have covered, keyframes that show nothing new are
///    forgotten (KnownKeyframes), so that it is bounded by the building and not by the time. A
///    session that is tracked forgets by its own visits; what it shows that earlier sessions cover
///    is forgotten when the map of them all is gone on with (without_known_places).
/// 4. The map of all so far, when asked for (MapMaker).
///
/// What it does depends on the steps alone, not on when they come: a map that grows behind a robot
/// is the one that a log gives.
class GrowingMap {
 public:
  /// `params` are valid.
  explicit GrowingMap(const MapperParams& params);

  /// What tracking told of the next scan. Closes loops now and then, which takes its time. Steps
  /// that begin again go back to where their session began.
  void add(TrackSteps&& steps);

  /// The sessions of a map, but those that are here. The map stands as if their logs had been
  /// tracked, and the scans that come next are of another log: nothing is known of the way to it.
  /// The map that comes first gives the frame. Throws ParameterError where the map does not tell
  /// its track (PaperMapper).
  void add(const Map& map);
  /// The same of a map that is gone on with: what its sessions show that is known by earlier ones
  /// is forgotten first.
  void go_on_with(const Map& map);

  /// Sorts the sessions by their stamps for which is the newer one, where stamps tell: where no two
  /// sessions overlap in time. Otherwise they are the newer the later they came.
  void date_by_stamps();

  /// The map of all so far; more may follow. `sensors`: what those of the log that is tracked
  /// turned out to be. Until it has a scan here, the map tells those of the first map.
  [[nodiscard]] Map make(const SensorReports& sensors) const;
  /// The same for one of several on the way, sooner: pieces that have been joined stay where they
  /// are, and only the loops that came since are closed (MapMaker::make_next).
  [[nodiscard]] Map make_next(const SensorReports& sensors);

  /// Scans mapped.
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }

 private:
  /// What is known of the headings, and the loops that are closed.
  struct Loops {
    TurnChecks turn_checks;
    LoopCloser closer;
  };
  /// The session that came last, by itself.
  struct LastSession {
    explicit LastSession(const MapperParams& params);

    SessionTrack parts;
    Loops loops;  ///< As far as it has grown.
    KnownKeyframes known;
    Pose2 T_odom_tracked;           ///< From tracking's frame: forgetting takes drift off.
    std::size_t num_closed = 0;     ///< Keyframes when loops were last looked for.
    std::size_t num_forgotten = 0;  ///< Keyframes.
  };
  /// What begins with a keyframe.
  struct Begins {
    bool stretch = false;
    bool piece = false;
  };

  /// `make_of`: makes the map of what was tracked.
  template <typename MakeOf>
  [[nodiscard]] Map made(const SensorReports& sensors, const MakeOf& make_of) const;
  void add(TrackStep&& step);
  /// Drift that forgetting has taken off what came before.
  void take_drift_off(TrackStep& step) const;
  /// Of a scan that is here. Where several scanners leave keyframes, each is one of as many that
  /// show a place: the same walls (share_place) and one step of the track.
  void add_keyframe(TrackedKeyframe tracked, Begins begins);
  /// Of the session by itself: what ties it to others is found at the end.
  void close_while_growing();
  /// `headings_rad`: one per keyframe.
  void forget_known(std::span<const double> headings_rad);
  /// Of known ground, more poses than are wanted.
  void forget_oldest_poses();

  [[nodiscard]] bool holds(const Map& map, const MapSession& session) const;
  void add_session(const Map& map, const MapSession& session);
  /// Throws ParameterError where a keyframe's scan is not kept.
  void add_keyframes(const Map& map, const MapSession& session);

  /// The session that waits for its first scan begins.
  void open_session();
  /// The last session, if it has keyframes, is one of those before another one.
  void close_session();
  [[nodiscard]] std::size_t num_forgotten() const {
    return num_forgotten_before_ + last_.num_forgotten;
  }
  /// A session without keyframes has no place anywhere.
  [[nodiscard]] bool is_last_session_empty() const;
  void forget_last_session();

  MapperParams params_;
  /// What the sensors of the first map turned out to be, and how many scans of all maps came with
  /// odometry. None where there is no map.
  std::optional<SensorReports> known_sensors_;
  std::vector<MapSession> sessions_;
  bool is_session_waiting_ = true;
  bool is_map_coming_ = false;  ///< A map's sessions are being added: they stay as they are.
  TrackedScans scans_;
  std::vector<KeptScan> kept_scans_;
  SessionTrack before_;   ///< The sessions before the last one.
  Loops loops_of_first_;  ///< Of the first of these.
  LastSession last_;
  std::vector<AnchoredKeyframe> anchors_;
  std::optional<SettledLoops> settled_;   ///< By a map on the way.
  std::vector<HungScan> hung_scans_;      ///< Of the keyframes that were forgotten, in their order.
  std::vector<ForgottenPoses> gaps_;      ///< Where poses were forgotten.
  std::size_t num_forgotten_before_ = 0;  ///< Keyframes, by the maps that are gone on with.
};

}  // namespace setsquare
