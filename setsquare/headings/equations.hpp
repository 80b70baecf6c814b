// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from fusion, its only caller, because tests compare it with dense solvers.
#pragma once

#include <cstddef>
#include <Eigen/Cholesky>
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

/// The drifts of a chain of keyframes and the offsets of the building's frames.
struct HeadingSolution {
  std::vector<double> drift_rad;  ///< One per keyframe.
  Eigen::VectorXd offset_rad;     ///< One per frame other than the main one.
};

/// Their variances, in rad^2.
struct HeadingVariances {
  std::vector<double> drift_rad2;
  Eigen::VectorXd offset_rad2;
};

/// Normal equations of drifts d_k along a chain and of the offsets o_f of frames f = 1, 2, ...
/// against the main frame 0, whose offset is 0 by definition: tridiagonal in the drifts, bordered
/// by one dense column per frame. Solved exactly by the Schur complement of the drifts.
class HeadingEquations {
 public:
  HeadingEquations(std::size_t num_keyframes, std::size_t num_frames);

  /// Adds the term  weight * (d_k + o_frame - value_rad)^2.
  void bind(std::size_t k, std::size_t frame, double value_rad, double weight);
  /// Adds the term  weight * (d_(k+1) - d_k)^2.
  void bind_step(std::size_t k, double weight) { chain_.bind_step(k, 0.0, weight); }
  /// Adds the term  weight * (o_frame - value_rad)^2; not for the main frame.
  void bind_offset(std::size_t frame, double value_rad, double weight);

  /// The minimum of the sum of all terms. The drifts must be bound somewhere, and every offset.
  [[nodiscard]] HeadingSolution solve() const;
  /// Of the solution: the diagonal of the inverse.
  [[nodiscard]] HeadingVariances variances() const;

 private:
  /// The drifts eliminated.
  struct Schur {
    TridiagonalFactor chain;
    std::vector<std::vector<double>> columns;  ///< Inverse of the chain times its border.
    Eigen::LDLT<Eigen::MatrixXd> offsets;
  };
  [[nodiscard]] Schur eliminate() const;

  TridiagonalSystem chain_;
  std::vector<std::vector<double>> border_;  ///< One column per frame other than the main one.
  Eigen::VectorXd offset_diagonal_;
  Eigen::VectorXd offset_right_;
};

}  // namespace setsquare
