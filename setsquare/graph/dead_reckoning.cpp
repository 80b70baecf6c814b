// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/dead_reckoning.hpp"

#include <algorithm>
#include <Eigen/LU>

namespace setsquare {
namespace {

/// A direction that odometry leaves open is off by about so much.
constexpr double kOpenSigma_m = 100.0;

}  // namespace

DeadReckoning::DeadReckoning(const PoseGraph& graph, const std::vector<PositionTerm>& terms)
    : positions_m_(graph.T_map_node.size(), Eigen::Vector2d::Zero()),
      covariances_m2_(graph.T_map_node.size(), Eigen::Matrix2d::Zero()) {
  std::vector<const PositionTerm*> step_to(graph.T_map_node.size(), nullptr);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const bool is_step = terms[k].to == terms[k].from + 1;
    if (is_step && graph.constraints[k].kind == ConstraintKind::kOdometry) {
      step_to[terms[k].to] = &terms[k];
    }
  }
  const Eigen::Matrix2d open = Eigen::Matrix2d::Identity() / (kOpenSigma_m * kOpenSigma_m);
  for (std::size_t node = 0; node < step_to.size(); ++node) {
    const PositionTerm* step = step_to[node];
    first_of_piece_.push_back(step != nullptr ? first_of_piece_.back() : node);
    if (step == nullptr) continue;
    positions_m_[node] = positions_m_[node - 1] + step->displacement_m;
    covariances_m2_[node] = covariances_m2_[node - 1] + (step->information + open).inverse();
  }
}

std::optional<double> DeadReckoning::squared_disagreement(const PositionTerm& closure) const {
  const auto [low, high] = std::minmax(closure.from, closure.to);
  if (first_of_piece_[low] != first_of_piece_[high]) return std::nullopt;
  const Eigen::Vector2d reckoned_m = positions_m_[closure.to] - positions_m_[closure.from];
  const Eigen::Vector2d e = reckoned_m - closure.displacement_m;
  const Eigen::Matrix2d covariance = covariances_m2_[high] - covariances_m2_[low];
  // (W^-1 + S)^-1 in a form that holds where W is singular.
  const Eigen::Matrix2d scale = Eigen::Matrix2d::Identity() + covariance * closure.information;
  return e.dot(closure.information * (scale.inverse() * e));
}

}  // namespace setsquare
