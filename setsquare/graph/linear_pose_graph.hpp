// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// With headings known, a pose graph is linear in the positions (as in LAGO: carlone2014).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {
/// One constraint on the positions while the headings stay fixed: the conditional of its
/// Gaussian, given the rotation that the headings have.
///
///   r^T Omega r = e^T W e + what the positions do not change,   e = p_to - p_from - d
///
/// W is the translation's block of Omega, turned into the map frame; d is the measured translation
/// there, moved by -W^+ Omega_t,theta r_theta: a rotation that the headings do not follow pulls the
/// translation along.
struct PositionTerm {
  std::size_t from = 0;
  std::size_t to = 0;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();     ///< W, in 1/m^2.
  Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();  ///< d.
  int num_bound_axes = 0;                                    ///< Rank of W: 0, 1 or 2.
};

/// The term of a constraint. A direction without information in W gets no displacement.
[[nodiscard]] PositionTerm position_term(const PoseGraph& graph, const Constraint& constraint);

/// e^T W e at these positions: chi-squared with num_bound_axes degrees of freedom where the
/// constraint is right.
[[nodiscard]] double squared_error(const PositionTerm& term,
                                   std::span<const Eigen::Vector2d> positions_m);

/// The normal equations of the positions. The order of elimination is found once, then any weights
/// of the constraints are solved for.
class PositionSystem {
 public:
  /// Of a graph that validate() accepts; throws as it does.
  explicit PositionSystem(const PoseGraph& graph);
  ~PositionSystem();
  PositionSystem(PositionSystem&&) noexcept;
  PositionSystem& operator=(PositionSystem&&) noexcept;

  /// One term per constraint, in their order.
  [[nodiscard]] const std::vector<PositionTerm>& terms() const { return terms_; }

  /// Whether no term couples x with y: then they are solved apart.
  [[nodiscard]] bool is_separable() const { return is_separable_; }

  /// Moves the positions to the minimum of sum_k weight_k e_k^T W_k e_k; node 0 stays. It is the
  /// same from any positions, up to rounding: a second call from there takes out what rounding of
  /// the first has left. Throws ParameterError where a node is not connected.
  void solve(std::span<const double> weights, std::vector<Eigen::Vector2d>& positions_m);

 private:
  struct Equations;
  /// The number of sets of nodes connected by terms that bind at least this many axes.
  [[nodiscard]] std::size_t num_pieces(std::span<const double> weights, int num_axes) const;
  /// One step of x or y, or of both; each returns BlockEquations::factor(), or 0 and moves nothing.
  double step_axis(int axis,
                   std::span<const double> weights,
                   std::vector<Eigen::Vector2d>& positions_m);
  double step_both(std::span<const double> weights, std::vector<Eigen::Vector2d>& positions_m);

  std::size_t num_nodes_ = 0;
  std::vector<PositionTerm> terms_;
  bool is_separable_ = true;
  std::unique_ptr<Equations> equations_;
};

/// The positions of all nodes that minimise the constraints' weighted squared errors while the
/// headings stay as they are: one sparse linear solve, no initial value. A constraint whose
/// rotation disagrees with the headings pulls its translation along by its information
/// (off-diagonal terms). Node 0 stays. Where no constraint couples x with y in the map frame the
/// two axes are solved apart. Every node must be connected to node 0 by constraints that bind both
/// axes; throws ParameterError where one does not.
[[nodiscard]] std::vector<Eigen::Vector2d> solve_positions(const PoseGraph& graph);

}  // namespace setsquare
