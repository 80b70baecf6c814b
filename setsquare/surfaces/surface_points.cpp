// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/scan/noisy_ranges.hpp"

namespace setsquare {
namespace {

/// Largest number of missing beams that a surface may bridge.
constexpr std::int32_t kMaxBeamGap = 3;

struct Moments {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  friend Moments operator-(const Moments& a, const Moments& b) {
    return {a.n - b.n, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
  }
};

struct LineFit {
  double normal_x = 0.0;
  double normal_y = 0.0;
  double mean_square_m2 = 0.0;  ///< Mean squared distance of the points from the line.
};

/// Total least squares through a window's moments; the direction's half angle without trigonometry.
LineFit fit_line(const Moments& m) {
  const double inverse_n = 1.0 / m.n;
  const double sxx = m.xx * inverse_n - m.x * m.x * inverse_n * inverse_n;
  const double sxy = m.xy * inverse_n - m.x * m.y * inverse_n * inverse_n;
  const double syy = m.yy * inverse_n - m.y * m.y * inverse_n * inverse_n;
  const double half_difference = 0.5 * (sxx - syy);
  const double radius = std::sqrt(half_difference * half_difference + sxy * sxy);
  const double cos_double = radius > 0.0 ? half_difference / radius : 1.0;
  const double direction_x = std::sqrt(std::max(0.0, 0.5 * (1.0 + cos_double)));
  const double direction_y = std::copysign(std::sqrt(std::max(0.0, 0.5 * (1.0 - cos_double))), sxy);
  return {-direction_y, direction_x, std::max(0.0, 0.5 * (sxx + syy) - radius)};
}

double distance(const SurfacePoints& points, std::size_t i, std::size_t j) {
  const double dx_m = points.x_m[i] - points.x_m[j];
  const double dy_m = points.y_m[i] - points.y_m[j];
  return std::sqrt(dx_m * dx_m + dy_m * dy_m);
}

/// The returns as points; one rotation a beam instead of a sine and a cosine.
SurfacePoints place_returns(const Scan& scan, double max_range_m) {
  const std::optional<std::vector<double>> smoothed_m = smoothed_ranges_m(scan);
  const double* const ranges_m = smoothed_m ? smoothed_m->data() : scan.ranges_m.data();
  SurfacePoints points;
  const std::size_t capacity = scan.num_beams();
  for (auto* array : {&points.x_m, &points.y_m, &points.range_m}) array->reserve(capacity);
  points.beam.reserve(capacity);
  double c = std::cos(scan.first_bearing_rad);
  double s = std::sin(scan.first_bearing_rad);
  const double step_c = std::cos(scan.bearing_step_rad);
  const double step_s = std::sin(scan.bearing_step_rad);
  for (std::size_t beam = 0; beam < capacity; ++beam) {
    const double range_m = ranges_m[beam];
    if (scan.outcome(beam) == BeamOutcome::kReturn && range_m < max_range_m) {
      points.x_m.push_back(static_cast<float>(range_m * c));
      points.y_m.push_back(static_cast<float>(range_m * s));
      points.range_m.push_back(static_cast<float>(range_m));
      points.beam.push_back(static_cast<std::int32_t>(beam));
    }
    const double next_c = c * step_c - s * step_s;
    s = s * step_c + c * step_s;
    c = next_c;
  }
  return points;
}

/// Whether the points i-1, i, i+1, i+2 (as far as they exist, three at least) lie on one line.
bool are_collinear(const SurfacePoints& points, std::size_t i, double tolerance_m) {
  const std::size_t n = points.size();
  if (n < 3) return false;
  const double ax = points.x_m[i];
  const double ay = points.y_m[i];
  const double gap_m = distance(points, i, i + 1);
  const double ux = (points.x_m[i + 1] - ax) / gap_m;
  const double uy = (points.y_m[i + 1] - ay) / gap_m;
  const auto is_on_line = [&](std::size_t k) {
    const double along_m = (points.x_m[k] - ax) * ux + (points.y_m[k] - ay) * uy;
    const double across_m = (points.x_m[k] - ax) * uy - (points.y_m[k] - ay) * ux;
    const bool is_outside = along_m < 0.0 || along_m > gap_m;
    return is_outside && std::abs(across_m) < tolerance_m;
  };
  const bool has_before = i > 0;
  const bool has_after = i + 2 < n;
  return (!has_before || is_on_line(i - 1)) && (!has_after || is_on_line(i + 2));
}

void join_neighbours(const Scan& scan, const SurfaceParams& params, SurfacePoints& points) {
  const std::size_t n = points.size();
  points.joined.assign(n, 0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (points.beam[i + 1] - points.beam[i] > kMaxBeamGap) continue;
    const double gap_m = distance(points, i, i + 1);
    const double beam_spacing_m =
        std::abs(scan.bearing_step_rad) * std::min(points.range_m[i], points.range_m[i + 1]);
    const double near_m =
        std::max(params.join_distance_m, params.join_beam_spacings * beam_spacing_m);
    points.joined[i] = gap_m < near_m || (gap_m < params.max_join_m &&
                                          are_collinear(points, i, params.collinear_tolerance_m));
  }
}

std::vector<Moments> cumulate_moments(const SurfacePoints& points) {
  std::vector<Moments> sums(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x_m[i];
    const double y = points.y_m[i];
    const Moments& m = sums[i];
    sums[i + 1] = {m.n + 1.0, m.x + x, m.y + y, m.xx + x * x, m.xy + x * y, m.yy + y * y};
  }
  return sums;
}

/// First and last joined neighbour within the radius around point i, one on each side at least
/// where the surface continues.
struct Window {
  std::size_t first = 0;
  std::size_t last = 0;
};

Window window_around(const SurfacePoints& points, std::size_t i, double radius_m) {
  const float x_m = points.x_m[i];
  const float y_m = points.y_m[i];
  const float limit_m2 = static_cast<float>(radius_m * radius_m);
  const auto is_within = [&](std::size_t k) {
    const float dx_m = points.x_m[k] - x_m;
    const float dy_m = points.y_m[k] - y_m;
    return dx_m * dx_m + dy_m * dy_m <= limit_m2;
  };
  Window window{i, i};
  // Hundreds of neighbours a side fix a line as well as thousands do.
  constexpr std::size_t kMaxReach = 256;
  const std::size_t lowest = i > kMaxReach ? i - kMaxReach : 0;
  const std::size_t highest = std::min(i + kMaxReach, points.size() - 1);
  while (window.first > lowest && points.joined[window.first - 1] &&
         (window.first == i || is_within(window.first - 1))) {
    --window.first;
  }
  while (window.last < highest && points.joined[window.last] &&
         (window.last == i || is_within(window.last + 1))) {
    ++window.last;
  }
  return window;
}

/// The line at point i: of the whole window, or of its better side where the surface bends.
void fit_normal(const std::vector<Moments>& sums,
                const SurfaceParams& params,
                std::size_t i,
                SurfacePoints& points) {
  const Window window = window_around(points, i, params.fit_radius_m);
  if (window.last - window.first < 1) return;
  const double limit_m2 = params.max_fit_rms_m * params.max_fit_rms_m;
  LineFit fit = fit_line(sums[window.last + 1] - sums[window.first]);
  if (fit.mean_square_m2 > limit_m2) {
    LineFit best_side{.mean_square_m2 = limit_m2};
    bool found = false;
    for (const Window side : {Window{window.first, i}, Window{i, window.last}}) {
      if (side.last - side.first < 2) continue;
      const LineFit side_fit = fit_line(sums[side.last + 1] - sums[side.first]);
      if (side_fit.mean_square_m2 >= best_side.mean_square_m2) continue;
      best_side = side_fit;
      found = true;
    }
    if (!found) return;
    fit = best_side;
  }
  const double towards_sensor =
      fit.normal_x * points.x_m[i] + fit.normal_y * points.y_m[i] <= 0.0 ? 1.0 : -1.0;
  points.normal_x[i] = static_cast<float>(towards_sensor * fit.normal_x);
  points.normal_y[i] = static_cast<float>(towards_sensor * fit.normal_y);
}

/// Half the gap on either side where the surface continues; half a beam spacing where it ends.
void weigh(const Scan& scan, const SurfaceParams& params, SurfacePoints& points) {
  const std::size_t n = points.size();
  points.weight_m.assign(n, 0.0F);
  for (std::size_t i = 0; i < n; ++i) {
    const double half_spacing_m = 0.5 * std::abs(scan.bearing_step_rad) * points.range_m[i];
    const double before_m =
        i > 0 && points.joined[i - 1] ? 0.5 * distance(points, i - 1, i) : half_spacing_m;
    const double after_m = points.joined[i] ? 0.5 * distance(points, i, i + 1) : half_spacing_m;
    points.weight_m[i] = static_cast<float>(std::min(before_m + after_m, params.max_weight_m));
  }
}

}  // namespace

void SurfaceParams::validate() const {
  require_positive(max_range_m, "max_range_m");
  require_positive(join_distance_m, "join_distance_m");
  require_positive(join_beam_spacings, "join_beam_spacings");
  require_positive(collinear_tolerance_m, "collinear_tolerance_m");
  require_positive(max_join_m, "max_join_m");
  require_positive(fit_radius_m, "fit_radius_m");
  require_positive(max_fit_rms_m, "max_fit_rms_m");
  require_positive(max_weight_m, "max_weight_m");
}

SurfacePoints surface_points_from_scan(const Scan& scan, const SurfaceParams& params) {
  SurfacePoints points = place_returns(scan, params.max_range_m);
  join_neighbours(scan, params, points);
  points.normal_x.assign(points.size(), 0.0F);
  points.normal_y.assign(points.size(), 0.0F);
  const std::vector<Moments> sums = cumulate_moments(points);
  for (std::size_t i = 0; i < points.size(); ++i) fit_normal(sums, params, i, points);
  weigh(scan, params, points);
  return points;
}

}  // namespace setsquare
