// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from growing_map, its only caller, which knows when.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/headings/evidence.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/known_keyframes.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/tracked_scans.hpp"

namespace setsquare {

/// The keyframes that are left, in their order, when those are forgotten that show nothing new.
///
/// A run of these in one piece of track is forgotten, from beside what is new to a keyframe that a
/// closure of both axes ties to one that stays: from there the track goes on, held by the closure.
/// The submap about what is new keeps all of its keyframes. A run that is too short stays.
/// `places`: KnownKeyframes; `closures`: accepted ones of both axes, between keyframes.
[[nodiscard]] std::vector<std::size_t> keyframes_to_keep(
    const KeyframeTrack& track,
    std::span<const std::optional<KnownPlace>> places,
    std::span<const Constraint> closures,
    const ForgettingParams& params);

/// Hangs the scans of keyframes that are about to be forgotten on those that they were seen from.
/// `kept`: of keyframes_to_keep(); `hung` stays in the order of the scans.
void hang_forgotten(const KeyframeTrack& track,
                    std::span<const std::size_t> kept,
                    std::span<const std::optional<KnownPlace>> places,
                    std::vector<HungScan>& hung);

/// What tracking told of one log, one entry of the last four per keyframe.
struct TrackedParts {
  TrackedScans& scans;
  std::vector<KeptScan>& kept_scans;
  KeyframeTrack& track;
  std::vector<double>& shares_of_place;
  std::vector<HeadingEvidence>& evidence;
};

/// Forgets keyframes, and the scans that were kept between them. What the tracked poses had drifted
/// by over a run that is forgotten is taken off: within it and behind it they are as if tracking
/// had followed `T_map_sensor`, where keyframes stand (one each), from the run's first keyframe to
/// the next that is left; what came before stays, so that the time this takes does not grow. The
/// motion to that keyframe has the covariance that the motions of the run add up to, and at most
/// that of a known place (ForgettingParams).
/// `kept`: of keyframes_to_keep(), not all. Returns T_new_old, between the odom frames, for what is
/// tracked from here on.
[[nodiscard]] Pose2 forget_keyframes(std::span<const std::size_t> kept,
                                     std::span<const Pose2> T_map_sensor,
                                     const ForgettingParams& params,
                                     TrackedParts parts);

/// The motion over a run of forgotten keyframes: those from `first` to `last`, which is left.
[[nodiscard]] MotionCovariance joined_motion(const KeyframeTrack& track,
                                             std::size_t first,
                                             std::size_t last,
                                             const ForgettingParams& params);

/// Of each keyframe, whether a closure ties it to an earlier one that shows something new.
[[nodiscard]] std::vector<bool> held_keyframes(std::span<const std::optional<KnownPlace>> places,
                                               std::span<const Constraint> closures);

/// Scans, one after the other.
struct KnownScans {
  std::size_t first = 0;
  std::size_t end = 0;  ///< Behind the last.
};

/// The oldest scans between keyframes that were forgotten, and of these: all that are more than
/// `max_num`. Each range ends before a keyframe or a scan that hangs on one (`hung`): the scans
/// that stay lie as they did.
[[nodiscard]] std::vector<KnownScans> oldest_known_scans(const KeyframeTrack& track,
                                                         std::span<const HungScan> hung,
                                                         std::size_t max_num);

/// Tells of scans that are about to be left out, in the numbers that the scans will have; `gaps`
/// stay in their order.
void add_gap(const KnownScans& range, const TrackedScans& scans, std::vector<ForgottenPoses>& gaps);

/// What names scans, when those of a range, which has no keyframe, are no longer there.
void renumber_behind(const KnownScans& range,
                     KeyframeTrack& track,
                     std::vector<KeptScan>& kept_scans,
                     std::vector<HungScan>& hung);

/// A motion in an odom frame that is turned.
void turn_by(double turn_rad, MotionCovariance& motion);

/// A keyframe in another odom frame, with the motion to it.
[[nodiscard]] KeyframePtr moved_to_odom(const Keyframe& keyframe,
                                        const Pose2& T_odom_sensor,
                                        MotionCovariance& motion);

}  // namespace setsquare
