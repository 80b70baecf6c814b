// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/direction_moment.hpp"

#include <cstddef>
#include <vector>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

double neighbour_differences(std::span<const std::int32_t> profile) {
  std::int64_t sum = 0;
  std::int64_t previous = 0;
  for (const std::int64_t count : profile) {
    sum += (count - previous) * (count - previous);
    previous = count;
  }
  return static_cast<double>(sum + previous * previous);
}

double squared_frequency(std::span<const std::int32_t> profile) {
  // Few bins of a profile hold points: only those are paired.
  std::vector<std::size_t> filled;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (profile[k] != 0) filled.push_back(k);
  }
  double sum = 0.0;
  for (std::size_t a = 0; a < filled.size(); ++a) {
    const double count = profile[filled[a]];
    double others = count * (kPi * kPi / 6.0);
    for (std::size_t b = a + 1; b < filled.size(); ++b) {
      const std::size_t distance = filled[b] - filled[a];
      const double squared = static_cast<double>(distance) * static_cast<double>(distance);
      const double other = profile[filled[b]];
      others += (distance % 2 == 0 ? 2.0 : -2.0) * other / squared;
    }
    sum += 2.0 * count * others;
  }
  return sum;
}

}  // namespace

double direction_moment(std::span<const std::int32_t> profile, DirectionMoment reading) {
  return reading == DirectionMoment::kNeighbourDifferences ? neighbour_differences(profile)
                                                           : squared_frequency(profile);
}

}  // namespace setsquare
