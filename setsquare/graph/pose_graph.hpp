// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Where a constraint comes from.
enum class ConstraintKind {
  kOdometry,     ///< Between neighbours of the track: always of full weight.
  kLoopClosure,  ///< Between places visited twice: counts by its weight.
};

/// A measured relative pose of two nodes.
struct Constraint {
  std::size_t from = 0;  ///< Index of the node from which the other is seen.
  std::size_t to = 0;    ///< Index of the node that is seen.
  Pose2 T_from_to;       ///< The measured pose of node `to` in node `from`.
  /// Of (x, y, theta) of T_from_to, in the frame of `from`, in 1/m^2, 1/(m rad), 1/rad^2: symmetric
  /// and positive semi-definite; singular where the constraint leaves a direction open.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  ConstraintKind kind = ConstraintKind::kOdometry;  ///< Whether its weight may fall.
  double weight = 1.0;                              ///< 0 to 1, multiplies the information.
  /// What the maker of the graph made it of, in the maker's own numbers; no solver looks at it.
  std::size_t source = 0;
};

/// A heading measured against the building.
struct HeadingMeasurement {
  std::size_t node = 0;               ///< Index of the node whose heading it is.
  double heading_rad = 0.0;           ///< In the map frame; compared modulo a whole turn.
  double information_per_rad2 = 0.0;  ///< Robust weight included.
};

/// Poses and what was measured between them. Node 0 is held where it is: it fixes the map frame.
struct PoseGraph {
  std::vector<Pose2> T_map_node;             ///< Poses of the nodes in the map frame.
  std::vector<Constraint> constraints;       ///< Between two nodes each.
  std::vector<HeadingMeasurement> headings;  ///< Of single nodes.
};

/// Residual (x, y, theta) of a constraint: T_from_to by the nodes less the measured one, in the
/// frame of `from`; the angle is wrapped.
[[nodiscard]] Eigen::Vector3d residual(const PoseGraph& graph, const Constraint& constraint);

/// Squared Mahalanobis length of the residual, r^T Omega r, without the weight.
[[nodiscard]] double squared_error(const PoseGraph& graph, const Constraint& constraint);

/// Throws ParameterError where a constraint names a node that is not there, or information or a
/// pose is not finite.
void validate(const PoseGraph& graph);

}  // namespace setsquare
