// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/slipped_steps.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// What asks for more turns the map: the walls' directions decide that (told_turns).
constexpr double kMaxSlipTurn_rad = rad_from_deg(5.0);

/// Variance, along a direction of the map frame, of the way that the steps make up, in m^2.
double variance_along_m2(const SlippedSteps& steps,
                         const Eigen::Vector2d& direction,
                         const PoseGraph& graph) {
  double variance_m2 = 0.0;
  for (std::size_t k = steps.first + 1; k <= steps.last; ++k) {
    const Constraint& step = graph.constraints[k - 1];
    assert(step.to == k);
    const Eigen::Vector2d seen =
        rotation_matrix(-graph.T_map_node[step.from].theta_rad) * direction;
    variance_m2 += seen.dot(step.information.topLeftCorner<2, 2>().inverse() * seen);
  }
  return variance_m2;
}

}  // namespace

Slips slipped_steps(const AuditFindings& findings, const PoseGraph& graph) {
  Slips slips;
  for (const ContradictionGroup& group : findings.groups) {
    if (!group.is_hypothesis()) continue;
    const AuditMatch& centre = findings.matches[group.centre];
    const Pose2 correction = correction_by(centre, findings.track);
    if (std::abs(correction.theta_rad) > kMaxSlipTurn_rad) continue;
    SlippedSteps slip{.first = 0, .last = graph.T_map_node.size() - 1};
    for (const std::size_t i : group.members) {
      const AuditPair& pair = findings.matches[i].pair;
      slip.first = std::max(slip.first, findings.track.keyframes[pair.from]);
      slip.last = std::min(slip.last, findings.track.keyframes[pair.to]);
    }
    if (slip.first >= slip.last) continue;
    const Eigen::Vector2d at_m = findings.track.T_map_sensor[centre.pair.to].translation();
    const Eigen::Vector2d off_m = correction * at_m - at_m;
    const double variance_m2 = variance_along_m2(slip, off_m.normalized(), graph);
    slip.times_variance = std::max(1.0, off_m.squaredNorm() / variance_m2);
    slips.push_back(slip);
  }
  return slips;
}

void loosen_slipped(const Slips& slips, PoseGraph& graph) {
  std::vector<double> times_variance(graph.T_map_node.size(), 1.0);
  for (const SlippedSteps& slip : slips) {
    for (std::size_t k = slip.first + 1; k <= slip.last; ++k) {
      times_variance[k] = std::max(times_variance[k], slip.times_variance);
    }
  }
  for (std::size_t k = 1; k < times_variance.size(); ++k) {
    assert(graph.constraints[k - 1].to == k);
    graph.constraints[k - 1].information.topLeftCorner<2, 2>() /= times_variance[k];
  }
}

}  // namespace setsquare
