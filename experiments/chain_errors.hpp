// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/floor_plan.hpp"

namespace setsquare::experiments {

/// Heading of a chain against the truth, along the way, in rad.
struct HeadingErrors {
  double highest_rad = 0.0;          ///< Of the absolute errors.
  double mean_rad = 0.0;             ///< Of the absolute errors.
  double end_rad = 0.0;              ///< Absolute error of the last scan.
  double slope_rad_per_100_m = 0.0;  ///< Of the line through error against distance.
  std::size_t num_wrong_turns = 0;   ///< Steps that turn wrongly by more than 45 deg.
  /// The same errors modulo 90 deg, as the walls measure the heading.
  double square_mean_rad = 0.0;
  double square_end_rad = 0.0;
  double square_slope_rad_per_100_m = 0.0;
};

/// Direction of a plan's walls in the map frame, modulo 90 deg, in rad: their mean, weighted by
/// length.
[[nodiscard]] double axis_of_plan(const FloorPlan& plan);

/// The chain moved rigidly to begin at the first true position. Its axes are the building's: they
/// come to lie along `axis_rad`, in the quarter turn nearest to the first true heading.
[[nodiscard]] std::vector<Pose2> placed_at_truth(std::span<const Pose2> chain,
                                                 std::span<const Pose2> truth,
                                                 double axis_rad);

/// Distance travelled up to each pose, in m.
[[nodiscard]] std::vector<double> travelled_m(std::span<const Pose2> poses);

/// Both sequences in one frame, one pose per scan, at least two.
[[nodiscard]] HeadingErrors heading_errors(std::span<const Pose2> chain,
                                           std::span<const Pose2> truth);

/// Translation from one scan to another as the chain has it, less the true one, in m along the axes
/// of the map frame; each is taken in the frame of the scan that it starts from.
[[nodiscard]] Eigen::Vector2d closure_error(std::span<const Pose2> chain,
                                            std::span<const Pose2> truth,
                                            std::size_t start,
                                            std::size_t end);

}  // namespace setsquare::experiments
