// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/unchanged_share.hpp"

#include <cmath>
#include <cstddef>

namespace setsquare {

std::optional<double> unchanged_share(const Scan& before, const Scan& after) {
  constexpr double kTolerance_m = 0.1;
  constexpr double kToleranceRatio = 0.03;
  constexpr std::size_t kLeastCompared = 20;
  if (before.num_beams() != after.num_beams()) return std::nullopt;
  std::size_t num_compared = 0;
  std::size_t num_unchanged = 0;
  for (std::size_t beam = 0; beam < before.num_beams(); ++beam) {
    if (before.outcome(beam) != BeamOutcome::kReturn) continue;
    if (after.outcome(beam) != BeamOutcome::kReturn) continue;
    const double range_m = before.ranges_m[beam];
    ++num_compared;
    num_unchanged +=
        std::abs(after.ranges_m[beam] - range_m) < kTolerance_m + kToleranceRatio * range_m ? 1 : 0;
  }
  if (num_compared < kLeastCompared) return std::nullopt;
  return static_cast<double>(num_unchanged) / static_cast<double>(num_compared);
}

}  // namespace setsquare
