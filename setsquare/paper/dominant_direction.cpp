// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/dominant_direction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

DominantDirection largest(const DirectionGrid& grid, const std::vector<double>& curve) {
  const auto best = std::max_element(curve.begin(), curve.end());  // The first of equal ones.
  return {grid.direction_rad(static_cast<std::size_t>(best - curve.begin())), *best};
}

/// The argmax of the moment with omega^2, which is costly to compute: directions in the order of
/// their upper bound, until no bound reaches the best moment found.
DominantDirection largest_squared_frequency(const PointSet& points,
                                            const DirectionGrid& grid,
                                            const ProfileBins& bins) {
  const std::vector<double> bound = direction_curves(points, grid, bins).squared_frequency_bound;
  std::vector<std::size_t> order(bound.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto by_bound = [&bound](std::size_t a, std::size_t b) { return bound[a] < bound[b]; };
  std::make_heap(order.begin(), order.end(), by_bound);
  std::size_t best = 0;
  double best_moment = 0.0;
  while (!order.empty() && bound[order.front()] >= best_moment) {
    std::pop_heap(order.begin(), order.end(), by_bound);
    const std::size_t j = order.back();
    order.pop_back();
    const double moment =
        direction_moment(projected_profile(points, grid.direction_rad(j), bins).counts,
                         DirectionMoment::kSquaredFrequency);
    if (moment > best_moment || (moment == best_moment && j < best)) {
      best = j;
      best_moment = moment;
    }
  }
  return {grid.direction_rad(best), best_moment};
}

}  // namespace

void DominantDirectionParams::validate() const {
  bins.validate();
  const double num_steps = kPi / step_rad;
  if (!(step_rad > 0.0) || num_steps > 1e6 || std::abs(num_steps - std::round(num_steps)) > 1e-6) {
    throw ParameterError("step_rad", "must divide half a turn into at most 1e6 steps");
  }
}

DirectionGrid dominant_direction_grid(const DominantDirectionParams& params) {
  return {-kPi, params.step_rad, static_cast<std::size_t>(std::lround(kPi / params.step_rad))};
}

DominantDirection dominant_direction(const PointSet& points,
                                     const DominantDirectionParams& params) {
  const DirectionGrid grid = dominant_direction_grid(params);
  if (points.empty()) return {grid.first_rad, 0.0};
  if (params.moment == DirectionMoment::kSquaredFrequency) {
    return largest_squared_frequency(points, grid, params.bins);
  }
  return largest(grid, direction_curve(points, grid, params.bins));
}

}  // namespace setsquare
