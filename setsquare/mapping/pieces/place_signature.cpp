// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/place_signature.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// The lowest frequency is one period over this length.
constexpr double kLength_m = 25.6;
/// Walls that face an axis within this cosine make its profile.
constexpr double kMinCosine = 0.9;

/// Fourier sums of weighted points on a line, at 1, 2, ... periods over kLength_m.
class SpectrumSum {
 public:
  void add(double position_m, double weight_m) {
    const std::complex<double> turn = std::polar(1.0, kTwoPi * position_m / kLength_m);
    std::complex<double> wave = weight_m;
    for (std::complex<double>& sum : sums_) {
      wave *= turn;
      sum += wave;
    }
  }

  [[nodiscard]] PlaceSignature::Spectrum magnitudes() const {
    PlaceSignature::Spectrum spectrum;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      spectrum[k] = static_cast<float>(std::abs(sums_[k]));
    }
    return spectrum;
  }

 private:
  std::array<std::complex<double>, PlaceSignature::kNumFrequencies> sums_{};
};

double squared_distance(const PlaceSignature::Spectrum& a, const PlaceSignature::Spectrum& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

}  // namespace

PlaceSignature place_signature(const SurfaceSamples& samples, double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  SpectrumSum along_x;
  SpectrumSum along_y;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double normal_x = c * samples.normal_x[i] - s * samples.normal_y[i];
    const double normal_y = s * samples.normal_x[i] + c * samples.normal_y[i];
    if (std::abs(normal_x) > kMinCosine) {
      along_x.add(c * samples.x_m[i] - s * samples.y_m[i], samples.weight_m[i]);
    } else if (std::abs(normal_y) > kMinCosine) {
      along_y.add(s * samples.x_m[i] + c * samples.y_m[i], samples.weight_m[i]);
    }
  }
  PlaceSignature signature{along_x.magnitudes(), along_y.magnitudes()};
  const PlaceSignature nothing;
  const double length = std::sqrt(squared_distance(signature.along_x, nothing.along_x) +
                                  squared_distance(signature.along_y, nothing.along_y));
  const auto scale = static_cast<float>(length > 0.0 ? 1.0 / length : 0.0);
  for (float& value : signature.along_x) value *= scale;
  for (float& value : signature.along_y) value *= scale;
  return signature;
}

double signature_distance(const PlaceSignature& a, const PlaceSignature& b) {
  const double straight =
      squared_distance(a.along_x, b.along_x) + squared_distance(a.along_y, b.along_y);
  const double swapped =
      squared_distance(a.along_x, b.along_y) + squared_distance(a.along_y, b.along_x);
  return std::sqrt(std::min(straight, swapped));
}

std::vector<std::size_t> nearest_signatures(const PlaceSignature& query,
                                            std::span<const PlaceSignature> among,
                                            std::size_t num) {
  std::vector<double> distances;
  distances.reserve(among.size());
  for (const PlaceSignature& other : among) distances.push_back(signature_distance(query, other));
  std::vector<std::size_t> order(among.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(num, order.size()));
  std::partial_sort(order.begin(), end, order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(distances[a], a) < std::pair(distances[b], b);
  });
  order.erase(end, order.end());
  return order;
}

}  // namespace setsquare
