// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/track_certainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/marginal_covariance.hpp"

namespace setsquare {
namespace {

/// The last keyframe at or before a scan; the first where there is none.
std::size_t keyframe_before(const Map& track, std::size_t scan) {
  const auto after = std::upper_bound(track.keyframes.begin(), track.keyframes.end(), scan);
  return after == track.keyframes.begin()
             ? 0
             : static_cast<std::size_t>(after - track.keyframes.begin()) - 1;
}

double largest_sigma_m(const Eigen::Matrix2d& covariance) {
  return std::sqrt(std::max(0.0, symmetric_eigenvalues(covariance).y()));
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

/// So many nodes of a piece, evenly from its first to its last; all where it has fewer.
std::vector<std::size_t> spread_nodes(const PieceNodes& piece, std::size_t num) {
  std::vector<std::size_t> nodes;
  const std::size_t num_spread = std::min(piece.num_nodes, std::max<std::size_t>(2, num));
  for (std::size_t k = 0; k < num_spread; ++k) {
    const std::size_t of_piece = k == 0 ? 0 : k * (piece.num_nodes - 1) / (num_spread - 1);
    nodes.push_back(piece.first_node + of_piece);
  }
  return nodes;
}

/// Sigmas of a piece's scans from those at some of its nodes: straight lines between, constant
/// before the first and behind the last.
void interpolate(const Map& track,
                 const PieceNodes& piece,
                 const std::vector<std::size_t>& nodes,
                 const std::vector<double>& of_node_m,
                 std::vector<double>& of_scan_m) {
  std::size_t next = 0;  // The first node behind the scan.
  for (std::size_t scan = piece.first_scan; scan < piece.end_scan; ++scan) {
    while (next < nodes.size() && track.keyframes[nodes[next]] <= scan) ++next;
    of_scan_m[scan] = of_node_m[next == 0 ? 0 : next - 1];
    if (next == 0 || next == nodes.size()) continue;
    const std::size_t before = track.keyframes[nodes[next - 1]];
    const std::size_t after = track.keyframes[nodes[next]];
    const double share = static_cast<double>(scan - before) / static_cast<double>(after - before);
    of_scan_m[scan] += share * (of_node_m[next] - of_node_m[next - 1]);
  }
}

/// A run of degenerate scans: way, and the mean of its displacements modulo pi.
OpenStretch stretch_from(const Map& track, std::size_t first, std::size_t end) {
  OpenStretch stretch{.first_scan = first, .num_scans = end - first, .has_odometry = true};
  stretch.duration_s = seconds_between(track.scans[first].stamp, track.scans[end - 1].stamp);
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

/// What lies behind the last keyframe of a piece adds to the sigmas of its scans.
void widen_behind(const Map& track, const PieceNodes& piece, std::vector<double>& of_scan_m) {
  WayBehindKeyframes way;
  const std::size_t last_node = piece.first_node + piece.num_nodes - 1;
  for (std::size_t scan = track.keyframes[last_node] + 1; scan < piece.end_scan; ++scan) {
    way.add(track.scans[scan]);
    of_scan_m[scan] = std::hypot(of_scan_m[scan], largest_sigma_m(way.covariance_m2()));
  }
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

}  // namespace

std::vector<double> position_sigmas_m(const Map& track, std::size_t max_num_nodes) {
  if (track.graph.T_map_node.empty()) return {};
  std::vector<double> of_scan_m(track.scans.size(), std::numeric_limits<double>::infinity());
  std::vector<PieceNodes> joined = nodes_of_pieces(track);
  std::erase_if(joined, [](const PieceNodes& piece) { return !piece.is_joined; });
  std::size_t num_joined_nodes = 0;
  for (const PieceNodes& piece : joined) num_joined_nodes += piece.num_nodes;
  max_num_nodes = std::min(max_num_nodes, num_joined_nodes);
  const MarginalCovariance marginals(track.graph);
  for (const PieceNodes& piece : joined) {
    const std::vector<std::size_t> nodes =
        spread_nodes(piece, max_num_nodes * piece.num_nodes / num_joined_nodes);
    std::vector<double> of_node_m;
    for (const std::size_t node : nodes) {
      of_node_m.push_back(largest_sigma_m(marginals.of_way(joined.front().first_node, node)));
    }
    interpolate(track, piece, nodes, of_node_m, of_scan_m);
    widen_behind(track, piece, of_scan_m);
  }
  return of_scan_m;
}

std::vector<OpenStretch> open_stretches(const Map& track, double min_way_m, double min_sigma_m) {
  constexpr double kShortest_s = 0.5;  // In less time a robot does not get far.
  std::vector<OpenStretch> stretches;
  const std::size_t n = track.scans.size();
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first;
    while (end < n && track.scans[end].status == TrackStatus::kDegenerate) ++end;
    if (end > first) {
      const OpenStretch stretch = stretch_from(track, first, end);
      const bool may_be_long = !stretch.has_odometry && stretch.duration_s > kShortest_s;
      if (stretch.way_m >= min_way_m || may_be_long) stretches.push_back(stretch);
    }
    first = std::max(end, first + 1);
  }
  if (stretches.empty() || track.graph.T_map_node.empty()) return stretches;
  const MarginalCovariance marginals(track.graph);
  const std::vector<PieceNodes> pieces = nodes_of_pieces(track);
  for (OpenStretch& stretch : stretches) {
    const auto of_stretch = std::find_if(pieces.begin(), pieces.end(), [&](const auto& piece) {
      return stretch.first_scan < piece.end_scan;
    });
    if (of_stretch == pieces.end()) continue;
    add_length(track, *of_stretch, marginals, stretch);
  }
  std::erase_if(stretches, [&](const OpenStretch& stretch) {
    return stretch.way_m < min_way_m && stretch.length_sigma_m < min_sigma_m;
  });
  return stretches;
}

void add_certainty(Map& map) {
  const std::vector<double> sigmas_m = position_sigmas_m(map);
  for (std::size_t i = 0; i < sigmas_m.size(); ++i) map.scans[i].position_sigma_m = sigmas_m[i];
  map.open_stretches = open_stretches(map);
}

}  // namespace setsquare
