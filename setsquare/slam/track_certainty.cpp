// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/track_certainty.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "setsquare/graph/marginal_covariance.hpp"

namespace setsquare {
namespace {

/// The last keyframe at or before a scan; the first where there is none.
std::size_t keyframe_before(const MappedTrack& track, std::size_t scan) {
  const auto after = std::upper_bound(track.keyframes.begin(), track.keyframes.end(), scan);
  return after == track.keyframes.begin()
             ? 0
             : static_cast<std::size_t>(after - track.keyframes.begin()) - 1;
}

double largest_sigma_m(const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix2d position = covariance.topLeftCorner<2, 2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(position, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().y()));
}

/// A run of degenerate scans: way, and the mean of its displacements modulo pi.
OpenStretch stretch_from(const MappedTrack& track, std::size_t first, std::size_t end) {
  OpenStretch stretch{.first_scan = first, .num_scans = end - first, .has_odometry = true};
  double cos_sum = 0.0;
  double sin_sum = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    stretch.has_odometry = stretch.has_odometry && track.scans[i].has_odometry;
    if (i == 0) continue;
    const Eigen::Vector2d step =
        track.scans[i].T_map_base.translation() - track.scans[i - 1].T_map_base.translation();
    const double double_angle_rad = 2.0 * std::atan2(step.y(), step.x());
    stretch.way_m += step.norm();
    cos_sum += step.norm() * std::cos(double_angle_rad);
    sin_sum += step.norm() * std::sin(double_angle_rad);
  }
  stretch.direction_rad = 0.5 * std::atan2(sin_sum, cos_sum);
  return stretch;
}

/// Along the stretch's direction, between the keyframes before and behind it.
double length_sigma_m(const MappedTrack& track,
                      const MarginalCovariance& marginals,
                      const OpenStretch& stretch) {
  const std::size_t from = keyframe_before(track, stretch.first_scan);
  const std::size_t last_scan = stretch.first_scan + stretch.num_scans - 1;
  const std::size_t to =
      std::min(keyframe_before(track, last_scan) + 1, track.keyframes.size() - 1);
  if (from == to) return 0.0;
  const double angle_rad = stretch.direction_rad - track.graph.T_map_node[from].theta_rad;
  const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
  const Eigen::Matrix2d covariance = marginals.between(from, to).topLeftCorner<2, 2>();
  return std::sqrt(std::max(0.0, along.dot(covariance * along)));
}

}  // namespace

std::vector<double> position_sigmas_m(const MappedTrack& track, std::size_t max_num_nodes) {
  const std::size_t num_nodes = track.graph.T_map_node.size();
  if (num_nodes == 0) return {};
  const MarginalCovariance marginals(track.graph);
  const std::size_t stride =
      std::max<std::size_t>(1, num_nodes / std::max<std::size_t>(1, max_num_nodes));
  std::vector<std::size_t> scans;
  std::vector<double> sigmas_m;
  for (std::size_t node = 0; node < num_nodes; node += stride) {
    scans.push_back(track.keyframes[node]);
    sigmas_m.push_back(largest_sigma_m(marginals.of(node)));
  }
  std::vector<double> of_scan(track.scans.size(), sigmas_m.back());
  for (std::size_t k = 0; k + 1 < scans.size(); ++k) {
    for (std::size_t i = k == 0 ? 0 : scans[k]; i < scans[k + 1]; ++i) {
      const double share = i < scans[k] ? 0.0
                                        : static_cast<double>(i - scans[k]) /
                                              static_cast<double>(scans[k + 1] - scans[k]);
      of_scan[i] = sigmas_m[k] + share * (sigmas_m[k + 1] - sigmas_m[k]);
    }
  }
  for (const TrackPiece& piece : track.pieces) {
    if (piece.is_joined) continue;
    const auto first = of_scan.begin() + static_cast<std::ptrdiff_t>(piece.first_scan);
    std::fill(first,
              first + static_cast<std::ptrdiff_t>(piece.num_scans),
              std::numeric_limits<double>::infinity());
  }
  return of_scan;
}

std::vector<OpenStretch> open_stretches(const MappedTrack& track, double min_way_m) {
  std::vector<OpenStretch> stretches;
  const std::size_t n = track.scans.size();
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first;
    while (end < n && track.scans[end].status == TrackStatus::kDegenerate) ++end;
    if (end > first) {
      const OpenStretch stretch = stretch_from(track, first, end);
      if (stretch.way_m >= min_way_m) stretches.push_back(stretch);
    }
    first = std::max(end, first + 1);
  }
  if (stretches.empty() || track.graph.T_map_node.empty()) return stretches;
  const MarginalCovariance marginals(track.graph);
  for (OpenStretch& stretch : stretches) {
    stretch.length_sigma_m = length_sigma_m(track, marginals, stretch);
  }
  return stretches;
}

}  // namespace setsquare
