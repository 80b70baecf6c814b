// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Of a heading of which nothing is known: any is as likely.
inline constexpr double kNoHeadingSigma_rad = 1.813799364234218;  // pi / sqrt(3)

/// How certain a scan's pose is.
struct PoseSpread {
  /// Symmetric; its square is the position's covariance in the map frame, in m^2.
  Eigen::Matrix2d root_m = Eigen::Matrix2d::Zero();
  double heading_rad = 0.0;  ///< Standard deviation of the heading.

  /// Standard deviation of the position along its least certain direction.
  [[nodiscard]] double position_m() const;
};

/// How certain each scan's pose is: the position as position_sigmas_m() counts it, the heading in
/// the map, by spread_graph(). Infinite on the diagonal for scans of pieces that were not joined;
/// empty where there is no graph. Where a heading may be off by much, the position may be off along
/// an arc: no axis is surer than half the heading's sigma times the other one.
/// `unseconded`: see spread_graph().
[[nodiscard]] std::vector<PoseSpread> pose_spreads(const Map& track,
                                                   const MotionUncertaintyParams& params = {},
                                                   std::span<const std::size_t> unseconded = {},
                                                   std::size_t max_num_nodes = 48);

/// How certain each scan's position is against that of the first keyframe that is connected with
/// the largest piece: the standard deviation in m along its least certain direction, by the
/// marginal covariances of the graph at up to `max_num_nodes` keyframes - the first and the last of
/// each piece at least -, interpolated over the scans of a piece. Infinite for scans of pieces that
/// were not joined; empty where there is no graph.
[[nodiscard]] std::vector<double> position_sigmas_m(const Map& track,
                                                    std::size_t max_num_nodes = 48);

/// The stretches that were degenerate all along, in their order: those of at least `min_way_m`, and
/// those whose length is not known to `min_sigma_m` - without odometry the way may not be seen -,
/// and those of open turns whose heading is not known to kOpenHeading_rad.
[[nodiscard]] std::vector<OpenStretch> open_stretches(const Map& track,
                                                      double min_way_m = 1.0,
                                                      double min_sigma_m = 0.5);

/// Writes both into the map: the spreads of MappedScan and Map::open_stretches. `params`: of lost
/// scans.
/// `unseconded`: see spread_graph().
/// `astray`: keyframes that may be wrong by themselves (AuditFindings::astray). They, and the scans
/// between them and their neighbours, may be as far off as a wrong step leads; the neighbours know
/// where they are without them.
void add_certainty(Map& map,
                   const MotionUncertaintyParams& params = {},
                   std::span<const std::size_t> unseconded = {},
                   std::span<const std::size_t> astray = {});

}  // namespace setsquare
