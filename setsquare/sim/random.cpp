// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/random.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

int Random::integer(int low, int high) {
  const double span = static_cast<double>(high) - static_cast<double>(low) + 1.0;
  return low + static_cast<int>(uniform() * span);
}

double Random::normal() {
  // Box and Muller; 1 - u is never 0.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * kPi * uniform());
}

std::uint64_t sub_seed(std::uint64_t seed, std::uint64_t part) {
  // The finaliser of SplitMix64 over a sequence that both numbers step through.
  std::uint64_t z = seed * 0xD1342543DE82EF95ULL + (part + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

}  // namespace setsquare
