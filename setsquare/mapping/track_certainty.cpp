// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/track_certainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/marginal_covariance.hpp"
#include "setsquare/mapping/spread_graph.hpp"

namespace setsquare {
namespace {

/// The last keyframe at or before a scan; the first where there is none.
std::size_t keyframe_before(const Map& track, std::size_t scan) {
  const auto after = std::upper_bound(track.keyframes.begin(), track.keyframes.end(), scan);
  return after == track.keyframes.begin()
             ? 0
             : static_cast<std::size_t>(after - track.keyframes.begin()) - 1;
}

/// The matrix whose square a covariance is.
Eigen::Matrix2d root_of(const Eigen::Matrix2d& covariance) {
  const SymmetricEigen<2> eigen = symmetric_eigen(covariance);
  return eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.vectors.transpose();
}

/// Adds an independent error to one of `root`.
Eigen::Matrix2d widened(const Eigen::Matrix2d& root, const Eigen::Matrix2d& other_covariance) {
  return root_of(root * root + other_covariance);
}

/// A piece: its scans, and its keyframes, of which it has one at least.
struct PieceNodes {
  std::size_t first_scan = 0;
  std::size_t end_scan = 0;
  std::size_t first_node = 0;
  std::size_t num_nodes = 0;
  bool is_joined = false;
};

std::vector<PieceNodes> nodes_of_pieces(const Map& track) {
  std::vector<PieceNodes> pieces;
  const auto node_at = [&](std::size_t scan) {
    const auto at = std::lower_bound(track.keyframes.begin(), track.keyframes.end(), scan);
    return static_cast<std::size_t>(at - track.keyframes.begin());
  };
  for (const TrackPiece& piece : track.pieces) {
    const std::size_t end_scan = piece.first_scan + piece.num_scans;
    const std::size_t first_node = node_at(piece.first_scan);
    const std::size_t num_nodes = node_at(end_scan) - first_node;
    if (num_nodes == 0) continue;
    pieces.push_back({piece.first_scan, end_scan, first_node, num_nodes, piece.is_joined});
  }
  return pieces;
}

/// The nodes at which spreads jump: behind unseconded steps, behind departures, and along stretches
/// that the walls leave open, whose ends a loop may hold and whose middle nothing does.
std::vector<std::size_t> jump_nodes(const Map& track, std::span<const std::size_t> unseconded) {
  constexpr double kLeastOpen_m = 0.1;  // Less does not show between nodes.
  std::vector<std::size_t> nodes(unseconded.begin(), unseconded.end());
  for (std::size_t k = 0; k < track.track.motions.size(); ++k) {
    const MotionCovariance& motion = track.track.motions[k].covariance;
    const bool departs = motion.departure_sigma_m + motion.departure_sigma_rad > 0.0;
    if (departs || motion.open_sigma_m.trace() > kLeastOpen_m) nodes.push_back(k);
  }
  return nodes;
}

/// So many nodes of a piece, evenly from its first to its last; all where it has fewer. And those
/// before and behind the nodes at which spreads jump.
std::vector<std::size_t> spread_nodes(const PieceNodes& piece,
                                      std::size_t num,
                                      std::span<const std::size_t> jumps) {
  std::vector<std::size_t> nodes;
  const std::size_t num_spread = std::min(piece.num_nodes, std::max<std::size_t>(2, num));
  for (std::size_t k = 0; k < num_spread; ++k) {
    const std::size_t of_piece = k == 0 ? 0 : k * (piece.num_nodes - 1) / (num_spread - 1);
    nodes.push_back(piece.first_node + of_piece);
  }
  for (const std::size_t node : jumps) {
    if (node <= piece.first_node || node >= piece.first_node + piece.num_nodes) continue;
    nodes.insert(nodes.end(), {node - 1, node});
  }
  std::ranges::sort(nodes);
  const auto repeated = std::ranges::unique(nodes);
  nodes.erase(repeated.begin(), repeated.end());
  return nodes;
}

/// Spreads of a piece's scans from those at some of its nodes: straight lines between, constant
/// before the first and behind the last.
void interpolate(const Map& track,
                 const PieceNodes& piece,
                 const std::vector<std::size_t>& nodes,
                 const std::vector<PoseSpread>& of_node,
                 std::vector<PoseSpread>& of_scan) {
  std::size_t next = 0;  // The first node behind the scan.
  for (std::size_t scan = piece.first_scan; scan < piece.end_scan; ++scan) {
    while (next < nodes.size() && track.keyframes[nodes[next]] <= scan) ++next;
    PoseSpread& spread = of_scan[scan];
    spread = of_node[next == 0 ? 0 : next - 1];
    if (next == 0 || next == nodes.size()) continue;
    const std::size_t before = track.keyframes[nodes[next - 1]];
    const std::size_t after = track.keyframes[nodes[next]];
    const double share = static_cast<double>(scan - before) / static_cast<double>(after - before);
    spread.root_m += share * (of_node[next].root_m - spread.root_m);
    spread.heading_rad += share * (of_node[next].heading_rad - spread.heading_rad);
  }
}

/// A run of degenerate scans: way, and the mean of its displacements modulo pi.
OpenStretch stretch_from(const Map& track, std::size_t first, std::size_t end) {
  OpenStretch stretch{.first_scan = first, .num_scans = end - first, .has_odometry = true};
  stretch.duration_s = seconds_between(track.scans[first].stamp, track.scans[end - 1].stamp);
  double cos_sum = 0.0;
  double sin_sum = 0.0;
  std::size_t num_turns = 0;
  for (std::size_t i = first; i < end; ++i) {
    stretch.has_odometry = stretch.has_odometry && track.scans[i].has_odometry;
    num_turns += track.scans[i].is_turn_open;
    if (std::isfinite(track.scans[i].heading_sigma_rad)) {
      stretch.heading_sigma_rad =
          std::max(stretch.heading_sigma_rad, track.scans[i].heading_sigma_rad);
    }
    if (i == 0 || begins_anew(track, i)) continue;
    const Eigen::Vector2d step =
        track.scans[i].T_map_base.translation() - track.scans[i - 1].T_map_base.translation();
    const double double_angle_rad = 2.0 * std::atan2(step.y(), step.x());
    stretch.way_m += step.norm();
    cos_sum += step.norm() * std::cos(double_angle_rad);
    sin_sum += step.norm() * std::sin(double_angle_rad);
  }
  stretch.direction_rad = 0.5 * std::atan2(sin_sum, cos_sum);
  stretch.is_turn = 2 * num_turns > stretch.num_scans;
  return stretch;
}

/// Covariance of the way between scans that lie behind the last keyframe of their piece, of which
/// the graph knows nothing: where a robot stands, or seems to stand, no keyframe is made. Errors of
/// successive scans are correlated: sigmas add up, not variances.
class WayBehindKeyframes {
 public:
  void add(const MappedScan& scan) {
    const Eigen::Vector2d& u_m = scan.open_sigma_m;
    if (u_m.norm() > 0.0) sum_m_ += u_m * u_m.transpose() / u_m.norm();
  }
  [[nodiscard]] Eigen::Matrix2d covariance_m2() const { return sum_m_ * sum_m_; }

 private:
  Eigen::Matrix2d sum_m_ = Eigen::Matrix2d::Zero();
};

/// What lies behind the last keyframe of a piece adds to the spreads of its scans.
void widen_behind(const Map& track, const PieceNodes& piece, std::vector<PoseSpread>& of_scan) {
  WayBehindKeyframes way;
  double turn_rad = 0.0;
  const std::size_t last_node = piece.first_node + piece.num_nodes - 1;
  for (std::size_t scan = track.keyframes[last_node] + 1; scan < piece.end_scan; ++scan) {
    way.add(track.scans[scan]);
    turn_rad += track.scans[scan].open_turn_sigma_rad;
    of_scan[scan].root_m = widened(of_scan[scan].root_m, way.covariance_m2());
    of_scan[scan].heading_rad = std::hypot(of_scan[scan].heading_rad, turn_rad);
  }
}

/// Lost scans stand where they were expected: they may be off by what each of a row adds.
void widen_lost(const Map& track,
                const MotionUncertaintyParams& params,
                std::vector<PoseSpread>& of_scan) {
  double sum_m = 0.0;
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < of_scan.size(); ++i) {
    const MappedScan& scan = track.scans[i];
    if (begins_anew(track, i)) sum_m = sum_rad = 0.0;
    if (scan.status != TrackStatus::kLost) {
      sum_m = sum_rad = 0.0;
      continue;
    }
    sum_m += scan.has_odometry ? params.lost_sigma_m_by_odometry : params.lost_sigma_m;
    sum_rad += scan.has_odometry ? params.lost_sigma_rad_by_odometry : params.lost_sigma_rad;
    if (!std::isfinite(of_scan[i].heading_rad)) continue;
    of_scan[i].root_m = widened(of_scan[i].root_m, sum_m * sum_m * Eigen::Matrix2d::Identity());
    of_scan[i].heading_rad = std::hypot(of_scan[i].heading_rad, sum_rad);
  }
}

/// Where a heading may be off by much, the position is off along an arc and not along a line, and a
/// heading by no more than any can be.
void bend(PoseSpread& spread) {
  if (!std::isfinite(spread.heading_rad)) return;
  spread.heading_rad = std::min(spread.heading_rad, kNoHeadingSigma_rad);
  SymmetricEigen<2> eigen = symmetric_eigen(spread.root_m);
  const double across_m = 0.5 * spread.heading_rad * eigen.values.y();
  if (eigen.values.x() >= across_m) return;
  eigen.values.x() = across_m;
  spread.root_m = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
}

/// How certain the stretch's length is, between the keyframes of its piece before and behind it,
/// or to its last scan where none is behind: along the way by odometry; without it along the least
/// certain direction, which then is the stretch's, as the way may not have been seen.
void add_length(const Map& track,
                const PieceNodes& piece,
                const MarginalCovariance& marginals,
                OpenStretch& stretch) {
  const std::size_t last_scan = stretch.first_scan + stretch.num_scans - 1;
  const std::size_t last_node = piece.first_node + piece.num_nodes - 1;
  const std::size_t from =
      std::clamp(keyframe_before(track, stretch.first_scan), piece.first_node, last_node);
  const std::size_t to =
      std::clamp(keyframe_before(track, last_scan) + 1, piece.first_node, last_node);
  WayBehindKeyframes behind;
  for (std::size_t scan = std::max(stretch.first_scan, track.keyframes[to] + 1);
       scan < std::min(last_scan + 1, piece.end_scan);
       ++scan) {
    behind.add(track.scans[scan]);
  }
  Eigen::Matrix2d covariance_m2 = behind.covariance_m2();
  if (from != to) covariance_m2 += marginals.of_way(from, to);
  if (covariance_m2.isZero(0.0)) return;
  if (stretch.has_odometry) {
    const Eigen::Vector2d along(std::cos(stretch.direction_rad), std::sin(stretch.direction_rad));
    stretch.length_sigma_m = std::sqrt(std::max(0.0, along.dot(covariance_m2 * along)));
    return;
  }
  const SymmetricEigen<2> eigen = symmetric_eigen(covariance_m2);
  stretch.length_sigma_m = std::sqrt(std::max(0.0, eigen.values.y()));
  stretch.direction_rad = std::atan2(eigen.vectors(1, 1), eigen.vectors(0, 1));
}

/// Adds how far scans may be off that nothing seconds.
void widen_astray(const Map& map,
                  std::span<const std::size_t> astray,
                  std::vector<PoseSpread>& of_scan) {
  for (const std::size_t keyframe : astray) {
    const StepReach off = wrong_step_sigma(map, keyframe);
    const Eigen::Matrix2d off_m2 = off.distance_m * off.distance_m * Eigen::Matrix2d::Identity();
    const std::size_t first = keyframe == 0 ? 0 : map.keyframes[keyframe - 1] + 1;
    const bool is_last = keyframe + 1 == map.keyframes.size();
    const std::size_t end = is_last ? of_scan.size() : map.keyframes[keyframe + 1];
    for (std::size_t scan = first; scan < end; ++scan) {
      if (!std::isfinite(of_scan[scan].heading_rad)) continue;
      of_scan[scan].root_m = widened(of_scan[scan].root_m, off_m2);
      of_scan[scan].heading_rad = std::hypot(of_scan[scan].heading_rad, off.turn_rad);
    }
  }
}

}  // namespace

double PoseSpread::position_m() const { return symmetric_eigenvalues(root_m).y(); }

std::vector<PoseSpread> pose_spreads(const Map& track,
                                     const MotionUncertaintyParams& params,
                                     std::span<const std::size_t> unseconded,
                                     std::size_t max_num_nodes) {
  if (track.graph.T_map_node.empty()) return {};
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(kInfinite);
  std::vector<PoseSpread> of_scan(track.scans.size(), {nowhere.asDiagonal(), kInfinite});
  std::vector<PieceNodes> joined = nodes_of_pieces(track);
  std::erase_if(joined, [](const PieceNodes& piece) { return !piece.is_joined; });
  std::size_t num_joined_nodes = 0;
  for (const PieceNodes& piece : joined) num_joined_nodes += piece.num_nodes;
  max_num_nodes = std::min(max_num_nodes, num_joined_nodes);
  const MarginalCovariance marginals(spread_graph(track, unseconded));
  const std::vector<std::size_t> jumps = jump_nodes(track, unseconded);
  for (const PieceNodes& piece : joined) {
    const std::vector<std::size_t> nodes =
        spread_nodes(piece, max_num_nodes * piece.num_nodes / num_joined_nodes, jumps);
    std::vector<PoseSpread> of_node;
    for (const std::size_t node : nodes) {
      const Eigen::Matrix2d way_m2 = marginals.of_way(joined.front().first_node, node);
      of_node.push_back({root_of(way_m2), std::sqrt(std::max(0.0, marginals.of_heading(node)))});
    }
    interpolate(track, piece, nodes, of_node, of_scan);
    widen_behind(track, piece, of_scan);
  }
  widen_lost(track, params, of_scan);
  for (PoseSpread& spread : of_scan) {
    spread.heading_rad = std::hypot(spread.heading_rad, params.scan_sigma_rad);
    bend(spread);
  }
  return of_scan;
}

std::vector<double> position_sigmas_m(const Map& track, std::size_t max_num_nodes) {
  std::vector<double> sigmas_m;
  for (const PoseSpread& spread : pose_spreads(track, {}, {}, max_num_nodes)) {
    sigmas_m.push_back(std::isfinite(spread.heading_rad) ? spread.position_m()
                                                         : spread.heading_rad);
  }
  return sigmas_m;
}

std::vector<OpenStretch> open_stretches(const Map& track, double min_way_m, double min_sigma_m) {
  constexpr double kShortest_s = 0.5;  // In less time a robot does not get far.
  std::vector<OpenStretch> stretches;
  const std::size_t n = track.scans.size();
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first;
    const auto is_open = [&](std::size_t scan) {
      return scan < n && track.scans[scan].status == TrackStatus::kDegenerate;
    };
    if (is_open(end)) ++end;
    while (end > first && is_open(end) && !begins_anew(track, end)) ++end;
    if (end > first) {
      const OpenStretch stretch = stretch_from(track, first, end);
      const bool may_be_long = !stretch.has_odometry && stretch.duration_s > kShortest_s;
      if (stretch.way_m >= min_way_m || may_be_long || stretch.is_turn)
        stretches.push_back(stretch);
    }
    first = std::max(end, first + 1);
  }
  if (stretches.empty() || track.graph.T_map_node.empty()) return stretches;
  const MarginalCovariance marginals(spread_graph(track));
  const std::vector<PieceNodes> pieces = nodes_of_pieces(track);
  for (OpenStretch& stretch : stretches) {
    const auto of_stretch = std::find_if(pieces.begin(), pieces.end(), [&](const auto& piece) {
      return stretch.first_scan < piece.end_scan;
    });
    if (of_stretch == pieces.end()) continue;
    add_length(track, *of_stretch, marginals, stretch);
  }
  std::erase_if(stretches, [&](const OpenStretch& stretch) {
    const bool is_heading_open = stretch.is_turn && stretch.heading_sigma_rad > kOpenHeading_rad;
    return stretch.way_m < min_way_m && stretch.length_sigma_m < min_sigma_m && !is_heading_open;
  });
  return stretches;
}

void add_certainty(Map& map,
                   const MotionUncertaintyParams& params,
                   std::span<const std::size_t> unseconded,
                   std::span<const std::size_t> astray) {
  std::vector<PoseSpread> spreads = pose_spreads(map, params, unseconded);
  if (!spreads.empty()) widen_astray(map, astray, spreads);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    MappedScan& scan = map.scans[i];
    const PoseSpread& spread = spreads[i];
    const bool is_known = std::isfinite(spread.heading_rad);
    scan.position_sigma_m = is_known ? spread.position_m() : spread.heading_rad;
    scan.position_covariance_m2 =
        is_known ? Eigen::Matrix2d(spread.root_m * spread.root_m) : spread.root_m;
    scan.heading_sigma_rad = spread.heading_rad;
  }
  map.open_stretches = open_stretches(map);
}

}  // namespace setsquare
