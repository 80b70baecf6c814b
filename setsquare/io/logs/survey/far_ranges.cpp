// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/survey/far_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {

void FarRanges::add_far(double range_m) {
  if (!std::isfinite(range_m) || codes_.is_code(range_m)) return;
  ++num_measured_;
  shortest_ = std::min(shortest_, range_m);
  longest_ = std::max(longest_, range_m);
  const auto octave = static_cast<std::size_t>(std::ilogb(range_m));
  ++num_per_octave_[std::min(octave, num_per_octave_.size() - 1)];
}

double FarRanges::octave_of_median() const {
  std::uint64_t num_below = 0;
  for (std::size_t octave = 0; octave < num_per_octave_.size(); ++octave) {
    num_below += num_per_octave_[octave];
    if (2 * num_below > num_measured_) return std::ldexp(1.0, static_cast<int>(octave));
  }
  return 0.0;
}

}  // namespace setsquare
