// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare::testing {

/// A robot's drive through the corridors of a building, a grid of blocks 12 m wide, and what a
/// mapper would have measured on the way: constraints whose noise is drawn from their information.
struct PoseGraphSimulation {
  std::size_t num_nodes = 500;  ///< 0.5 m apart.
  int num_blocks = 2;           ///< Along each axis.
  std::size_t num_closures = 150;
  double noise = 1.0;              ///< Factor on all noise; 0: exact.
  double odometry_sigma_m = 0.01;  ///< Of a step, along x and y.
  double closure_sigma_m = 0.02;
  double rotation_sigma_rad = rad_from_deg(0.1);  ///< Of constraints.
  double heading_sigma_rad = rad_from_deg(0.1);   ///< Of the nodes' headings and measurements.
};

struct SimulatedPoseGraph {
  std::vector<Pose2> truth;  ///< Node 0 at the origin.
  /// Headings near the truth, positions all at the origin.
  PoseGraph graph;
  /// One entry per constraint: closures that were verified together share one.
  std::vector<std::size_t> groups;
};

[[nodiscard]] SimulatedPoseGraph simulate_pose_graph(const PoseGraphSimulation& simulation,
                                                     std::mt19937_64& generator);

/// Kinds of wrong closures.
struct WrongClosures {
  double share = 0.3;          ///< Of all closures, the wrong ones included.
  std::size_t group_size = 1;  ///< Neighbours that claim the same wrong pose.
  /// Right closures moved by up to this distance; 0: any two places, wherever they are.
  double slip_m = 0.0;
};

/// Adds wrong closures with the information of right ones.
void inject(const WrongClosures& wrong, SimulatedPoseGraph& simulated, std::mt19937_64& generator);

/// Mean distance of the nodes to where they truly are, in m.
[[nodiscard]] double mean_position_error_m(const SimulatedPoseGraph& simulated);

/// A random symmetric positive definite 3x3 with sigmas about these, correlated.
[[nodiscard]] Eigen::Matrix3d random_covariance(double sigma_m,
                                                double sigma_rad,
                                                std::mt19937_64& generator);

}  // namespace setsquare::testing
