// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/noisy_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kNoisy_m = 0.035;
constexpr double kSmoothing_rad = rad_from_deg(4.0);
constexpr std::size_t kMinDifferences = 30;
constexpr std::size_t kMaxDifferences = 270;  // As many tell the noise as well as all do.

/// Absolute second differences of three returns in a row.
std::vector<double> second_differences_m(const Scan& scan) {
  std::vector<double> differences_m;
  if (scan.num_beams() < kMinDifferences + 2) return differences_m;
  differences_m.reserve(kMaxDifferences + 1);
  const std::size_t stride = 1 + (scan.num_beams() - 2) / kMaxDifferences;
  for (std::size_t beam = 1; beam + 1 < scan.num_beams(); beam += stride) {
    if (scan.outcome(beam - 1) != BeamOutcome::kReturn ||
        scan.outcome(beam) != BeamOutcome::kReturn ||
        scan.outcome(beam + 1) != BeamOutcome::kReturn) {
      continue;
    }
    const double* const range_m = scan.ranges_m.data() + beam;
    differences_m.push_back(std::abs(range_m[-1] - 2.0 * range_m[0] + range_m[1]));
  }
  return differences_m;
}

/// The value that a share of the values lies below; orders them anew.
double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The range at a beam by the line through its neighbours that do not lie off by more than
/// `step_m`.
double range_by_line(const Scan& scan, std::size_t beam, std::size_t reach, double step_m) {
  const std::size_t first = beam > reach ? beam - reach : 0;
  const std::size_t last = std::min(beam + reach, scan.num_beams() - 1);
  const double at_m = scan.ranges_m[beam];
  double n = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_xx = 0.0;
  double sum_xy = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    if (scan.outcome(i) != BeamOutcome::kReturn || std::abs(scan.ranges_m[i] - at_m) > step_m) {
      continue;
    }
    const double x = static_cast<double>(i) - static_cast<double>(beam);
    const double y_m = scan.ranges_m[i];
    n += 1.0;
    sum_x += x;
    sum_y += y_m;
    sum_xx += x * x;
    sum_xy += x * y_m;
  }
  const double determinant = n * sum_xx - sum_x * sum_x;
  constexpr double kLeast = 4.0;  // Fewer are no line.
  if (n < kLeast || !(determinant > 0.0)) return at_m;
  return (sum_xx * sum_y - sum_x * sum_xy) / determinant;
}

}  // namespace

double range_noise_m(const Scan& scan) {
  // Of |N(0, 1)|: a fifth lies below 0.2533, nine tenths below 1.645, 6.5 times as much. A second
  // difference of independent values of one variance has six times that variance.
  constexpr double kLow = 0.2533;
  constexpr double kMaxRatio = 10.0;  // Clutter has far more large differences than small ones.
  std::vector<double> differences_m = second_differences_m(scan);
  if (differences_m.size() < kMinDifferences) return 0.0;
  const double low_m = quantile(differences_m, 0.2);
  if (!(low_m > 0.0) || quantile(differences_m, 0.9) > kMaxRatio * low_m) return 0.0;
  return low_m / (kLow * std::sqrt(6.0));
}

std::optional<std::vector<double>> smoothed_ranges_m(const Scan& scan) {
  const double noise_m = range_noise_m(scan);
  if (noise_m < kNoisy_m) return std::nullopt;
  const double step_m = 3.0 * std::sqrt(2.0) * noise_m;
  const auto reach = static_cast<std::size_t>(std::min(
      kSmoothing_rad / std::abs(scan.bearing_step_rad), static_cast<double>(scan.num_beams())));
  std::vector<double> smoothed_m = scan.ranges_m;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
    smoothed_m[beam] = range_by_line(scan, beam, reach, step_m);
  }
  return smoothed_m;
}

}  // namespace setsquare
