// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <memory>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {

/// How certain poses are, given all constraints at their weights and the heading measurements, with
/// node 0's position held. Factors once, then answers any node.
class MarginalCovariance {
 public:
  explicit MarginalCovariance(const PoseGraph& graph);
  ~MarginalCovariance();
  MarginalCovariance(MarginalCovariance&&) noexcept;
  MarginalCovariance& operator=(MarginalCovariance&&) noexcept;

  /// Covariance of (x, y, theta) of a node in the map frame, in m^2, m rad, rad^2.
  [[nodiscard]] Eigen::Matrix3d of(std::size_t node) const;

  /// Covariance of the relative pose (x, y, theta) of `to` in the frame of `from`.
  [[nodiscard]] Eigen::Matrix3d between(std::size_t from, std::size_t to) const;

  /// Covariance of the way (x, y) from one node to another, in the map frame, in m^2: that of the
  /// position where `from` is node 0. Unlike between() it is free of the heading of `from`.
  [[nodiscard]] Eigen::Matrix2d of_way(std::size_t from, std::size_t to) const;

  /// Variance of a node's heading in the map frame, in rad^2; 0 of node 0 where no heading was
  /// measured: then it is held.
  [[nodiscard]] double of_heading(std::size_t node) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace setsquare
