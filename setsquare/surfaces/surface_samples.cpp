// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_samples.hpp"

#include <numeric>
#include <utility>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"
#include "setsquare/surfaces/lanes.hpp"

namespace setsquare {
namespace {

void push_back(const SurfacePoints& points,
               std::size_t i,
               float weight_m,
               SurfaceSamples& samples) {
  samples.x_m.push_back(points.x_m[i]);
  samples.y_m.push_back(points.y_m[i]);
  samples.normal_x.push_back(points.normal_x[i]);
  samples.normal_y.push_back(points.normal_y[i]);
  samples.weight_m.push_back(weight_m);
}

SurfaceSamples padded(SurfaceSamples samples) {
  samples.count = samples.x_m.size();
  const std::size_t padded_size = (samples.count + kLanes - 1) / kLanes * kLanes;
  for (auto* array :
       {&samples.x_m, &samples.y_m, &samples.normal_x, &samples.normal_y, &samples.weight_m}) {
    array->resize(padded_size, 0.0F);
  }
  return samples;
}

}  // namespace

void SampleParams::validate() const {
  require_at_least_one(max_coarse, "max_coarse");
  if (max_coarse > CorrelationGrid::kMaxSamples) {
    throw ParameterError("max_coarse", "must be at most 60");
  }
  require_at_least_one(max_fine, "max_fine");
  require_at_least_one(max_dense, "max_dense");
}

SurfaceSamples sample_surface(const SurfacePoints& points, std::size_t max_samples) {
  return sample_surface(points, points.weight_m, max_samples);
}

SurfaceSamples sample_surface(const SurfacePoints& points,
                              std::span<const float> weights_m,
                              std::size_t max_samples) {
  SurfaceSamples samples;
  if (points.size() <= max_samples) {
    samples.x_m = points.x_m;
    samples.y_m = points.y_m;
    samples.normal_x = points.normal_x;
    samples.normal_y = points.normal_y;
    samples.weight_m.assign(weights_m.begin(), weights_m.end());
    return padded(std::move(samples));
  }
  for (auto* array :
       {&samples.x_m, &samples.y_m, &samples.normal_x, &samples.normal_y, &samples.weight_m}) {
    array->reserve(max_samples);
  }
  const double total_m = std::accumulate(weights_m.begin(), weights_m.end(), 0.0);
  const double step_m = total_m / static_cast<double>(max_samples);
  double walked_m = 0.0;
  double next_m = 0.5 * step_m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    walked_m += weights_m[i];
    if (walked_m <= next_m) continue;
    int num_steps = 0;
    for (; walked_m > next_m; ++num_steps) next_m += step_m;
    push_back(points, i, static_cast<float>(num_steps * step_m), samples);
  }
  return padded(std::move(samples));
}

}  // namespace setsquare
