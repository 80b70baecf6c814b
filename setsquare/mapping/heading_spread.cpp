// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/heading_spread.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/mapping/loops/candidates.hpp"
#include "setsquare/mapping/spread_graph.hpp"

namespace setsquare {
namespace {

/// Whether nothing was lost, found again or open on the way to a keyframe, and no odometry spoke
/// against it.
bool is_undisturbed(const KeyframeTrack& track, std::size_t keyframe) {
  const MotionCovariance& motion = track.motions[keyframe];
  return track.pieces[keyframe] == track.pieces[keyframe - 1] &&
         !(motion.slip_sigma_m + motion.departure_sigma_m > 0.0);
}

}  // namespace

void HeadingSpreadParams::validate() const {
  require_positive(same_walls_m, "heading_spread.same_walls_m");
  require_positive(sigma_per_change, "heading_spread.sigma_per_change");
  require_positive(max_changes, "heading_spread.max_changes");
  require_not_negative(num_assumed, "heading_spread.num_assumed");
}

std::vector<double> keyframes_of_same_walls(const PoseGraph& graph,
                                            std::span<const double> shares_of_place,
                                            double same_walls_m) {
  const double reach_m = 3.0 * same_walls_m;  // Further away the share is below 0.011.
  PositionHash measured(reach_m);
  for (std::size_t m = 0; m < graph.headings.size(); ++m) {
    measured.add(graph.T_map_node[graph.headings[m].node].translation(), m);
  }
  std::vector<double> num_keyframes;
  for (const HeadingMeasurement& heading : graph.headings) {
    const Eigen::Vector2d place_m = graph.T_map_node[heading.node].translation();
    double num = 0.0;
    measured.visit(place_m, reach_m, [&](std::size_t m) {
      const HeadingMeasurement& other = graph.headings[m];
      const double d2 = (graph.T_map_node[other.node].translation() - place_m).squaredNorm();
      if (d2 > reach_m * reach_m) return;
      const double same_walls = std::exp(-0.5 * d2 / (same_walls_m * same_walls_m));
      num += shares_of_place[other.node] * same_walls *
             std::min(1.0, other.information_per_rad2 / heading.information_per_rad2);
    });
    num_keyframes.push_back(num);
  }
  return num_keyframes;
}

double rotation_variance_scale(const KeyframeTrack& track,
                               const PoseGraph& graph,
                               const HeadingSpreadParams& params) {
  double num = params.num_assumed;
  double sum = params.num_assumed;
  for (const Constraint& motion : graph.constraints) {
    if (!is_tracked_step(motion) || !is_undisturbed(track, motion.to)) continue;
    const double changed_rad =
        wrap_to_pi(graph.T_map_node[motion.to].theta_rad - graph.T_map_node[motion.from].theta_rad -
                   motion.T_from_to.theta_rad);
    const double changed = std::sqrt(motion.information(2, 2)) * std::abs(changed_rad);
    const double deviation = params.sigma_per_change * std::min(changed, params.max_changes);
    sum += deviation * deviation;
    num += 1.0;
  }
  return num > 0.0 ? sum / num : 1.0;
}

void share_frame_offsets(const FusedHeadings& headings, double variance_scale, PoseGraph& graph) {
  std::vector<double> information(headings.frames.size(), 0.0);
  const auto frame_of = [&](const HeadingMeasurement& heading) {
    const int frame = headings.frame[heading.node];
    return frame > 0 ? static_cast<std::size_t>(frame) : 0;
  };
  for (const HeadingMeasurement& heading : graph.headings) {
    information[frame_of(heading)] += heading.information_per_rad2;
  }
  for (HeadingMeasurement& heading : graph.headings) {
    const std::size_t frame = frame_of(heading);
    if (frame == 0) continue;
    const double sigma_rad = headings.frames[frame].sigma_rad;
    heading.information_per_rad2 /=
        1.0 + variance_scale * sigma_rad * sigma_rad * information[frame];
  }
}

void spread_headings(const KeyframeTrack& track,
                     const FusedHeadings& headings,
                     std::span<const double> shares_of_place,
                     const HeadingSpreadParams& params,
                     PoseGraph& graph) {
  const double scale = rotation_variance_scale(track, graph, params);
  for (Constraint& constraint : graph.constraints) {
    if (!is_tracked_step(constraint)) continue;
    const bool is_stated = scale < 1.0 && !is_undisturbed(track, constraint.to);
    if (!is_stated && scale > 0.0) constraint.information(2, 2) /= scale;
  }
  const std::vector<double> num_keyframes =
      keyframes_of_same_walls(graph, shares_of_place, params.same_walls_m);
  for (std::size_t m = 0; m < num_keyframes.size(); ++m) {
    graph.headings[m].information_per_rad2 /= std::max(1.0, num_keyframes[m]);
  }
  if (headings.frames.size() > 1) share_frame_offsets(headings, std::max(1.0, scale), graph);
}

}  // namespace setsquare
