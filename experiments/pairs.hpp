// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "experiments/simulated_run.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/match_result.hpp"

namespace setsquare::experiments {

/// A pose nearer to the truth than both of these is a success (bando2014, section 5.1).
inline constexpr double kSuccess_m = 0.2;
inline constexpr double kSuccess_rad = rad_from_deg(30.0);
/// An answer `matched` that is further off than either of these is wrong.
inline constexpr double kWrong_m = 0.2;
inline constexpr double kWrong_rad = rad_from_deg(3.0);
/// The 95 % quantile of a chi-square variable of three degrees of freedom.
inline constexpr double kNees95 = 7.81;

/// A matcher's answer of one pair, judged by the truth.
struct PairAnswer {
  MatchStatus status = MatchStatus::kTooFewPoints;
  /// Answer less truth: (x, y) in m in the reference's frame, heading in rad; NaN where there is no
  /// pose.
  Eigen::Vector3d error = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// e^T Omega e of that error, where the answer is `matched` and its information has full rank.
  std::optional<double> nees = std::nullopt;

  [[nodiscard]] double error_m() const { return error.head<2>().norm(); }
  [[nodiscard]] double error_rad() const { return std::abs(error.z()); }
  [[nodiscard]] bool is_matched() const { return status == MatchStatus::kMatched; }
  [[nodiscard]] bool is_success() const {
    return error_m() <= kSuccess_m && error_rad() <= kSuccess_rad;
  }
  [[nodiscard]] bool is_wrong() const {
    return is_matched() && !(error_m() <= kWrong_m && error_rad() <= kWrong_rad);
  }
};

/// (x, y, theta) of an answered relative pose less the true one, theta in [-pi, pi).
[[nodiscard]] Eigen::Vector3d pose_error(const Pose2& answered, const Pose2& truth);

/// Judges an answer by the true relative pose.
[[nodiscard]] PairAnswer judge(const MatchResult& result, const Pose2& T_reference_current);

/// What is true of a pair of scans of one run.
struct PairTruth {
  std::size_t reference = 0;  ///< Places of the scans in their run.
  std::size_t current = 0;
  Pose2 T_reference_current;
  double overlap = 0.0;              ///< Share of the current scan's returns, 0 to 1.
  bool is_determined = false;        ///< By the floor plan.
  double worst_direction_rad = 0.0;  ///< The least determined one, in the reference's frame.
  double clutter_share = 0.0;        ///< Of the returns, mean of both scans.
};

/// A pair and what the matchers answer.
struct PairRecord {
  PairTruth truth;
  PairAnswer ours;   ///< The default matcher.
  PairAnswer paper;  ///< The paper's method.
};

/// Which pairs are matched, and by which matchers.
struct PairParams {
  double max_distance_m = 5.0;  ///< Between the true positions.
  bool has_paper = true;        ///< Otherwise the paper's answers stay empty.
  std::size_t every = 1;        ///< Of the pairs near enough only every n-th is matched.
  /// Decides overlap and determination: the scans' own scanner or, to keep the same pairs
  /// under fewer beams, a better one.
  ScannerModel judge_scanner = utm_30lx();
};

/// The pairs (reference before current) of a run that lie near enough, in the order of the scans.
[[nodiscard]] std::vector<PairRecord> match_pairs(const SimulatedRun& run,
                                                  const PairParams& params);

}  // namespace setsquare::experiments
