// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Errors against ground truth, one call each.
#pragma once

#include <optional>
#include <span>

#include "setsquare/core/relation.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/eval/absolute_trajectory_error.hpp"
#include "setsquare/eval/bootstrap.hpp"
#include "setsquare/eval/relation_error.hpp"

namespace setsquare {

/// The absolute error (ATE; m, rad) against a true trajectory: poses are paired by their stamps,
/// within 12 microseconds, and the trajectory is laid onto the truth by the best rigid motion.
/// With bounds where they are asked for. Throws ParameterError where no pose has a partner.
[[nodiscard]] AbsoluteTrajectoryError evaluate(
    const Trajectory& trajectory,
    const Trajectory& truth,
    const std::optional<BootstrapParams>& bootstrap = std::nullopt);

/// The error by relations between poses (m, rad; Kuemmerle et al. 2009), with bounds where they are
/// asked for.
[[nodiscard]] RelationErrorReport evaluate(
    const Trajectory& trajectory,
    std::span<const Relation> relations,
    const std::optional<BootstrapParams>& bootstrap = std::nullopt);

}  // namespace setsquare
