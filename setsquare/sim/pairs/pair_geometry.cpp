// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/pairs/pair_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

namespace setsquare {
namespace {

constexpr double kCommonWithin_m = 0.2;

/// Answers whether points lie on a surface; fast for points that follow one another.
class NearSurface {
 public:
  explicit NearSurface(const std::vector<SurfacePiece>& pieces) {
    bounded_pieces_.reserve(pieces.size());
    for (const SurfacePiece& piece : pieces) {
      const Eigen::Array2d a = piece.start_m;
      const Eigen::Array2d b = piece.end_m;
      const Eigen::Vector2d way = piece.end_m - piece.start_m;
      bounded_pieces_.push_back({a.min(b) - kCommonWithin_m,
                                 a.max(b) + kCommonWithin_m,
                                 piece.start_m,
                                 way,
                                 1.0 / std::max(way.squaredNorm(), 1e-18)});
    }
  }

  [[nodiscard]] bool contains(const Eigen::Vector2d& p_m) {
    const std::size_t num_pieces = bounded_pieces_.size();
    for (std::size_t i = 0, piece = last_; i < num_pieces; ++i) {
      if (is_near(p_m, bounded_pieces_[piece])) {
        last_ = piece;
        return true;
      }
      if (++piece == num_pieces) piece = 0;
    }
    return false;
  }

 private:
  struct BoundedPiece {
    Eigen::Array2d low_m;
    Eigen::Array2d high_m;
    Eigen::Vector2d start_m;
    Eigen::Vector2d way;
    double inverse_squared_length;
  };

  static bool is_near(const Eigen::Vector2d& p_m, const BoundedPiece& piece) {
    if (p_m.x() < piece.low_m.x() || p_m.x() > piece.high_m.x()) return false;
    if (p_m.y() < piece.low_m.y() || p_m.y() > piece.high_m.y()) return false;
    const Eigen::Vector2d to_p = p_m - piece.start_m;
    const double share = std::clamp(to_p.dot(piece.way) * piece.inverse_squared_length, 0.0, 1.0);
    return (to_p - share * piece.way).squaredNorm() <= kCommonWithin_m * kCommonWithin_m;
  }

  std::vector<BoundedPiece> bounded_pieces_;
  std::size_t last_ = 0;  // The piece that contained the last point: likely the next one's, too.
};

std::vector<SurfaceReturn> common_returns(const VisibleSurface& reference,
                                          const VisibleSurface& current) {
  NearSurface seen(reference.pieces);
  std::vector<SurfaceReturn> common;
  for (const SurfaceReturn& seen_now : current.returns) {
    if (seen.contains(seen_now.p_m)) common.push_back(seen_now);
  }
  return common;
}

/// Sum of length * J J^T over the returns, J = (n_x, n_y, lever), the lever being that of the
/// normal about the returns' centroid.
struct WallSums {
  double xx = 0.0, xy = 0.0, yy = 0.0;  // m
  double xt = 0.0, yt = 0.0;            // m^2
  double tt = 0.0;                      // m^3
};

WallSums sum_walls(const std::vector<SurfaceReturn>& returns) {
  double length_m = 0.0;
  Eigen::Vector2d centroid_m = Eigen::Vector2d::Zero();
  for (const SurfaceReturn& at : returns) {
    length_m += at.length_m;
    centroid_m += at.length_m * at.p_m;
  }
  if (length_m > 0.0) centroid_m /= length_m;
  WallSums sums;
  for (const SurfaceReturn& at : returns) {
    const Eigen::Vector2d& n = at.normal;
    const Eigen::Vector2d r = at.p_m - centroid_m;
    const double lever_m = r.x() * n.y() - r.y() * n.x();
    sums.xx += at.length_m * n.x() * n.x();
    sums.xy += at.length_m * n.x() * n.y();
    sums.yy += at.length_m * n.y() * n.y();
    sums.xt += at.length_m * n.x() * lever_m;
    sums.yt += at.length_m * n.y() * lever_m;
    sums.tt += at.length_m * lever_m * lever_m;
  }
  return sums;
}

/// A symmetric 2x2 matrix by its eigenvalues.
struct Axes {
  double smallest;
  double largest;
  double smallest_rad;  // Direction of the smallest eigenvalue's vector, in [0, pi).
};

Axes axes_of(double xx, double xy, double yy) {
  const double mean = 0.5 * (xx + yy);
  const double half_spread = std::hypot(0.5 * (xx - yy), xy);
  const double largest_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const double smallest_rad = largest_rad + 0.5 * kPi;  // In (0, pi].
  return {std::max(mean - half_spread, 0.0),
          mean + half_spread,
          smallest_rad >= kPi ? smallest_rad - kPi : smallest_rad};
}

/// Information of the rotation when the translation is free. A direction that no wall stands across
/// cannot be coupled to the rotation either.
double turning(const WallSums& sums) {
  const Axes axes = axes_of(sums.xx, sums.xy, sums.yy);
  const double c = std::cos(axes.smallest_rad);
  const double s = std::sin(axes.smallest_rad);
  const double coupling_smallest = c * sums.xt + s * sums.yt;
  const double coupling_largest = c * sums.yt - s * sums.xt;
  double left = sums.tt;
  if (axes.largest > 0.0) left -= coupling_largest * coupling_largest / axes.largest;
  if (axes.smallest > 1e-9 * axes.largest) {
    left -= coupling_smallest * coupling_smallest / axes.smallest;
  }
  return std::max(left, 0.0);
}

}  // namespace

PairGeometry pair_geometry(const VisibleSurface& reference, const VisibleSurface& current) {
  PairGeometry geometry;
  if (current.returns.empty()) return geometry;
  const std::vector<SurfaceReturn> common = common_returns(reference, current);
  geometry.overlap =
      static_cast<double>(common.size()) / static_cast<double>(current.returns.size());
  const WallSums sums = sum_walls(common);
  const double free_rotation = sums.tt > 1e-12 ? 1.0 / sums.tt : 0.0;
  const Axes axes = axes_of(sums.xx - sums.xt * sums.xt * free_rotation,
                            sums.xy - sums.xt * sums.yt * free_rotation,
                            sums.yy - sums.yt * sums.yt * free_rotation);
  geometry.wall_across_m = axes.smallest;
  geometry.worst_direction_rad = axes.smallest_rad;
  geometry.wall_turning_m3 = turning(sums);
  return geometry;
}

PairGeometry pair_geometry(const RayCaster& caster,
                           const ScannerModel& scanner,
                           const Pose2& T_map_reference,
                           const Pose2& T_map_current) {
  return pair_geometry(visible_surface(caster, scanner, T_map_reference),
                       visible_surface(caster, scanner, T_map_current));
}

}  // namespace setsquare
