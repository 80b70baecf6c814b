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

TridiagonalFactor::TridiagonalFactor(const TridiagonalSystem& system)
    : pivot_(system.diagonal), diagonal_(system.diagonal), next_(system.next) {
  for (std::size_t i = 1; i < pivot_.size(); ++i) {
    assert(pivot_[i - 1] > 0.0);
    pivot_[i] -= next_[i - 1] * next_[i - 1] / pivot_[i - 1];
  }
}

std::vector<double> TridiagonalFactor::solve(std::vector<double> right) const {
  const std::size_t n = pivot_.size();
  assert(right.size() == n);
  for (std::size_t i = 1; i < n; ++i) right[i] -= next_[i - 1] / pivot_[i - 1] * right[i - 1];
  for (std::size_t i = n; i-- > 0;) {
    const double after = i + 1 < n ? next_[i] * right[i + 1] : 0.0;
    right[i] = (right[i] - after) / pivot_[i];
  }
  return right;
}

std::vector<double> TridiagonalFactor::inverse_diagonal() const {
  const std::size_t n = pivot_.size();
  std::vector<double> variance(n);
  // What eliminating all unknowns before i, and all after it, leaves of its diagonal entry.
  double from_behind = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    const double taken_by_later = i + 1 < n ? next_[i] * next_[i] / from_behind : 0.0;
    from_behind = diagonal_[i] - taken_by_later;
    variance[i] = 1.0 / (pivot_[i] - taken_by_later);
  }
  return variance;
}

std::vector<double> solve(const TridiagonalSystem& system) {
  return TridiagonalFactor(system).solve(system.right);
}

}  // namespace setsquare
