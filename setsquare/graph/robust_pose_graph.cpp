// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/robust_pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/node_sets.hpp"
#include "setsquare/graph/position_system.hpp"

namespace setsquare {
namespace {

/// The weight that is left, for the solve alone, to a refused closure between pieces of track that
/// odometry does not join: somewhere a piece must lie.
constexpr double kJoiningWeight = 1e-9;
/// Graduation ends here: weights between 0 and 1 lie within 0.1 % of the threshold.
constexpr double kLastMu = 1e3;

/// Closures that stand or fall together.
struct ClosureGroup {
  std::vector<std::size_t> members;  ///< Indices of constraints.
  double weight = 1.0;
  double squared_error = 0.0;  ///< Mean of the members', each as a share of its threshold.
};

/// The groups in the order in which their first closures come.
std::vector<ClosureGroup> group_closures(const PoseGraph& graph,
                                         std::span<const std::size_t> groups) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    if (graph.constraints[k].kind == ConstraintKind::kLoopClosure) order.push_back(k);
  }
  const auto group_of = [&groups](std::size_t k) { return groups.empty() ? k : groups[k]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return group_of(a) < group_of(b);
  });
  std::vector<ClosureGroup> result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || group_of(order[k]) != group_of(order[k - 1])) result.emplace_back();
    result.back().members.push_back(order[k]);
  }
  return result;
}

/// The value that chi-squared of one degree of freedom exceeds as rarely as chi-squared of two
/// exceeds `two_axes`: erfc(sqrt(x / 2)) = exp(-two_axes / 2), by bisection.
double threshold_of_one_axis(double two_axes) {
  const double probability = std::exp(-0.5 * two_axes);
  double low = 0.0;
  double high = two_axes;
  for (int step = 0; step < 100; ++step) {
    const double middle = 0.5 * (low + high);
    (std::erfc(std::sqrt(0.5 * middle)) > probability ? low : high) = middle;
  }
  return high;
}

/// yang2020, eq. (14), of a squared error as a share of the threshold.
double tls_weight(double squared_error, double mu) {
  if (squared_error <= mu / (mu + 1.0)) return 1.0;
  if (squared_error >= (mu + 1.0) / mu) return 0.0;
  return std::sqrt(mu * (mu + 1.0) / squared_error) - mu;
}

/// The state of a graduation: weights, and the positions that they lead to.
class Graduation {
 public:
  Graduation(const PoseGraph& graph,
             std::span<const std::size_t> groups,
             const RobustPoseGraphParams& params)
      : system_(graph),
        groups_(group_closures(graph, groups)),
        positions_m_(graph.T_map_node.size(), graph.T_map_node[0].translation()),
        two_axes_threshold_(params.max_squared_error),
        one_axis_threshold_(threshold_of_one_axis(params.max_squared_error)) {
    NodeSets pieces(graph.T_map_node.size());
    for (const Constraint& constraint : graph.constraints) {
      const bool is_odometry = constraint.kind == ConstraintKind::kOdometry;
      weights_.push_back(is_odometry ? constraint.weight : 1.0);
      if (is_odometry) pieces.join(constraint.from, constraint.to);
    }
    for (const Constraint& constraint : graph.constraints) {
      const bool is_joining = pieces.lowest(constraint.from) != pieces.lowest(constraint.to);
      least_weights_.push_back(is_joining ? kJoiningWeight : 0.0);
    }
  }

  /// Positions by the weights as they are, and the groups' squared errors there.
  void solve() {
    std::vector<double> weights = weights_;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      weights[k] = std::max(weights[k], least_weights_[k]);
    }
    system_.solve(weights, positions_m_);
    for (ClosureGroup& group : groups_) {
      double sum = 0.0;
      for (const std::size_t k : group.members) sum += share_of_threshold(k);
      group.squared_error = sum / static_cast<double>(group.members.size());
    }
  }

  [[nodiscard]] double largest_squared_error() const {
    double largest = 0.0;
    for (const ClosureGroup& group : groups_) largest = std::max(largest, group.squared_error);
    return largest;
  }

  /// Weights by the squared errors. False where all are 0 or 1 and were the same before.
  [[nodiscard]] bool reweight(double mu) {
    bool is_moving = false;
    for (ClosureGroup& group : groups_) {
      const double weight = tls_weight(group.squared_error, mu);
      is_moving = is_moving || weight != group.weight || (weight > 0.0 && weight < 1.0);
      group.weight = weight;
      for (const std::size_t k : group.members) weights_[k] = weight;
    }
    return is_moving;
  }

  void write_to(PoseGraph& graph) const {
    for (std::size_t k = 0; k < weights_.size(); ++k) graph.constraints[k].weight = weights_[k];
    for (std::size_t node = 0; node < positions_m_.size(); ++node) {
      graph.T_map_node[node].x_m = positions_m_[node].x();
      graph.T_map_node[node].y_m = positions_m_[node].y();
    }
  }

 private:
  [[nodiscard]] double share_of_threshold(std::size_t k) const {
    const PositionTerm& term = system_.terms()[k];
    return squared_error(term, positions_m_) /
           (term.num_bound_axes == 1 ? one_axis_threshold_ : two_axes_threshold_);
  }

  PositionSystem system_;
  std::vector<ClosureGroup> groups_;
  std::vector<Eigen::Vector2d> positions_m_;
  std::vector<double> weights_;
  std::vector<double> least_weights_;
  double two_axes_threshold_ = 0.0;
  double one_axis_threshold_ = 0.0;
};

}  // namespace

void RobustPoseGraphParams::validate() const {
  if (!(max_squared_error > 0.0 && max_squared_error <= 1000.0)) {
    throw ParameterError("max_squared_error", "must lie between 0 and 1000");
  }
  if (!(divide_mu_by > 1.0)) throw ParameterError("divide_mu_by", "must be above 1");
  if (max_iterations < 1) throw ParameterError("max_iterations", "must be positive");
}

void solve_robustly(PoseGraph& graph,
                    std::span<const std::size_t> groups,
                    const RobustPoseGraphParams& params) {
  params.validate();
  if (!groups.empty() && groups.size() != graph.constraints.size()) {
    throw ParameterError("groups", "must have one entry a constraint, or none");
  }
  if (graph.T_map_node.empty()) return;
  Graduation graduation(graph, groups, params);
  graduation.solve();
  graduation.solve();  // Takes out what rounding of the first has left.
  // Near convex at first: mu so small that every weight is above a half (yang2020, remark 5). The
  // step is made longer where the graduation would not end within max_iterations.
  const double largest = graduation.largest_squared_error();
  double mu = 1.0 / std::max(1.0 / kLastMu, 2.0 * largest - 1.0);
  const double num_steps = static_cast<double>(params.max_iterations);
  const double step = std::max(params.divide_mu_by, std::pow(kLastMu / mu, 1.0 / num_steps));
  for (int iteration = 0; iteration < params.max_iterations; ++iteration) {
    if (!graduation.reweight(mu)) break;
    graduation.solve();
    mu *= step;
  }
  graduation.write_to(graph);
}

}  // namespace setsquare
