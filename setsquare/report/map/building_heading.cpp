// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/building_heading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/paper/direction_curve.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxPoints = 8'000;
constexpr std::size_t kStepsPerQuarterTurn = 450;  // 0.2 degrees, refined by a parabola
constexpr double kBinWidth_m = 0.1;
constexpr double kMaxDistance_m = 500.0;  // from the middle; what lies beyond has no vote

/// An even sample of all returns, in the map frame.
PointSet sample_of_returns(std::span<const PlacedScan> scans) {
  std::size_t num_beams = 0;
  for (const PlacedScan& placed : scans) num_beams += placed.scan->num_beams();
  // Coprime to the usual numbers of beams, so that scans do not all give the same beams.
  const std::size_t stride = num_beams / kMaxPoints | 1U;
  PointSet sample;
  std::size_t next = 0;
  std::size_t first_beam = 0;
  for (const PlacedScan& placed : scans) {
    const Scan& scan = *placed.scan;
    for (; next < first_beam + scan.num_beams(); next += stride) {
      const std::size_t beam = next - first_beam;
      if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
      const double bearing_rad = scan.bearing_rad(beam);
      const Eigen::Vector2d p_sensor =
          scan.ranges_m[beam] * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
      const Eigen::Vector2d p_map = placed.T_map_sensor * p_sensor;
      if (!p_map.allFinite()) continue;
      sample.push_back(p_map.x(), p_map.y(), static_cast<std::int32_t>(beam));
    }
    first_beam += scan.num_beams();
  }
  return sample;
}

/// Moves the points' mean to the origin, so that the bins may end soon behind the walls.
void centre(PointSet& points) {
  const auto num_points = static_cast<double>(points.size());
  const auto shift = [num_points](std::vector<double>& values_m) {
    const double mean_m = std::accumulate(values_m.begin(), values_m.end(), 0.0) / num_points;
    for (double& value_m : values_m) value_m -= mean_m;
  };
  shift(points.x_m);
  shift(points.y_m);
}

ProfileBins bins_around(const PointSet& points) {
  double farthest_m = 1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    farthest_m = std::max(farthest_m, std::hypot(points.x_m[i], points.y_m[i]));
  }
  return {kBinWidth_m, std::ceil(std::min(farthest_m, kMaxDistance_m))};
}

/// Where the parabola through three equally spaced values has its top, in steps from the middle.
double top_of_parabola(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

}  // namespace

double building_heading_rad(std::span<const PlacedScan> scans) {
  PointSet points = sample_of_returns(scans);
  if (points.empty()) return 0.0;
  centre(points);
  constexpr double kStep_rad = 0.5 * kPi / kStepsPerQuarterTurn;
  const std::vector<double> moments =
      direction_curve(points, {0.0, kStep_rad, 2 * kStepsPerQuarterTurn}, bins_around(points));
  std::vector<double> sums(kStepsPerQuarterTurn);
  for (std::size_t j = 0; j < kStepsPerQuarterTurn; ++j) {
    sums[j] = moments[j] + moments[j + kStepsPerQuarterTurn];
  }
  const auto peak =
      static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  const double offset_steps =
      top_of_parabola(sums[(peak + kStepsPerQuarterTurn - 1) % kStepsPerQuarterTurn],
                      sums[peak],
                      sums[(peak + 1) % kStepsPerQuarterTurn]);
  // theta lays the walls along the axes, so they run along -theta.
  return wrap_to_period(-(static_cast<double>(peak) + offset_steps) * kStep_rad, 0.5 * kPi);
}

}  // namespace setsquare
