// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/surfaces/surface_params.hpp"

namespace setsquare {

/// How proposals are searched: `num_rotations` of them, the best `num_coarse` refined with a few
/// samples, the best `num_fine` of those with all.
struct SearchParams {
  std::size_t num_rotations = 6;  ///< Rotations tried, the likeliest first.
  std::size_t num_coarse = 10;    ///< Proposals refined with a few samples.
  std::size_t num_fine = 3;       ///< Of these, refined with all samples.
  int min_correlation = 8;        ///< Of a proposal's coarse samples with the grid.
};

/// What is known of the motion before the scans are seen: poses beyond it are not considered, not
/// as rivals either, and not where refinement leads to them. By default nothing is known.
struct MotionBounds {
  /// Of the position of the current sensor in the reference's frame.
  double max_translation_m = std::numeric_limits<double>::infinity();
  double max_rotation_rad = kPi;  ///< Either way.

  /// Whether a proposal may lie within, given how coarsely proposals are spaced.
  [[nodiscard]] bool may_hold(const Pose2& proposed) const {
    constexpr double kCoarse_m = 0.3;
    constexpr double kCoarse_rad = rad_from_deg(3.0);
    return proposed.translation().norm() <= max_translation_m + kCoarse_m &&
           std::abs(wrap_to_pi(proposed.theta_rad)) <= max_rotation_rad + kCoarse_rad;
  }

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Distances beyond which a sample has no part in a Gauss-Newton step: one step per tolerance, wide
/// ones first to catch, narrow ones last to settle.
struct RefinementParams {
  std::array<double, 3> coarse_tolerances_m{0.5, 0.35, 0.25};  ///< Of every proposal.
  std::array<double, 1> fine_tolerances_m{0.2};                ///< Of the best ones.
  std::array<double, 3> final_tolerances_m{0.2, 0.15, 0.1};    ///< Of the answer, ...
  double sweep_tolerance_m = 0.1;  ///< ... and of the answer together with the robot's turns.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// What is taken for true of walls and robots where the turns are estimated.
struct SweepParams {
  int num_steps = 3;             ///< Of Gauss and Newton; the start is near.
  double piece_length_m = 0.25;  ///< Distances nearer than this along the wall share one cause.
  double unevenness_m = 0.005;   ///< Sigma of a piece as a whole: its own samples do not show it.
  double turn_sigma = 0.002;     ///< Of a turn, before the scans are seen.
  /// Variance of a distance times the length of wall over which it stays: what the turns' prior is
  /// worth against a metre of wall.
  double wall_variance_m3 = 2.5e-5;

  /// What the prior of the turns weighs against a metre of wall.
  [[nodiscard]] double turn_weight() const { return wall_variance_m3 / (turn_sigma * turn_sigma); }

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// What counts as wall that agrees at a place and hardly elsewhere (distinct_wall_m).
struct DistinctWallParams {
  double max_distance_m = 0.15;  ///< Of a sample from the surface that it agrees with.
  /// Samples lie on one line if the cosine between their normals is above this ...
  double same_line_cosine = 0.97;
  double same_line_m = 0.25;    ///< ... and they are this near to it.
  double same_clutter_m = 0.4;  ///< Samples without a line this near together are one thing.
  double max_line_m = 0.5;      ///< No line or thing counts for more.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// When a motion is an alias: the place looks the same under it (find_aliases).
struct AliasParams {
  bool is_on = true;  ///< Off where the place is known: only motions of a moment are in question.
  double min_share = 0.4;            ///< Of the answer's closely agreeing wall, at the other pose.
  double max_contradiction_m = 3.0;  ///< By this much more may be contradicted there.
  double min_constraint_m = 1.0;     ///< Wall that must hold the open direction, each time ...
  double tolerance_m = 0.08;         ///< ... of what agrees within this.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Log odds (same_place) that none of 4,500 pairs of scans of different real buildings reached.
inline constexpr double kOnePlaceLogOdds = 3.0;

/// When an answer stands. Lengths are of wall, seen from either scan.
struct AnswerParams {
  std::size_t min_points = 10;              ///< Returns that a scan must have at least.
  double min_probability = 0.99946;         ///< An answer stands by its probability, or ...
  double min_probability_by_rules = 0.965;  ///< ... by a lower one and all the rules of the score.
  /// Surer answers are not asked whether the scans show one place at all (same_place) ...
  double sure_probability = 0.999994;
  /// ... and all others must show it by these log odds: kOnePlaceLogOdds for scans that may be of
  /// different buildings. Not asked by default, for in corridors of one building it costs right
  /// answers.
  double min_place_log_odds = -std::numeric_limits<double>::infinity();
  double min_agreement = 0.10;     ///< Share; below it the scans do not overlap.
  double min_constraint_m = 0.5;   ///< Wall that must hold the open direction of the position.
  double min_turning_m3 = 2.0;     ///< Wall times squared lever arm that must hold the rotation.
  double min_score = 0.24;         ///< An answer stands by its score ...
  double min_margin = 0.08;        ///< ... and a margin above the best different pose,
  double min_score_alone = 0.05;   ///< or, where much is hidden or has moved, by a lower score ...
  double min_margin_alone = 0.15;  ///< ... and a wide margin: nothing else comes near.
  double floor_score = -0.10;      ///< Lower runners-up count as this: no match at all.
  double low_score = 0.30;         ///< Below it ...
  double min_wall_m = 3.0;  ///< ... this much wall must hold the pose, both directions summed.
  /// The margin must reach this many times the share of one scan's wall, agreeing or contradicted,
  /// that the other contradicts.
  double margin_per_contradiction = 1.15;
  double min_distinct_m = 1.8;    ///< Agreeing wall, no line for more than half a metre.
  double clear_distinct_m = 2.5;  ///< With less the quick search is not trusted: all rotations.
  /// A different pose of this share of the agreement, contradicted as little, makes the answer
  /// ambiguous: a row of doors.
  double rival_agreement = 0.68;
  double rival_contradiction = 0.05;   ///< By this much more at most: share of what can be judged,
  double rival_contradiction_m = 2.0;  ///< and length.
  double same_translation_m = 0.30;    ///< Poses nearer than both of these are one answer.
  double same_rotation_rad = 0.10;     ///< See same_translation_m.
};

/// Weights of the score, from agreeing, contradicted and hidden shares of the compared wall.
struct ScoreParams {
  double tolerance_m = 0.20;      ///< Farther from a surface nothing agrees. Of the overlap, too.
  double hidden_weight = 0.1;     ///< A return behind the other scan's surface.
  double outside_discount = 0.3;  ///< How little a return counts that the other cannot judge.
  /// Returns where the other scan saw through cost weight * ln(1 + share / usual share): the first
  /// ones much, for true poses have next to none; more of them less and less, for people walk.
  double contradiction_weight = 0.15;
  double usual_contradiction = 0.02;  ///< The share that true poses usually have.
};

/// Parameters of the default matcher. Every field has a default that serves every sensor and log.
struct MatchParams {
  MotionBounds bounds;               ///< What is known of the motion; nothing by default.
  SurfaceParams surface;             ///< How returns become surfaces.
  SampleParams samples;              ///< How many samples are drawn of them.
  ScoreParams score;                 ///< How proposals are ranked.
  RefinementParams refinement;       ///< How they are refined.
  SweepParams sweep;                 ///< How turns during a sweep are estimated.
  DistinctWallParams distinct_wall;  ///< What counts as distinct wall.
  AliasParams alias;                 ///< What counts as an alias.
  AnswerParams answer;               ///< When the answer stands.
  SearchParams quick;                ///< Rotations from the walls' directions.
  /// Every rotation of the circle: where the quick search finds nothing that stands.
  SearchParams thorough{.num_rotations = 120, .num_coarse = 300, .num_fine = 20};

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
