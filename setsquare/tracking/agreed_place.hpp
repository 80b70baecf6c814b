// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/prepared_keyframes.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// Where one keyframe, matched with a scan without a guess, has the scan.
struct PlaceVote {
  Pose2 T_odom_sensor;
  MatchStatus status = MatchStatus::kNoOverlap;
  double probability = 0.0;  ///< That the place is right (MatchResult).
  /// In the odom frame, modulo pi: the direction that a degenerate match leaves open.
  std::optional<double> open_direction_rad = std::nullopt;
};

/// Where keyframes agree that a scan stands.
struct AgreedPlace {
  Pose2 T_odom_sensor;  ///< By the latest keyframe of those that agree.
  double votes = 0.0;   ///< For it: 1 for each match that stands alone, 1/2 for an ambiguous one.
};

/// What a match says for the place that it gives.
[[nodiscard]] double vote_weight(MatchStatus status);

/// The votes of the latest keyframes, the latest first; no more than two where these stand alone
/// and agree.
[[nodiscard]] std::vector<PlaceVote> place_votes(PreparedKeyframes& keyframes,
                                                 const PreparedScan& current,
                                                 const PlaceVoteParams& params);

/// Where the robot may be by its motion alone.
struct ExpectedStep {
  /// Who expects it.
  enum class By {
    kLastMotion,
    kOdometry,        ///< Of which little is known.
    kProvedOdometry,  ///< That has proved true.
  };

  Pose2 T_odom_sensor;  ///< About it, ...
  StepReach reach;      ///< ... as far as this at most.
  By by = By::kLastMotion;
};

/// Whether the robot may be there.
[[nodiscard]] bool is_within(const ExpectedStep& step, const Pose2& T_odom_sensor);

/// How far a robot is from where its odometry has it, and turned against that; nothing within its
/// reach, and where no odometry expects the step.
[[nodiscard]] std::optional<StepReach> departure_from(const ExpectedStep& step,
                                                      const Pose2& T_odom_sensor);

/// The place with the most votes. It needs more than any other place, for one wrong match bends all
/// that follows, and those of one match that stands alone, or of two ambiguous ones. A place within
/// reach of the expected step has as much for it as an ambiguous match gives: what makes a match
/// ambiguous mostly lies farther away. Beyond that reach it needs a match that stands alone:
/// keyframes of one room take a scan for the same wrong part of it, all alike. By odometry it needs
/// the votes that a jump needs, too; where the last motion expects the step, the probability that a
/// likely place needs, within reach as well.
[[nodiscard]] std::optional<AgreedPlace> agreed_place(std::span<const PlaceVote> votes,
                                                      const std::optional<ExpectedStep>& step,
                                                      const PlaceVoteParams& params);

/// How much the robot's motion speaks against a place, before any match: as odds. A match would be
/// wrong anywhere within kProbabilityWithin_m and turned by any angle; within the reach of a step
/// lies a small share of that. Beyond the reach a place is the less likely the farther off it is.
[[nodiscard]] double odds_against(const ExpectedStep& step,
                                  const Pose2& T_odom_sensor,
                                  const StepOddsParams& params);

/// The logarithm of the odds that a match of this probability is right at a place that the motion
/// speaks against so much. No match is surer than StepOddsParams::least_wrong.
[[nodiscard]] double log_odds_of_place(double probability,
                                       double odds_against,
                                       const StepOddsParams& params);

/// Where a scan stands by the surest of the matches that have it there and by the robot's motion.
struct ProbablePlace {
  Pose2 T_odom_sensor;
  double probability = 0.0;
  bool is_open = false;  ///< Whether every match that has it there is degenerate.
  /// Then, in the odom frame, modulo pi; nothing where it is only the turn that is open.
  std::optional<double> open_direction_rad = std::nullopt;
};

/// The likeliest place, if it is likely enough and no other place is. Degenerate matches count:
/// among key frames in a corridor there may be no others, and within reach of a step they are
/// right.
[[nodiscard]] std::optional<ProbablePlace> probable_place(std::span<const PlaceVote> votes,
                                                          const ExpectedStep& step,
                                                          const PlaceVoteParams& params);

/// Whether the odometry speaks against a place beyond its reach. That which has proved true: the
/// scan fits where the robot drove as well, or fewer votes are for the place than a jump needs;
/// other odometry: both.
[[nodiscard]] bool is_refuted(const AgreedPlace& place,
                              const ExpectedStep& step,
                              bool fits_as_driven,
                              const PlaceVoteParams& params);

/// Whether two poses are one place.
[[nodiscard]] bool is_same_place(const Pose2& a, const Pose2& b, const PlaceVoteParams& params);

}  // namespace setsquare
