// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/straight_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace setsquare {
namespace {

/// Distance of point i from the line through points a and b; from a where the two coincide.
double distance_from_chord(const PointSet& points, std::size_t i, std::size_t a, std::size_t b) {
  const double chord_x = points.x_m[b] - points.x_m[a];
  const double chord_y = points.y_m[b] - points.y_m[a];
  const double to_x = points.x_m[i] - points.x_m[a];
  const double to_y = points.y_m[i] - points.y_m[a];
  const double length_m = std::hypot(chord_x, chord_y);
  if (length_m < 1e-9) return std::hypot(to_x, to_y);
  return std::abs(chord_x * to_y - chord_y * to_x) / length_m;
}

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
    std::size_t furthest = run.first;
    double distance_m = tolerance_m_;
    for (std::size_t i = run.first + 1; i < run.last; ++i) {
      const double here_m = distance_from_chord(points_, i, run.first, run.last);
      if (here_m > distance_m) {
        distance_m = here_m;
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
  const double distance_m =
      std::hypot(points.x_m[i] - points.x_m[i - 1], points.y_m[i] - points.y_m[i - 1]);
  if (distance_m <= params.max_gap_m) return false;
  const double range_m = std::hypot(points.x_m[i], points.y_m[i]);
  return distance_m > range_m * std::abs(bearing_step_rad) * params.max_gap_beams;
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
    const double chord_m =
        std::hypot(points.x_m[i + 1] - points.x_m[i - 1], points.y_m[i + 1] - points.y_m[i - 1]);
    if (chord_m > 2.5 * max_gap_m || chord_m < 1e-6) continue;
    distances_m.push_back(distance_from_chord(points, i, i - 1, i + 1));
  }
  if (distances_m.size() < kMinSamples) return 0.0;
  const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
  std::nth_element(distances_m.begin(), middle, distances_m.end());
  return *middle / kMedianOfNoise;
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
