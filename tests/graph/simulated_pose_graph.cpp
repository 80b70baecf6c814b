// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/graph/simulated_pose_graph.hpp"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace setsquare::testing {
namespace {

constexpr double kStep_m = 0.5;
constexpr int kStepsPerBlock = 24;

double uniform_within(std::mt19937_64& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

std::size_t index_below(std::mt19937_64& generator, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(generator);
}

Eigen::Vector3d draw(const Eigen::Matrix3d& covariance, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d sample;
  for (double& value : sample) value = normal(generator);
  return Eigen::LLT<Eigen::Matrix3d>(covariance).matrixL() * sample;
}

/// From crossing to crossing, straight on or around a corner, never back.
std::vector<Pose2> drive(const PoseGraphSimulation& simulation, std::mt19937_64& generator) {
  constexpr int kDx[4] = {1, 0, -1, 0};
  constexpr int kDy[4] = {0, 1, 0, -1};
  std::vector<Pose2> poses;
  int x = 0;  // In steps.
  int y = 0;
  int direction = 0;
  const int end = simulation.num_blocks * kStepsPerBlock;
  while (poses.size() < simulation.num_nodes) {
    poses.push_back({kStep_m * x, kStep_m * y, wrap_to_pi(0.5 * kPi * direction)});
    if (poses.size() > 1 && x % kStepsPerBlock == 0 && y % kStepsPerBlock == 0) {
      int turned = 0;
      do {
        turned = (direction + 3 + static_cast<int>(index_below(generator, 3))) % 4;
      } while (x + kDx[turned] < 0 || x + kDx[turned] > end || y + kDy[turned] < 0 ||
               y + kDy[turned] > end);
      direction = turned;
    }
    x += kDx[direction];
    y += kDy[direction];
  }
  return poses;
}

/// A constraint with noise of its covariance.
Constraint measure(const std::vector<Pose2>& truth,
                   std::size_t from,
                   std::size_t to,
                   const Eigen::Matrix3d& covariance,
                   double noise,
                   std::mt19937_64& generator) {
  const Eigen::Vector3d drawn = noise * draw(covariance, generator);
  Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = truth[from].inverse() * truth[to];
  constraint.T_from_to.x_m += drawn.x();
  constraint.T_from_to.y_m += drawn.y();
  constraint.T_from_to.theta_rad = wrap_to_pi(constraint.T_from_to.theta_rad + drawn.z());
  constraint.information = covariance.inverse();
  constraint.information =
      (0.5 * (constraint.information + constraint.information.transpose())).eval();
  return constraint;
}

bool is_revisit(const std::vector<Pose2>& truth, std::size_t from, std::size_t to) {
  return to > from + 40 && (truth[to].translation() - truth[from].translation()).norm() < 1.2;
}

/// None where the drive never comes back to where it was.
void add_closures(const PoseGraphSimulation& simulation,
                  SimulatedPoseGraph& simulated,
                  std::mt19937_64& generator) {
  const std::vector<Pose2>& truth = simulated.truth;
  std::vector<std::pair<std::size_t, std::size_t>> revisits;
  for (std::size_t from = 0; from < truth.size(); ++from) {
    for (std::size_t to = from + 1; to < truth.size(); ++to) {
      if (is_revisit(truth, from, to)) revisits.emplace_back(from, to);
    }
  }
  if (revisits.empty()) return;
  for (std::size_t added = 0; added < simulation.num_closures; ++added) {
    const auto [from, to] = revisits[index_below(generator, revisits.size())];
    const Eigen::Matrix3d covariance =
        random_covariance(simulation.closure_sigma_m, simulation.rotation_sigma_rad, generator);
    simulated.graph.constraints.push_back(
        measure(truth, from, to, covariance, simulation.noise, generator));
    simulated.graph.constraints.back().kind = ConstraintKind::kLoopClosure;
    simulated.groups.push_back(simulated.groups.size());
  }
}

/// What a closure claims; the closure that its information is taken from is right.
Constraint false_claim(const WrongClosures& wrong,
                       const SimulatedPoseGraph& simulated,
                       const Constraint& right,
                       std::mt19937_64& generator) {
  Constraint claim = right;
  if (wrong.slip_m > 0.0) {
    do {
      claim.T_from_to.x_m = uniform_within(generator, -wrong.slip_m, wrong.slip_m);
      claim.T_from_to.y_m = uniform_within(generator, -wrong.slip_m, wrong.slip_m);
    } while ((claim.T_from_to.translation() - right.T_from_to.translation()).norm() < 0.5);
    return claim;
  }
  const std::size_t num_nodes = simulated.truth.size();
  do {
    claim.from = index_below(generator, num_nodes - 10);
    claim.to = index_below(generator, num_nodes - 10);
  } while (claim.to <= claim.from + 20 || is_revisit(simulated.truth, claim.from, claim.to));
  // The headings are right: only the translation is wrong.
  claim.T_from_to = simulated.truth[claim.from].inverse() * simulated.truth[claim.to];
  claim.T_from_to.x_m = uniform_within(generator, -1.0, 1.0);
  claim.T_from_to.y_m = uniform_within(generator, -1.0, 1.0);
  return claim;
}

}  // namespace

Eigen::Matrix3d random_covariance(double sigma_m, double sigma_rad, std::mt19937_64& generator) {
  Eigen::Matrix3d correlation;
  const double xy = uniform_within(generator, -0.4, 0.4);
  const double xt = uniform_within(generator, -0.4, 0.4);
  const double yt = uniform_within(generator, -0.4, 0.4);
  correlation << 1.0, xy, xt, xy, 1.0, yt, xt, yt, 1.0;
  const Eigen::Vector3d sigma(sigma_m * uniform_within(generator, 0.7, 1.4),
                              sigma_m * uniform_within(generator, 0.7, 1.4),
                              sigma_rad);
  return sigma.asDiagonal() * correlation * sigma.asDiagonal();
}

SimulatedPoseGraph simulate_pose_graph(const PoseGraphSimulation& simulation,
                                       std::mt19937_64& generator) {
  SimulatedPoseGraph simulated;
  simulated.truth = drive(simulation, generator);
  std::normal_distribution<double> normal;
  const double heading_information = 1.0 / std::pow(simulation.heading_sigma_rad, 2);
  for (std::size_t k = 0; k < simulated.truth.size(); ++k) {
    const double noise_rad = simulation.noise * simulation.heading_sigma_rad * normal(generator);
    const double heading_rad = wrap_to_pi(simulated.truth[k].theta_rad + noise_rad);
    simulated.graph.T_map_node.push_back({0.0, 0.0, heading_rad});
    simulated.graph.headings.push_back({k, heading_rad, heading_information});
    if (k == 0) continue;
    const Eigen::Matrix3d covariance =
        random_covariance(simulation.odometry_sigma_m, simulation.rotation_sigma_rad, generator);
    simulated.graph.constraints.push_back(
        measure(simulated.truth, k - 1, k, covariance, simulation.noise, generator));
    simulated.groups.push_back(simulated.groups.size());
  }
  add_closures(simulation, simulated, generator);
  return simulated;
}

void inject(const WrongClosures& wrong, SimulatedPoseGraph& simulated, std::mt19937_64& generator) {
  PoseGraph& graph = simulated.graph;
  const std::size_t first = simulated.truth.size() - 1;
  const std::size_t num_right = graph.constraints.size() - first;
  const auto num_wrong = static_cast<std::size_t>(
      std::lround(static_cast<double>(num_right) * wrong.share / (1.0 - wrong.share)));
  for (std::size_t added = 0; added < num_wrong;) {
    const Constraint right = graph.constraints[first + index_below(generator, num_right)];
    const Constraint claim = false_claim(wrong, simulated, right, generator);
    if (claim.to + wrong.group_size > simulated.truth.size()) continue;
    // Neighbours agree: the truth, seen through one wrong pose of the one track to the other.
    const Pose2 T_from_to_wrong = simulated.truth[claim.from] * claim.T_from_to;
    const Pose2 shift = T_from_to_wrong * simulated.truth[claim.to].inverse();
    for (std::size_t k = 0; k < wrong.group_size && added < num_wrong; ++k, ++added) {
      Constraint member = claim;
      member.from = claim.from + k;
      member.to = claim.to + k;
      member.T_from_to =
          simulated.truth[member.from].inverse() * (shift * simulated.truth[member.to]);
      graph.constraints.push_back(member);
      simulated.groups.push_back(simulated.groups.size() - k);
    }
  }
}

double mean_position_error_m(const SimulatedPoseGraph& simulated) {
  double sum = 0.0;
  for (std::size_t k = 0; k < simulated.truth.size(); ++k) {
    sum += (simulated.graph.T_map_node[k].translation() - simulated.truth[k].translation()).norm();
  }
  return sum / static_cast<double>(simulated.truth.size());
}

}  // namespace setsquare::testing
