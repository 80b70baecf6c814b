// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/dead_reckoning.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/core/sort_by.hpp"
#include "setsquare/graph/node_sets.hpp"

namespace setsquare {
namespace {

/// Typical error along a direction that odometry leaves open.
constexpr double kOpenSigma_m = 100.0;
/// Added to the information of two closures together, in 1/m^2: a direction that neither binds.
constexpr double kNoInformation = 1e-9;

/// (W^-1 + S)^-1 in a form that holds where W is singular.
Eigen::Matrix2d loosened(const Eigen::Matrix2d& W, const Eigen::Matrix2d& S) {
  const Eigen::Matrix2d scale = Eigen::Matrix2d::Identity() + S * W;
  return W * scale.inverse();
}

/// What a closure says of the way from its earlier node to its later one.
struct TrackClosure {
  explicit TrackClosure(const PositionTerm& term)
      : low(std::min(term.from, term.to)),
        high(std::max(term.from, term.to)),
        way_m(term.from == low ? term.displacement_m : -term.displacement_m) {}
  std::size_t low = 0;
  std::size_t high = 0;
  Eigen::Vector2d way_m;
};

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
    ways_m_.push_back(node > 0 ? ways_m_.back() : 0.0);
    if (step == nullptr) continue;
    ways_m_.back() += step->displacement_m.norm();
    positions_m_[node] = positions_m_[node - 1] + step->displacement_m;
    covariances_m2_[node] = covariances_m2_[node - 1] + (step->information + open).inverse();
  }
}

std::optional<double> DeadReckoning::squared_disagreement(const PositionTerm& closure) const {
  const auto [low, high] = std::minmax(closure.from, closure.to);
  if (first_of_piece_[low] != first_of_piece_[high]) return std::nullopt;
  const Eigen::Vector2d reckoned_m = positions_m_[closure.to] - positions_m_[closure.from];
  const Eigen::Vector2d e = reckoned_m - closure.displacement_m;
  const Eigen::Matrix2d covariance = covariance_m2(low, high);
  return e.dot(loosened(closure.information, covariance) * e);
}

Eigen::Matrix2d DeadReckoning::covariance_m2(std::size_t i, std::size_t j) const {
  return covariances_m2_[std::max(i, j)] - covariances_m2_[std::min(i, j)];
}

bool DeadReckoning::agree(const PositionTerm& a,
                          const PositionTerm& b,
                          double max_squared_error) const {
  const TrackClosure first(a);
  const TrackClosure second(b);
  if (first_of_piece_[first.low] != first_of_piece_[second.low] ||
      first_of_piece_[first.high] != first_of_piece_[second.high]) {
    return false;
  }
  const Eigen::Vector2d to_second_m = positions_m_[second.low] - positions_m_[first.low];
  const Eigen::Vector2d back_m = positions_m_[first.high] - positions_m_[second.high];
  const Eigen::Vector2d e = first.way_m - (to_second_m + second.way_m + back_m);
  const Eigen::Matrix2d between =
      covariance_m2(first.low, second.low) + covariance_m2(first.high, second.high);
  // The information of e: (Wa^-1 + Wb^-1 + between)^-1.
  const Eigen::Matrix2d Wb = loosened(b.information, between);
  const Eigen::Matrix2d sum = a.information + Wb + kNoInformation * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d W = a.information * sum.inverse() * Wb;
  return e.dot(W * e) <= max_squared_error;
}

std::vector<std::size_t> claims_of(const PoseGraph& graph,
                                   const std::vector<PositionTerm>& terms,
                                   double place_m,
                                   double max_squared_error) {
  const DeadReckoning reckoning(graph, terms);
  const auto high_way_m = [&](std::size_t k) {
    return reckoning.way_m(std::max(terms[k].from, terms[k].to));
  };
  const auto low_way_m = [&](std::size_t k) {
    return reckoning.way_m(std::min(terms[k].from, terms[k].to));
  };
  std::vector<std::size_t> closures;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (graph.constraints[k].kind == ConstraintKind::kLoopClosure) closures.push_back(k);
  }
  sort_by(closures, high_way_m);
  NodeSets sets(terms.size());
  for (std::size_t i = 0; i < closures.size(); ++i) {
    for (std::size_t j = i; j-- > 0;) {
      const std::size_t a = closures[i];
      const std::size_t b = closures[j];
      if (high_way_m(a) - high_way_m(b) >= place_m) break;
      if (std::abs(low_way_m(a) - low_way_m(b)) >= place_m) continue;
      if (reckoning.agree(terms[a], terms[b], max_squared_error)) sets.join(a, b);
    }
  }
  std::vector<std::size_t> claims(terms.size());
  for (std::size_t k = 0; k < claims.size(); ++k) claims[k] = sets.lowest(k);
  return claims;
}

}  // namespace setsquare
