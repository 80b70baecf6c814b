// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/log_tracker.hpp"
#include "setsquare/mapping/map_maker.hpp"

namespace setsquare {

/// The second half of Mapper: what tracking tells of each scan in (LogTracker), map out.
///
/// 1. Headings: each keyframe's walls measure its heading in the building.
/// 2. Loops: as the track grows, places near each other are compared (close_loops).
/// 3. The map of all so far, when asked for (MapMaker).
///
/// What it does depends on the steps alone, not on when they come: a map that grows behind a robot
/// is the one that a log gives.
class GrowingMap {
 public:
  /// `params` are valid.
  explicit GrowingMap(const MapperParams& params);

  /// What tracking told of the next scan. Closes loops now and then, which takes its time.
  void add(TrackSteps&& steps);

  /// The map of all so far; more may follow.
  [[nodiscard]] Map finish(const SensorReports& sensors) const;

  /// Scans mapped.
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }

 private:
  void add(TrackStep&& step);
  /// The scan that came last. Where several scanners leave keyframes, each is one of as many that
  /// show a place: the same walls (share_place) and one step of the track.
  void add_keyframe(const TrackedKeyframe& keyframe);

  MapperParams params_;
  TurnChecks turn_checks_;
  LoopCloser closer_;
  std::vector<TrackedScan> scans_;
  std::vector<KeptScan> kept_scans_;
  KeyframeTrack track_;
  std::vector<HeadingEvidence> evidence_;
  std::size_t num_closed_ = 0;  ///< Keyframes when loops were last looked for.
};

}  // namespace setsquare
