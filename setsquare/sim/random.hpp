// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace setsquare {

/// Random numbers that are the same on every machine: the distributions of the standard library are
/// not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform();  ///< In [0, 1).
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  [[nodiscard]] int integer(int low, int high);  ///< Both ends included.
  [[nodiscard]] bool chance(double probability) { return uniform() < probability; }
  [[nodiscard]] double normal();  ///< Mean 0, standard deviation 1.

 private:
  std::mt19937_64 engine_;
};

/// A seed for part `part` of what has seed `seed`: different parts are independent.
[[nodiscard]] std::uint64_t sub_seed(std::uint64_t seed, std::uint64_t part);

}  // namespace setsquare
