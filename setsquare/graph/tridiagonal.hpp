// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

/// L D L^T of a tridiagonal matrix, in O(n); then any number of right sides in O(n) each. Every
/// chain of unknowns must be bound somewhere: the matrix is positive definite.
class TridiagonalFactor {
 public:
  explicit TridiagonalFactor(const TridiagonalSystem& system);

  [[nodiscard]] std::vector<double> solve(std::vector<double> right) const;

  /// The n diagonal entries of the inverse: the unknowns' variances, in O(n).
  [[nodiscard]] std::vector<double> inverse_diagonal() const;

 private:
  std::vector<double> pivot_;     ///< Of the elimination from the first unknown on: D.
  std::vector<double> diagonal_;  ///< Of the matrix.
  std::vector<double> next_;      ///< Of the matrix.
};

/// The minimum of the sum of all terms.
[[nodiscard]] std::vector<double> solve(const TridiagonalSystem& system);

}  // namespace setsquare
