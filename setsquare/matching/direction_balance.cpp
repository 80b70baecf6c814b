// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/direction_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace setsquare {
namespace {

constexpr int kNumBins = AngleHistogram::kNumBins;
/// Walls run the same way within so many bins.
constexpr int kReachBins = 2;
/// A direction is no rarer than this: a single post is no wall.
constexpr float kMinShare = 0.03F;

/// For each direction that walls face, what a metre of them counts.
std::array<float, kNumBins> factor_of_bins(const AngleHistogram& histogram) {
  static_assert(kNumBins % 2 == 0);
  const float total_m = std::accumulate(histogram.length_m.begin(), histogram.length_m.end(), 0.0F);
  const auto length_m = [&](int bin) {
    return histogram.length_m[(bin + kNumBins) % kNumBins] +
           histogram.length_m[(bin + kNumBins + kNumBins / 2) % kNumBins];
  };
  std::array<float, kNumBins> factors;
  for (int bin = 0; bin < kNumBins; ++bin) {
    float alike_m = 0.0F;
    for (int k = -kReachBins; k <= kReachBins; ++k) alike_m += length_m(bin + k);
    factors[bin] = 1.0F / std::sqrt(std::max(kMinShare, alike_m / total_m));
  }
  return factors;
}

}  // namespace

std::vector<float> direction_balanced_weights(const SurfacePoints& points,
                                              const AngleHistogram& histogram) {
  const std::array<float, kNumBins> factors = factor_of_bins(histogram);
  std::vector<float> weights(points.weight_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.normal_x[i] == 0.0F && points.normal_y[i] == 0.0F) continue;
    weights[i] *= factors[AngleHistogram::bin_of(points.normal_x[i], points.normal_y[i])];
  }
  const float before_m = std::accumulate(points.weight_m.begin(), points.weight_m.end(), 0.0F);
  const float after_m = std::accumulate(weights.begin(), weights.end(), 0.0F);
  if (after_m > 0.0F) {
    for (float& weight_m : weights) weight_m *= before_m / after_m;
  }
  return weights;
}

}  // namespace setsquare
