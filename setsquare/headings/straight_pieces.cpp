// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/straight_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "setsquare/core/median.hpp"

namespace setsquare {
namespace {

double distance_between(const PointSet& points, std::size_t a, std::size_t b) {
  const double dx_m = points.x_m[b] - points.x_m[a];
  const double dy_m = points.y_m[b] - points.y_m[a];
  return std::sqrt(dx_m * dx_m + dy_m * dy_m);
}

/// The line through two points; where they coincide, the distance from it is that from them.
class Chord {
 public:
  Chord(const PointSet& points, std::size_t a, std::size_t b) : points_(points), from_(a) {
    const double length_m = distance_between(points, a, b);
    is_point_ = length_m < 1e-9;
    if (is_point_) return;
    unit_x_ = (points.x_m[b] - points.x_m[a]) / length_m;
    unit_y_ = (points.y_m[b] - points.y_m[a]) / length_m;
  }

  double distance_of(std::size_t i) const {
    if (is_point_) return distance_between(points_, from_, i);
    return std::abs(unit_x_ * (points_.y_m[i] - points_.y_m[from_]) -
                    unit_y_ * (points_.x_m[i] - points_.x_m[from_]));
  }

 private:
  const PointSet& points_;
  std::size_t from_;
  bool is_point_ = false;
  double unit_x_ = 0.0;
  double unit_y_ = 0.0;
};

/// Total least squares over the points [first, last].
StraightPiece fit_piece(const PointSet& points, std::size_t first, std::size_t last) {
  const auto n = static_cast<double>(last - first + 1);
  double x = 0.0, y = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    x += points.x_m[i];
    y += points.y_m[i];
  }
  x /= n;
  y /= n;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double dx = points.x_m[i] - x;
    const double dy = points.y_m[i] - y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double difference = std::hypot(xx - yy, 2.0 * xy);
  const double along = 0.5 * (xx + yy + difference);
  const double across = std::max(0.5 * (xx + yy - difference), 0.0);
  return {0.5 * std::atan2(2.0 * xy, xx - yy),
          std::sqrt(12.0 * along / n),
          along,
          std::sqrt(across / n),
          x,
          y};
}

/// Splits runs of points and collects the straight ones.
class Splitter {
 public:
  Splitter(const PointSet& points, double tolerance_m, std::int32_t min_num_points)
      : points_(points), tolerance_m_(tolerance_m), min_num_points_(min_num_points) {}

  void split(std::size_t run_first, std::size_t run_last) {
    pending_.assign(1, {run_first, run_last});
    while (!pending_.empty()) {
      const Run run = pending_.back();
      pending_.pop_back();
      if (run.last - run.first + 1 < static_cast<std::size_t>(min_num_points_)) continue;
      const std::size_t corner = furthest_off_chord(run);
      if (corner == run.first) {
        pieces_.push_back(fit_piece(points_, run.first, run.last));
      } else {
        pending_.push_back({corner, run.last});
        pending_.push_back({run.first, corner});
      }
    }
  }

  std::vector<StraightPiece> take() { return std::move(pieces_); }

 private:
  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  /// The first point of the run where none lies further off than the tolerance.
  std::size_t furthest_off_chord(const Run& run) const {
    const Chord chord(points_, run.first, run.last);
    std::size_t furthest = run.first;
    double furthest_m = tolerance_m_;
    for (std::size_t i = run.first + 1; i < run.last; ++i) {
      const double here_m = chord.distance_of(i);
      if (here_m > furthest_m) {
        furthest_m = here_m;
        furthest = i;
      }
    }
    return furthest;
  }

  const PointSet& points_;
  double tolerance_m_;
  std::int32_t min_num_points_;
  std::vector<Run> pending_;
  std::vector<StraightPiece> pieces_;
};

/// True where the return i does not continue the surface of the one before it.
bool is_gap(const PointSet& points,
            std::size_t i,
            double bearing_step_rad,
            const StraightPieceParams& params) {
  if (points.beam[i] - points.beam[i - 1] > params.max_skipped_beams + 1) return true;
  const double apart_m = distance_between(points, i - 1, i);
  if (apart_m <= params.max_gap_m) return false;
  const double range_m = std::hypot(points.x_m[i], points.y_m[i]);
  return apart_m > range_m * std::abs(bearing_step_rad) * params.max_gap_beams;
}

}  // namespace

double surface_noise_m(const PointSet& points, double max_gap_m) {
  constexpr std::size_t kMinSamples = 10;
  // Of normal noise: the median of |n| is 0.6745 sigma, and a point less the mean of its two
  // neighbours has sqrt(3/2) sigma.
  constexpr double kMedianOfNoise = 0.6745 * 1.224745;
  std::vector<double> distances_m;
  distances_m.reserve(points.size());
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double chord_m = distance_between(points, i - 1, i + 1);
    if (chord_m > 2.5 * max_gap_m || chord_m < 1e-6) continue;
    distances_m.push_back(Chord(points, i - 1, i + 1).distance_of(i));
  }
  if (distances_m.size() < kMinSamples) return 0.0;
  return upper_median(std::move(distances_m)) / kMedianOfNoise;
}

std::vector<StraightPiece> straight_pieces(const PointSet& points,
                                           double bearing_step_rad,
                                           const StraightPieceParams& params) {
  const double tolerance_m =
      std::clamp(params.tolerance_per_noise * surface_noise_m(points, params.max_gap_m),
                 params.min_tolerance_m,
                 params.max_tolerance_m);
  Splitter splitter(points, tolerance_m, params.min_num_points);
  std::size_t first = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    if (i < points.size() && !is_gap(points, i, bearing_step_rad, params)) continue;
    splitter.split(first, i - 1);
    first = i;
  }
  return splitter.take();
}

}  // namespace setsquare
