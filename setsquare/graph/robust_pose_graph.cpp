// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/robust_pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/core/sort_by.hpp"
#include "setsquare/graph/dead_reckoning.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/node_sets.hpp"

namespace setsquare {
namespace {

/// The weight that is left, for the solve alone, to a refused closure between pieces of track that
/// odometry does not join: somewhere a piece must lie.
constexpr double kJoiningWeight = 1e-9;
/// Rounds over the refused groups, and steps in which weights settle after one was taken in.
constexpr int kMaxRounds = 3;
constexpr int kMaxSettlingSteps = 4;
/// Graduation ends here: weights between 0 and 1 lie within 0.1 % of the threshold.
constexpr double kLastMu = 1e3;

/// Closures that stand or fall together.
struct ClosureGroup {
  std::vector<std::size_t> members;  ///< Indices of constraints.
  bool is_in_play = true;
  bool is_held = false;  ///< At full weight, whatever its error.
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
  sort_by(order, [&](std::size_t k) { return groups[k]; });
  std::vector<ClosureGroup> result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || groups[order[k]] != groups[order[k - 1]]) result.emplace_back();
    result.back().members.push_back(order[k]);
  }
  return result;
}

/// The least weight of each constraint, for the solve alone.
std::vector<double> least_weights(const PoseGraph& graph) {
  NodeSets pieces(graph.T_map_node.size());
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind != ConstraintKind::kOdometry) continue;
    pieces.join(constraint.from, constraint.to);
  }
  std::vector<double> weights;
  for (const Constraint& constraint : graph.constraints) {
    const bool is_joining = pieces.lowest(constraint.from) != pieces.lowest(constraint.to);
    weights.push_back(is_joining ? kJoiningWeight : 0.0);
  }
  return weights;
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

/// The weight of GNC-TLS (yang2020) by a squared error as a share of the threshold.
double tls_weight(double squared_error, double mu) {
  if (squared_error <= mu / (mu + 1.0)) return 1.0;
  if (squared_error >= (mu + 1.0) / mu) return 0.0;
  return std::sqrt(mu * (mu + 1.0) / squared_error) - mu;
}

/// Weights, and the positions that they lead to.
struct RobustSolution {
  std::vector<double> weights;  ///< One per constraint.
  std::vector<Eigen::Vector2d> positions_m;
  double cost = 0.0;  ///< Truncated least squares, odometry included.
};

/// The graduation, and what it works on.
class Graduation {
 public:
  /// By the given groups; by the claims that the closures make where none are given.
  Graduation(const PoseGraph& graph,
             std::span<const std::size_t> groups,
             const RobustPoseGraphParams& params)
      : graph_(graph),
        params_(params),
        one_axis_threshold_(threshold_of_one_axis(params.max_squared_error)),
        system_(graph),
        reckoning_(graph, system_.terms()),
        least_weights_(least_weights(graph)) {
    groups_ = group_closures(
        graph,
        groups.empty() ? claims_of(graph, system_.terms(), params.place_m, params.max_squared_error)
                       : std::vector<std::size_t>(groups.begin(), groups.end()));
    solution_.positions_m.assign(graph.T_map_node.size(), graph.T_map_node[0].translation());
    for (const Constraint& constraint : graph.constraints) {
      solution_.weights.push_back(constraint.weight);
    }
  }

  /// From full weights of all groups.
  [[nodiscard]] RobustSolution from_all() {
    for (ClosureGroup& group : groups_) group.is_in_play = true;
    begin();
    graduate(first_mu());
    return solution();
  }

  /// From full weights of the groups that odometry does not contradict; at last all may join.
  /// Nothing where odometry contradicts none.
  [[nodiscard]] std::optional<RobustSolution> from_plausible() {
    bool is_any_out = false;
    for (ClosureGroup& group : groups_) {
      group.is_in_play = is_plausible(group);
      is_any_out = is_any_out || !group.is_in_play;
    }
    if (!is_any_out) return std::nullopt;
    begin();
    graduate(first_mu());
    for (ClosureGroup& group : groups_) group.is_in_play = true;
    graduate(1.0);
    return solution();
  }

  /// Takes in refused groups that odometry does not contradict, one after the other, where what
  /// they contradict then falls and the cost with it.
  void take_in_refused(RobustSolution& best) {
    for (int round = 0; round < kMaxRounds; ++round) {
      bool is_better = false;
      for (ClosureGroup& group : groups_) {
        if (best.weights[group.members.front()] >= 0.5 || !is_plausible(group)) continue;
        RobustSolution other = solution_with(group, best);
        if (!(other.cost < best.cost)) continue;
        best = std::move(other);
        is_better = true;
      }
      if (!is_better) return;
    }
  }

  /// Every closure for itself, from what the groups have decided: those that do not fit their group
  /// fall, those that fit though their group fell come back.
  [[nodiscard]] RobustSolution one_by_one(const RobustSolution& decided) {
    std::vector<std::size_t> alone(graph_.constraints.size());
    std::iota(alone.begin(), alone.end(), std::size_t{0});
    groups_ = group_closures(graph_, alone);
    begin_at(decided);
    judge();
    graduate(1.0);
    return solution();
  }

 private:
  /// Whether odometry's own covariance admits the group.
  [[nodiscard]] bool is_plausible(const ClosureGroup& group) const {
    return mean_share(group, [this](const PositionTerm& term) {
             return reckoning_.squared_disagreement(term).value_or(0.0);
           }) <= 1.0;
  }

  void begin_at(const RobustSolution& from) {
    solution_ = from;
    for (ClosureGroup& group : groups_) group.weight = from.weights[group.members.front()];
  }

  /// From a solution, a group at full weight first, then as its error says.
  [[nodiscard]] RobustSolution solution_with(ClosureGroup& group, const RobustSolution& from) {
    begin_at(from);
    set_weight(group, 1.0);
    group.is_held = true;
    solve();
    settle();
    group.is_held = false;
    settle();
    return solution();
  }

  void settle() {
    for (int step = 0; step < kMaxSettlingSteps && reweight(kLastMu); ++step) solve();
  }

  [[nodiscard]] double threshold(std::size_t k) const {
    return system_.terms()[k].num_bound_axes == 1 ? one_axis_threshold_ : params_.max_squared_error;
  }

  /// Mean over a group of squared_error_of(term), each as a share of its threshold.
  template <typename SquaredError>
  [[nodiscard]] double mean_share(const ClosureGroup& group,
                                  const SquaredError& squared_error_of) const {
    double sum = 0.0;
    for (const std::size_t k : group.members) {
      sum += squared_error_of(system_.terms()[k]) / threshold(k);
    }
    return sum / static_cast<double>(group.members.size());
  }

  void set_weight(ClosureGroup& group, double weight) {
    group.weight = weight;
    for (const std::size_t k : group.members) solution_.weights[k] = weight;
  }

  /// Full weights of the groups in play, and the positions by them.
  void begin() {
    for (ClosureGroup& group : groups_) set_weight(group, group.is_in_play ? 1.0 : 0.0);
    solve();
    solve();  // Takes out what rounding of the first has left.
  }

  /// Positions by the weights as they are, judged.
  void solve() {
    std::vector<double> weights = solution_.weights;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      weights[k] = std::max(weights[k], least_weights_[k]);
    }
    system_.solve(weights, solution_.positions_m);
    judge();
  }

  /// The groups' squared errors at the positions as they are.
  void judge() {
    for (ClosureGroup& group : groups_) {
      group.squared_error = mean_share(group, [this](const PositionTerm& term) {
        return squared_error(term, solution_.positions_m);
      });
    }
  }

  /// Near convex: so small that no weight in play vanishes at first (yang2020).
  [[nodiscard]] double first_mu() const {
    double largest = 0.0;
    for (const ClosureGroup& group : groups_) {
      if (group.is_in_play) largest = std::max(largest, group.squared_error);
    }
    return 1.0 / std::max(1.0 / kLastMu, 2.0 * largest - 1.0);
  }

  /// Weights by the squared errors. False where all are 0 or 1 and were the same before.
  [[nodiscard]] bool reweight(double mu) {
    bool is_moving = false;
    for (ClosureGroup& group : groups_) {
      double weight = group.is_in_play ? tls_weight(group.squared_error, mu) : 0.0;
      if (group.is_held) weight = 1.0;
      is_moving = is_moving || weight != group.weight || (weight > 0.0 && weight < 1.0);
      set_weight(group, weight);
    }
    return is_moving;
  }

  /// The step of mu is longer than asked for where the graduation would not end in time.
  void graduate(double mu) {
    const double num_steps = static_cast<double>(params_.max_iterations);
    const double step = std::max(params_.mu_growth, std::pow(kLastMu / mu, 1.0 / num_steps));
    for (int iteration = 0; iteration < params_.max_iterations && reweight(mu); ++iteration) {
      solve();
      mu *= step;
    }
  }

  [[nodiscard]] RobustSolution solution() const {
    RobustSolution result = solution_;
    result.cost = 0.0;
    for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
      if (graph_.constraints[k].kind != ConstraintKind::kOdometry) continue;
      result.cost += result.weights[k] * squared_error(system_.terms()[k], result.positions_m);
    }
    for (const ClosureGroup& group : groups_) {
      const double share = std::min(1.0, group.squared_error);
      for (const std::size_t k : group.members) result.cost += share * threshold(k);
    }
    return result;
  }

  const PoseGraph& graph_;
  const RobustPoseGraphParams& params_;
  double one_axis_threshold_ = 0.0;
  PositionSystem system_;
  DeadReckoning reckoning_;
  std::vector<ClosureGroup> groups_;
  std::vector<double> least_weights_;
  RobustSolution solution_;
};

void write_to(PoseGraph& graph, const RobustSolution& solution) {
  for (std::size_t k = 0; k < solution.weights.size(); ++k) {
    graph.constraints[k].weight = solution.weights[k];
  }
  for (std::size_t node = 0; node < solution.positions_m.size(); ++node) {
    graph.T_map_node[node].x_m = solution.positions_m[node].x();
    graph.T_map_node[node].y_m = solution.positions_m[node].y();
  }
}

}  // namespace

void RobustPoseGraphParams::validate() const {
  if (!(max_squared_error > 0.0 && max_squared_error <= 1000.0)) {
    throw ParameterError("max_squared_error", "must lie between 0 and 1000");
  }
  if (!(place_m >= 0.0 && place_m <= 1000.0)) {
    throw ParameterError("place_m", "must lie between 0 and 1000");
  }
  if (!(mu_growth > 1.0)) throw ParameterError("mu_growth", "must be above 1");
  if (max_iterations < 1) throw ParameterError("max_iterations", "must be positive");
}

void solve_robustly(PoseGraph& graph,
                    std::span<const std::size_t> groups,
                    const RobustPoseGraphParams& params) {
  params.validate();
  if (!groups.empty() && groups.size() != graph.constraints.size()) {
    throw ParameterError("groups", "must have one entry per constraint, or none");
  }
  if (graph.T_map_node.empty()) return;
  Graduation graduation(graph, groups, params);
  RobustSolution best = graduation.from_all();
  const bool is_any_refused = std::ranges::any_of(best.weights, [](double w) { return w < 0.5; });
  if (is_any_refused) {
    const auto second = graduation.from_plausible();
    if (second && second->cost < best.cost) best = *second;
    graduation.take_in_refused(best);
  }
  if (groups.empty()) best = graduation.one_by_one(best);
  write_to(graph, best);
}

}  // namespace setsquare
