// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/linear_pose_graph.hpp"

#include <cassert>
#include <cmath>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/block_equations.hpp"
#include "setsquare/graph/node_sets.hpp"

namespace setsquare {
namespace {

/// Shares of a term's larger eigenvalue: below the first a direction is not bound, below the second
/// x and y are not coupled; both far above rounding and far below the information of a measurement.
constexpr double kUnboundShare = 1e-9;
constexpr double kUncoupledShare = 1e-13;
/// Share of a diagonal entry below which its pivot is rounding alone.
constexpr double kDoubtfulPivot = 1e-12;

/// W^+ and the rank of W; W symmetric and positive semi-definite.
struct PseudoInverse {
  explicit PseudoInverse(const Eigen::Matrix2d& W) {
    const SymmetricEigen<2> eigen = symmetric_eigen_direct(W);
    const double largest = eigen.values[1];
    for (int k = 0; k < 2; ++k) {
      const double eigenvalue = eigen.values[k];
      if (!(eigenvalue > kUnboundShare * largest)) continue;
      const Eigen::Vector2d direction = eigen.vectors.col(k);
      matrix += direction * direction.transpose() / eigenvalue;
      ++rank;
    }
  }
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  int rank = 0;
};

std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const std::vector<PositionTerm>& terms) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  pairs.reserve(terms.size());
  for (const PositionTerm& term : terms) pairs.emplace_back(term.from, term.to);
  return pairs;
}

/// Adds one term to the equations of a step from where the residual is e; node 0 is held.
template <int size>
void add_term(BlockEquations<size>& equations,
              std::size_t k,
              const PositionTerm& term,
              const Eigen::Matrix<double, size, size>& W,
              const Eigen::Matrix<double, size, 1>& e) {
  if (term.from != 0) {
    equations.add_diagonal(term.from, W);
    equations.add_to_b(term.from, W * e);
  }
  if (term.to != 0) {
    equations.add_diagonal(term.to, W);
    equations.add_to_b(term.to, -W * e);
  }
  if (term.from != 0 && term.to != 0) equations.add_pair(k, -W);
}

Eigen::Vector2d residual_of(const PositionTerm& term,
                            std::span<const Eigen::Vector2d> positions_m) {
  return positions_m[term.to] - positions_m[term.from] - term.displacement_m;
}

}  // namespace

PositionTerm position_term(const PoseGraph& graph, const Constraint& constraint) {
  const double heading_rad = graph.T_map_node[constraint.from].theta_rad;
  const double turned_rad = wrap_to_pi(graph.T_map_node[constraint.to].theta_rad - heading_rad -
                                       constraint.T_from_to.theta_rad);
  const Eigen::Matrix2d R = rotation_matrix(heading_rad);
  const Eigen::Matrix2d W = constraint.information.topLeftCorner<2, 2>();
  const Eigen::Vector2d coupling = constraint.information.topRightCorner<2, 1>();
  const PseudoInverse inverse(W);

  PositionTerm term{.from = constraint.from, .to = constraint.to};
  term.num_bound_axes = inverse.rank;
  term.information = R * W * R.transpose();
  term.displacement_m =
      R * (constraint.T_from_to.translation() - inverse.matrix * coupling * turned_rad);
  const double cross = 0.5 * (term.information(0, 1) + term.information(1, 0));
  const bool is_coupled = std::abs(cross) > kUncoupledShare * term.information.trace();
  term.information(0, 1) = term.information(1, 0) = is_coupled ? cross : 0.0;
  return term;
}

double squared_error(const PositionTerm& term, std::span<const Eigen::Vector2d> positions_m) {
  const Eigen::Vector2d e = residual_of(term, positions_m);
  return e.dot(term.information * e);
}

/// x and y apart, one after the other in the same memory; or both together.
struct PositionSystem::Equations {
  std::unique_ptr<BlockEquations<1>> one_axis;
  std::unique_ptr<BlockEquations<2>> both_axes;
};

PositionSystem::PositionSystem(const PoseGraph& graph)
    : num_nodes_(graph.T_map_node.size()), equations_(std::make_unique<Equations>()) {
  validate(graph);
  terms_.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) {
    terms_.push_back(position_term(graph, constraint));
    is_separable_ = is_separable_ && terms_.back().information(0, 1) == 0.0;
  }
  if (is_separable_) {
    equations_->one_axis = std::make_unique<BlockEquations<1>>(num_nodes_, pairs_of(terms_));
  } else {
    equations_->both_axes = std::make_unique<BlockEquations<2>>(num_nodes_, pairs_of(terms_));
  }
}

PositionSystem::~PositionSystem() = default;
PositionSystem::PositionSystem(PositionSystem&&) noexcept = default;
PositionSystem& PositionSystem::operator=(PositionSystem&&) noexcept = default;

std::size_t PositionSystem::num_pieces(std::span<const double> weights, int num_axes) const {
  NodeSets sets(num_nodes_);
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (terms_[k].num_bound_axes < num_axes || !(weights[k] > 0.0)) continue;
    sets.join(terms_[k].from, terms_[k].to);
  }
  return sets.num_sets();
}

void PositionSystem::solve(std::span<const double> weights,
                           std::vector<Eigen::Vector2d>& positions_m) {
  assert(weights.size() == terms_.size());
  assert(positions_m.size() == num_nodes_);
  if (num_nodes_ == 0) return;
  if (num_pieces(weights, 1) > 1) throw ParameterError("constraints", "leave nodes without a hold");
  const double smallest_pivot = is_separable_ ? std::min(step_axis(0, weights, positions_m),
                                                         step_axis(1, weights, positions_m))
                                              : step_both(weights, positions_m);
  // Weak constraints in a long chain make small pivots, too: these are judged only where some node
  // is connected to the others by one axis at a time.
  const bool is_doubtful = !(smallest_pivot > kDoubtfulPivot);
  if (!(smallest_pivot > 0.0) || (is_doubtful && num_pieces(weights, 2) > 1)) {
    throw ParameterError("constraints", "leave the position of a node open along an axis");
  }
}

double PositionSystem::step_axis(int axis,
                                 std::span<const double> weights,
                                 std::vector<Eigen::Vector2d>& positions_m) {
  BlockEquations<1>& equations = *equations_->one_axis;
  equations.set_zero();
  equations.add_diagonal(0, BlockEquations<1>::Block::Ones());
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const double W = weights[k] * terms_[k].information(axis, axis);
    const double e = residual_of(terms_[k], positions_m)[axis];
    add_term<1>(equations,
                k,
                terms_[k],
                BlockEquations<1>::Block::Constant(W),
                BlockEquations<1>::Segment::Constant(e));
  }
  const double smallest_pivot = equations.factor();
  if (!(smallest_pivot > 0.0)) return 0.0;
  const Eigen::VectorXd step = equations.solve(equations.b);
  for (std::size_t node = 1; node < num_nodes_; ++node) positions_m[node][axis] += step[node];
  return smallest_pivot;
}

double PositionSystem::step_both(std::span<const double> weights,
                                 std::vector<Eigen::Vector2d>& positions_m) {
  BlockEquations<2>& equations = *equations_->both_axes;
  equations.set_zero();
  equations.add_diagonal(0, Eigen::Matrix2d::Identity());
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    add_term<2>(equations,
                k,
                terms_[k],
                weights[k] * terms_[k].information,
                residual_of(terms_[k], positions_m));
  }
  const double smallest_pivot = equations.factor();
  if (!(smallest_pivot > 0.0)) return 0.0;
  const Eigen::VectorXd step = equations.solve(equations.b);
  for (std::size_t node = 1; node < num_nodes_; ++node) {
    positions_m[node] += step.segment<2>(2 * static_cast<Eigen::Index>(node));
  }
  return smallest_pivot;
}

std::vector<Eigen::Vector2d> solve_positions(const PoseGraph& graph) {
  PositionSystem system(graph);
  if (graph.T_map_node.empty()) return {};
  std::vector<double> weights;
  weights.reserve(graph.constraints.size());
  for (const Constraint& constraint : graph.constraints) weights.push_back(constraint.weight);
  std::vector<Eigen::Vector2d> positions_m(graph.T_map_node.size(),
                                           graph.T_map_node[0].translation());
  system.solve(weights, positions_m);
  system.solve(weights, positions_m);  // Takes out what rounding of the first has left.
  return positions_m;
}

}  // namespace setsquare
