// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/tridiagonal.hpp"

#include <cassert>

namespace setsquare {

TridiagonalSystem::TridiagonalSystem(std::size_t n)
    : diagonal(n, 0.0), next(n > 0 ? n - 1 : 0, 0.0), right(n, 0.0) {}

void TridiagonalSystem::bind(std::size_t i, double value, double weight) {
  diagonal[i] += weight;
  right[i] += weight * value;
}

void TridiagonalSystem::bind_step(std::size_t i, double value, double weight) {
  diagonal[i] += weight;
  diagonal[i + 1] += weight;
  next[i] -= weight;
  right[i] -= weight * value;
  right[i + 1] += weight * value;
}

std::vector<double> solve(TridiagonalSystem system) {
  const std::size_t n = system.diagonal.size();
  for (std::size_t i = 1; i < n; ++i) {
    assert(system.diagonal[i - 1] > 0.0);
    const double factor = system.next[i - 1] / system.diagonal[i - 1];
    system.diagonal[i] -= factor * system.next[i - 1];
    system.right[i] -= factor * system.right[i - 1];
  }
  std::vector<double> x(n);
  for (std::size_t i = n; i-- > 0;) {
    const double after = i + 1 < n ? system.next[i] * x[i + 1] : 0.0;
    x[i] = (system.right[i] - after) / system.diagonal[i];
  }
  return x;
}

}  // namespace setsquare
