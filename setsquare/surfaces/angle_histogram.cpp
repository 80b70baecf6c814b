// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/angle_histogram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/approximate_bearing.hpp"
#include "setsquare/surfaces/lanes.hpp"

namespace setsquare {
namespace {

constexpr int kNumBins = AngleHistogram::kNumBins;
constexpr int kSeparationBins = 2;

std::array<float, kNumBins> smooth(const std::array<float, kNumBins>& raw) {
  constexpr int kReach = 1;
  constexpr std::array<float, 2 * kReach + 1> kKernel{0.25F, 0.5F, 0.25F};
  std::array<float, kNumBins + 2 * kReach> padded;
  for (int i = 0; i < kNumBins + 2 * kReach; ++i) {
    padded[i] = raw[(i - kReach + kNumBins) % kNumBins];
  }
  std::array<float, kNumBins> smoothed{};
  for (int k = 0; k <= 2 * kReach; ++k) {
    for (int i = 0; i < kNumBins; ++i) smoothed[i] += kKernel[k] * padded[i + k];
  }
  return smoothed;
}

float dot(const float* a, const float* b) {
  static_assert(kNumBins % kLanes == 0);
  Floats sum{};
  for (std::size_t i = 0; i < kNumBins; i += kLanes) sum += load_lanes(a + i) * load_lanes(b + i);
  return sum_of(sum);
}

/// Walls within this many bins have the same direction.
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

int AngleHistogram::bin_of(float normal_x, float normal_y) {
  constexpr float kBinsPerRad = kNumBins / static_cast<float>(kTwoPi);
  const float bearing_rad = approximate_bearing(normal_y, normal_x);
  const int bin = static_cast<int>((bearing_rad + static_cast<float>(kPi)) * kBinsPerRad);
  return std::clamp(bin, 0, kNumBins - 1);
}

AngleHistogram angle_histogram(const SurfacePoints& points) {
  std::array<float, kNumBins> raw{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.normal_x[i] == 0.0F && points.normal_y[i] == 0.0F) continue;
    raw[AngleHistogram::bin_of(points.normal_x[i], points.normal_y[i])] += points.weight_m[i];
  }
  return {smooth(raw)};
}

std::vector<RotationProposal> propose_rotations(const AngleHistogram& reference,
                                                const AngleHistogram& current,
                                                std::size_t max_proposals) {
  // correlation[lag]: the current's bin i lies on the reference's bin i + lag.
  std::array<float, 2 * kNumBins> reference_twice;
  std::copy(reference.length_m.begin(), reference.length_m.end(), reference_twice.begin());
  std::copy(
      reference.length_m.begin(), reference.length_m.end(), reference_twice.begin() + kNumBins);
  std::array<float, kNumBins> correlation;
  for (int lag = 0; lag < kNumBins; ++lag) {
    correlation[lag] = dot(reference_twice.data() + lag, current.length_m.data());
  }
  const double energy =
      std::sqrt(static_cast<double>(dot(reference.length_m.data(), reference.length_m.data())) *
                dot(current.length_m.data(), current.length_m.data()));
  std::vector<RotationProposal> proposals;
  if (!(energy > 0.0)) return proposals;
  const auto at = [&](int lag) { return correlation[(lag + kNumBins) % kNumBins]; };
  for (int lag = 0; lag < kNumBins; ++lag) {
    bool is_peak = at(lag) > 0.0F;
    for (int k = 1; k <= kSeparationBins && is_peak; ++k) {
      is_peak = at(lag) >= at(lag - k) && at(lag) > at(lag + k);
    }
    if (!is_peak) continue;
    const double curvature = at(lag - 1) - 2.0 * at(lag) + at(lag + 1);
    const double shift = curvature < 0.0 ? 0.5 * (at(lag - 1) - at(lag + 1)) / curvature : 0.0;
    proposals.push_back({wrap_to_pi((lag + shift) * kTwoPi / kNumBins), at(lag) / energy});
  }
  std::sort(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
    return a.correlation > b.correlation;
  });
  if (proposals.size() > max_proposals) proposals.resize(max_proposals);
  return proposals;
}

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
