// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A map that was made before, read as tracking would have told it.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/tracked_scans.hpp"
#include "setsquare/tracking/keyframe.hpp"

namespace setsquare {

/// Throws ParameterError where the map does not tell its track (PaperMapper), or parts of it do not
/// belong together.
void require_track(const Map& map);

/// The first of the map's keyframes that is not before a scan.
[[nodiscard]] std::size_t keyframe_at(const Map& map, std::size_t scan);

/// The piece of track, from 0, that each of the map's keyframes belongs to.
[[nodiscard]] std::vector<std::size_t> pieces_of_keyframes(const Map& map);

/// A scan as tracking left it.
[[nodiscard]] TrackedScan tracked_scan(const Map& map, std::size_t scan);

/// The map's keyframes from `first` on and before `end`, with their surfaces. Any number of threads
/// gives the same. Throws ParameterError where the scan of one is not kept.
[[nodiscard]] std::vector<KeyframePtr> keyframes_of(const Map& map,
                                                    std::size_t first,
                                                    std::size_t end,
                                                    const MapperParams& params);

/// A session's scans, with what was left out between them.
struct LoggedScans {
  /// Of a scan, what tracking told: its stamp, and its pose in the odom frame.
  using Scan = std::pair<Timestamp, Pose2>;

  const MapSession& session;
  std::span<const ForgottenPoses> gaps;  ///< Of all sessions; one before its first is not its own.
  std::function<Scan(std::size_t)> scan_at;  ///< By the number that it has among all.
};

/// Whether both are of one log, whatever was forgotten of either: where both have two scans one
/// behind the other, tracking mostly moved from the one to the other alike.
[[nodiscard]] bool is_same_log(const LoggedScans& a, const LoggedScans& b);

}  // namespace setsquare
