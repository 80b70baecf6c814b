// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace setsquare {

/// A symmetric, positive definite, tridiagonal system A x = b of n unknowns: the normal equations
/// of a chain.
struct TridiagonalSystem {
  std::vector<double> diagonal;  ///< n entries of A.
  std::vector<double> next;      ///< n - 1 entries: A(i, i + 1) = A(i + 1, i).
  std::vector<double> right;     ///< n entries of b.

  /// All zero, for n unknowns.
  explicit TridiagonalSystem(std::size_t n);

  /// Adds the term  weight * (x_i - value)^2.
  void bind(std::size_t i, double value, double weight);
  /// Adds the term  weight * (x_(i+1) - x_i - value)^2.
  void bind_step(std::size_t i, double value, double weight);
};

/// The minimum of the sum of all terms, by an LDL^T elimination in O(n). Every chain of unknowns
/// must be bound somewhere: the matrix is positive definite.
[[nodiscard]] std::vector<double> solve(TridiagonalSystem system);

}  // namespace setsquare
