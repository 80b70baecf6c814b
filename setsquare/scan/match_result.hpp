// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string_view>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// What a match answers.
enum class MatchStatus {
  kMatched,       ///< The pose is determined by the scans and stands alone.
  kAmbiguous,     ///< Another, different pose explains the scans almost as well.
  kDegenerate,    ///< The scans do not determine the motion along one direction (a corridor), or
                  ///< the rotation (a round hall).
  kNoOverlap,     ///< No proposal explains enough of the scans.
  kTooFewPoints,  ///< A scan has too few returns to say anything.
  kRejected,      ///< The paper's threshold on the ZNCC was not reached (preset `paper` only).
};

/// The status as written into files: "matched", "ambiguous", "degenerate", "no_overlap",
/// "too_few_points", "rejected".
[[nodiscard]] std::string_view to_string(MatchStatus status);

/// The best proposal that differs from the answer by more than the size of one basin.
struct RunnerUp {
  Pose2 T_reference_current;  ///< Its pose.
  double score = 0.0;         ///< As MatchResult::score.
};

/// The answer of a match, with its evidence: NaN where the preset does not measure it. Poses are
/// those of the sensors at the middles of their sweeps: p_reference = T_reference_current *
/// p_current.
struct MatchResult {
  /// Whether, and in which way, the pose may be used.
  MatchStatus status = MatchStatus::kTooFewPoints;
  /// The best proposal whatever the status; nothing where there is none.
  std::optional<Pose2> T_reference_current = std::nullopt;
  /// Inverse covariance of (x, y, theta) in the reference's frame, in 1/m^2, 1/(m rad), 1/rad^2:
  /// symmetric, positive semi-definite, singular where the match is degenerate.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double zncc_x =
      std::numeric_limits<double>::quiet_NaN();  ///< Along the dominant direction, [-1, 1].
  double zncc_y = std::numeric_limits<double>::quiet_NaN();  ///< Across it.
  double score = 0.0;      ///< Agreement less the weighted contradiction; ranks proposals.
  double agreement = 0.0;  ///< Share of the comparable returns that lie on the other's surfaces.
  double contradiction = 0.0;  ///< Share of the returns that lie where the other scan saw through.
  double overlap = 0.0;        ///< Share of the current returns explained by the reference.
  /// That the answer is right, within 0.2 m and 3 deg, of scans taken within 5 m of each other; NaN
  /// where the preset does not measure it.
  double probability = std::numeric_limits<double>::quiet_NaN();
  std::optional<RunnerUp> runner_up = std::nullopt;  ///< Nothing where no other pose was found.
  /// A motion in the reference's frame under which the place looks the same, a niche further: moved
  /// by it the answer is a pose that nothing contradicts either. Nothing where there is none.
  std::optional<Pose2> alias = std::nullopt;
  /// Direction in the reference's frame along which the pose is not determined, in rad, modulo pi;
  /// nothing where it is only the rotation that is not.
  std::optional<double> degenerate_direction_rad = std::nullopt;
};

/// Standard deviations of a pose's parts in the reference's frame.
struct PoseSigmas {
  double x_m = 0.0;        ///< Of the position, along the reference's x axis.
  double y_m = 0.0;        ///< Along its y axis.
  double theta_rad = 0.0;  ///< Of the rotation.
};

/// The marginal standard deviations of the pose: the roots of the covariance's diagonal, where the
/// covariance is the inverse of the information. Nothing where the information has no inverse: the
/// match is degenerate, or there is no pose.
[[nodiscard]] std::optional<PoseSigmas> marginal_sigmas(const MatchResult& result);

}  // namespace setsquare
