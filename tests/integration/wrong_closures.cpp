// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/integration/wrong_closures.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <optional>
#include <stdexcept>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/marginal_covariance.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing {
namespace {

/// Members of a group are this many keyframes apart, as a mapper's stations are.
constexpr std::size_t kStride = 3;
/// Differences of neighbouring closures, and the error of their rotation.
constexpr double kNoise_m = 0.01;
constexpr double kNoise_rad = rad_from_deg(0.2);

std::vector<double> ways_m(const PoseGraph& graph) {
  std::vector<double> way_m = {0.0};
  for (std::size_t k = 1; k < graph.T_map_node.size(); ++k) {
    const Eigen::Vector2d step =
        graph.T_map_node[k].translation() - graph.T_map_node[k - 1].translation();
    way_m.push_back(way_m.back() + step.norm());
  }
  return way_m;
}

/// Information in the frame of one heading, in that of another.
Eigen::Matrix3d turned(const Eigen::Matrix3d& information, double from_rad, double to_rad) {
  const double c = std::cos(from_rad - to_rad);
  const double s = std::sin(from_rad - to_rad);
  Eigen::Matrix3d R;
  R << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return R * information * R.transpose();
}

/// What the translation's information binds.
struct BoundAxes {
  explicit BoundAxes(const Eigen::Matrix2d& information) {
    const SymmetricEigen<2> eigen = symmetric_eigen(information);
    is_one_open = eigen.values[0] < 1e-6 * eigen.values[1];
    strong = eigen.vectors.col(1);
    least = eigen.values[is_one_open ? 1 : 0];
  }
  bool is_one_open = false;
  Eigen::Vector2d strong;
  double least = 0.0;  ///< Along the axis, of those bound, that is bound least.
};

class Injection {
 public:
  Injection(const PoseGraph& graph, const WrongClosureParams& params, std::mt19937_64& generator)
      : own_(graph), graph_(graph), params_(params), generator_(generator), way_m_(ways_m(graph)) {
    for (const Constraint& constraint : graph.constraints) {
      if (constraint.kind == ConstraintKind::kLoopClosure) closures_.push_back(constraint);
    }
    if (params.min_squared_disagreement > 0.0) known_.emplace(graph);
    if (closures_.empty()) throw std::invalid_argument("a graph without closures");
  }

  PoseGraph inject() {
    const double own = static_cast<double>(closures_.size());
    const double wrong = own * params_.share / (1.0 - params_.share);
    const auto num_groups =
        static_cast<std::size_t>(std::ceil(wrong / static_cast<double>(params_.group_size) - 1e-9));
    for (std::size_t group = 0; group < num_groups; ++group) add_group(group % 2 == 0);
    return std::move(graph_);
  }

 private:
  std::size_t draw(std::size_t num) {
    return std::uniform_int_distribution<std::size_t>(0, num - 1)(generator_);
  }
  double noise(double sigma) { return std::normal_distribution<double>(0.0, sigma)(generator_); }

  /// Two keyframes far from each other along the track, with room for a group behind them.
  std::pair<std::size_t, std::size_t> draw_places() {
    const std::size_t room = kStride * (params_.group_size - 1);
    for (int trial = 0; trial < 10000; ++trial) {
      const std::size_t a = draw(own_.T_map_node.size());
      const std::size_t b = draw(own_.T_map_node.size());
      if (b + room >= own_.T_map_node.size() || a + room >= own_.T_map_node.size()) continue;
      if (way_m_[std::max(a, b)] - way_m_[std::min(a, b)] < params_.min_way_m) continue;
      return std::minmax(a, b);
    }
    throw std::runtime_error("no two keyframes are far enough from each other");
  }

  /// How a closure with this information may be wrong: by a vector in the map frame, along an axis
  /// that it binds.
  Eigen::Vector2d draw_slip(const Eigen::Matrix2d& information_map) {
    const BoundAxes axes(information_map);
    const double length_m = uniform(generator_, params_.min_off_m, params_.max_slip_m);
    const double sign = uniform(generator_, -1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    if (axes.is_one_open) return sign * length_m * axes.strong;
    const double angle_rad = uniform(generator_, -kPi, kPi);
    return length_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
  }

  /// Whether the graph contradicts the closure. W and the vector by which a closure is off in the
  /// map frame.
  bool may_be_told(std::pair<std::size_t, std::size_t> places,
                   const Eigen::Vector2d& off_m,
                   const Eigen::Matrix2d& W) const {
    if (!known_) return true;
    const double c = std::cos(own_.T_map_node[places.first].theta_rad);
    const double s = std::sin(own_.T_map_node[places.first].theta_rad);
    Eigen::Matrix2d R;
    R << c, -s, s, c;
    const Eigen::Matrix2d covariance =
        R * known_->between(places.first, places.second).topLeftCorner<2, 2>() * R.transpose();
    // (W^-1 + covariance)^-1, W singular where an axis is open.
    const Eigen::Matrix2d scale = Eigen::Matrix2d::Identity() + covariance * W;
    return off_m.dot(W * (scale.inverse() * off_m)) >=
           params_.min_squared_disagreement * static_cast<double>(params_.group_size);
  }

  void add_group(bool is_slip) {
    const Constraint& model = closures_[draw(closures_.size())];
    const double model_rad = own_.T_map_node[model.from].theta_rad;
    const Eigen::Matrix3d information_map = turned(model.information, model_rad, 0.0);
    const Eigen::Matrix2d W = information_map.topLeftCorner<2, 2>();
    const double least = params_.min_off_m * params_.min_off_m * BoundAxes(W).least;
    Eigen::Vector2d off_m = Eigen::Vector2d::Zero();
    std::pair<std::size_t, std::size_t> first;
    do {
      first = draw_places();
      off_m = draw_slip(W);
      if (!is_slip) {  // The two places are the same, the slip aside.
        off_m += own_.T_map_node[first.first].translation() -
                 own_.T_map_node[first.second].translation();
      }
    } while (off_m.dot(W * off_m) < least || !may_be_told(first, off_m, W));
    for (std::size_t i = 0; i < params_.group_size; ++i) {
      add(first.first + kStride * i, first.second + kStride * i, off_m, information_map);
    }
  }

  void add(std::size_t from,
           std::size_t to,
           const Eigen::Vector2d& off_m,
           const Eigen::Matrix3d& information_map) {
    Pose2 T_map_wrong = own_.T_map_node[to];
    T_map_wrong.x_m += off_m.x() + noise(kNoise_m);
    T_map_wrong.y_m += off_m.y() + noise(kNoise_m);
    T_map_wrong.theta_rad += noise(kNoise_rad);
    const double from_rad = own_.T_map_node[from].theta_rad;
    graph_.constraints.push_back({.from = from,
                                  .to = to,
                                  .T_from_to = own_.T_map_node[from].inverse() * T_map_wrong,
                                  .information = turned(information_map, 0.0, from_rad),
                                  .kind = ConstraintKind::kLoopClosure,
                                  .weight = 1.0});
  }

  const PoseGraph& own_;
  PoseGraph graph_;
  const WrongClosureParams& params_;
  std::mt19937_64& generator_;
  std::vector<double> way_m_;
  std::vector<Constraint> closures_;
  std::optional<MarginalCovariance> known_;
};

}  // namespace

PoseGraph with_wrong_closures(const PoseGraph& graph,
                              const WrongClosureParams& params,
                              std::mt19937_64& generator) {
  return with_full_weights(Injection(graph, params, generator).inject());
}

PoseGraph with_full_weights(PoseGraph graph) {
  for (Constraint& constraint : graph.constraints) constraint.weight = 1.0;
  return graph;
}

std::size_t num_closures(const PoseGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.constraints.begin(), graph.constraints.end(), [](const Constraint& c) {
        return c.kind == ConstraintKind::kLoopClosure;
      }));
}

}  // namespace setsquare::testing
