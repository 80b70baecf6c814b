// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Relations between poses as a measure of a trajectory: Kuemmerle et al. 2009, "On measuring the
// accuracy of SLAM algorithms", Autonomous Robots 27.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/relation.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/eval/bootstrap.hpp"
#include "setsquare/eval/error_series.hpp"

namespace setsquare {

/// Mean and sample standard deviation (n - 1); the latter is 0 for fewer than two values.
struct MeanAndDeviation {
  double mean = 0.0;                                    ///< Of the values, in their unit.
  double deviation = 0.0;                               ///< In the same unit.
  std::optional<ErrorBound> mean_bound = std::nullopt;  ///< Where it was asked for.
};

/// The errors of a set of relations.
struct RelationErrors {
  std::size_t num_relations = 0;            ///< That were compared.
  MeanAndDeviation translation_m;           ///< |trans(e)|.
  MeanAndDeviation squared_translation_m2;  ///< |trans(e)|^2, as the benchmark prints it.
  MeanAndDeviation rotation_rad;            ///< |rot(e)|, wrapped.
  MeanAndDeviation squared_rotation_rad2;   ///< |rot(e)|^2, as the benchmark prints it.
};

/// The error of a trajectory, over all relations and by the time between their stamps.
struct RelationErrorReport {
  RelationErrors all;  ///< Of every relation both of whose stamps have a pose.
  /// Of those with less than 60 s between their stamps: how well neighbours fit.
  RelationErrors under_60_s;
  RelationErrors from_60_s;     ///< Of those with 60 s and more: how well the map closes.
  std::size_t num_missing = 0;  ///< Relations with a stamp that the trajectory does not have.
};

/// Scores a trajectory: for each relation with expected pose d and estimate p1^-1 p2, the error is
/// e = (p1^-1 p2) d^-1. Stamps are matched to the nearest pose within 12 microseconds (relations
/// and trajectories round theirs); the order of the trajectory does not matter. Every line of the
/// relations counts, repeated ones too. With bounds of the means where they are asked for, the
/// relations taken in the order of their first stamps.
[[nodiscard]] RelationErrorReport relation_error(
    const Trajectory& trajectory,
    std::span<const Relation> relations,
    const std::optional<BootstrapParams>& bootstrap = std::nullopt);

/// The errors of the relations both of whose stamps have a pose.
struct RelationErrorSeries {
  ErrorSeries errors;           ///< By the stamps from which the other pose is seen.
  std::vector<double> seconds;  ///< Between the two stamps of each.
  std::size_t num_missing = 0;  ///< As RelationErrorReport has it.
};
/// What relation_error() sums up.
[[nodiscard]] RelationErrorSeries relation_errors(const Trajectory& trajectory,
                                                  std::span<const Relation> relations);

}  // namespace setsquare
