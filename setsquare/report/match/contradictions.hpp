// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/point_set.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The points, in the observing scan's frame, that lie where that scan saw through: its beam that
/// passes nearest to the point and both neighbours returned from at least 0.3 m behind it. For
/// pictures; the matcher's own test weighs lengths of wall.
[[nodiscard]] std::vector<Eigen::Vector2d> contradictions(const Scan& observing,
                                                          const PointSet& points,
                                                          const Pose2& T_observing_points);

}  // namespace setsquare
