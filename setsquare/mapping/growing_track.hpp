// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper, which feeds it from a log: maps that are gone on with are fed to it whole.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "setsquare/headings/evidence.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/kept_scans.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/map_assembly.hpp"
#include "setsquare/mapping/map_maker.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/turn_checks.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// What was tracked, of which a map can be made at any time: session after session, each a log that
/// is being tracked or one of a map that was made before.
class GrowingTrack {
 public:
  explicit GrowingTrack(const MapperParams& params);

  /// The scans that come next are of another log, and nothing is known of the way to it.
  void begin_session();

  /// A scan that was tracked last. Where several scanners leave keyframes, each is one of as many
  /// that show a place: the same walls (share_place) and one step of the track.
  void add(const Scan& scan, const TrackedPose& tracked, const ScanTracker& tracker);

  /// The sessions of a map, but those that are here. The track stands as if their logs had been
  /// tracked. The map that comes first gives the frame. Throws ParameterError where the map does
  /// not tell its track (PaperMapper).
  void add(const Map& map);

  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }
  [[nodiscard]] std::size_t num_sessions() const { return sessions_.size(); }

  /// Sorts the sessions by their stamps for which is the newer one, where stamps tell: where no two
  /// sessions overlap in time. Otherwise they are the newer the later they came.
  void date_by_stamps();

  /// `add_sensors` writes into the map what the sensors turned out to be.
  [[nodiscard]] Map make(const std::function<void(Map&)>& add_sensors) const;

 private:
  /// A keyframe's place in the track.
  struct Step {
    TrackedMotion motion;
    bool begins_stretch = false;
    bool begins_piece = false;
  };

  using ScansByIndex = std::map<std::size_t, std::shared_ptr<const Scan>>;  ///< Of Map::scans.

  [[nodiscard]] bool holds(const Map& map, const MapSession& session) const;
  void add_session(const Map& map, const MapSession& session);
  /// `kept`: the session's; those of keyframes share the keyframe's memory afterwards. Throws
  /// ParameterError where one is missing.
  void add_keyframes(const Map& map, const MapSession& session, ScansByIndex& kept);
  /// The session that waits for its first scan begins.
  void open_session();
  /// A session without keyframes has no place anywhere.
  [[nodiscard]] bool is_last_session_empty() const;
  void add_keyframe(KeyframePtr keyframe, Step step);
  /// Closes loops while one log is tracked; where there are several, all are closed at the end.
  void close_while_growing();

  MapperParams params_;
  MotionUncertainty uncertainty_;
  std::vector<MapSession> sessions_;
  bool is_session_waiting_ = true;
  std::vector<TrackedScan> scans_;
  KeptScans kept_;
  KeyframeTrack track_;
  std::vector<double> shares_of_place_;  ///< One per keyframe.
  std::vector<HeadingEvidence> evidence_;
  std::vector<AnchoredKeyframe> anchors_;
  TurnChecks turn_checks_;
  LoopCloser closer_;
  std::size_t num_closed_ = 0;  ///< Keyframes when loops were last looked for.
};

}  // namespace setsquare
