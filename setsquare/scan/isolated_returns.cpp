// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/isolated_returns.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {

bool is_isolated_return(const Scan& scan, std::size_t beam) {
  constexpr double kWidestThing_m = 0.05;
  constexpr double kLeastGap_m = 0.3;
  constexpr double kFarthestShare = 0.8;
  if (beam == 0 || beam + 1 >= scan.num_beams()) return false;
  const double range_m = scan.ranges_m[beam];
  const double behind_m = std::min(scan.ranges_m[beam - 1], scan.ranges_m[beam + 1]);
  const bool is_in_front = range_m < behind_m - kLeastGap_m && range_m < kFarthestShare * behind_m;
  return is_in_front && 2.0 * range_m * std::abs(scan.bearing_step_rad) < kWidestThing_m &&
         scan.outcome(beam) == BeamOutcome::kReturn;
}

std::size_t num_isolated_returns(const Scan& scan) {
  std::size_t num_isolated = 0;
  for (std::size_t beam = 1; beam + 1 < scan.num_beams(); ++beam) {
    num_isolated += is_isolated_return(scan, beam) ? 1 : 0;
  }
  return num_isolated;
}

std::optional<Scan> without_isolated_returns(const Scan& scan) {
  constexpr std::size_t kLeast = 8;
  constexpr std::size_t kBeamsPerThing = 100;
  if (std::abs(scan.bearing_step_rad) >= kFineStep_rad) return std::nullopt;
  const std::size_t num_isolated = num_isolated_returns(scan);
  if (num_isolated < kLeast || kBeamsPerThing * num_isolated < scan.num_beams()) {
    return std::nullopt;
  }
  Scan without = scan;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (is_isolated_return(scan, beam)) without.ranges_m[beam] = 0.0;
  }
  return without;
}

}  // namespace setsquare
