// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of small symmetric matrices, compiled once: Eigen's solver costs every source that
// includes it many seconds.
#pragma once

#include <Eigen/Core>

namespace setsquare {

/// Eigenvalues in ascending order, and their unit eigenvectors as columns.
template <int kSize>
struct SymmetricEigen {
  Eigen::Matrix<double, kSize, 1> values;
  Eigen::Matrix<double, kSize, kSize> vectors;
};

/// By iteration: exact for matrices of any scale. Reads the lower triangle.
[[nodiscard]] SymmetricEigen<2> symmetric_eigen(const Eigen::Matrix2d& matrix);
[[nodiscard]] SymmetricEigen<3> symmetric_eigen(const Eigen::Matrix3d& matrix);

/// In closed form: a third of the time, and less exact where the eigenvalues are alike.
[[nodiscard]] SymmetricEigen<2> symmetric_eigen_direct(const Eigen::Matrix2d& matrix);

/// The eigenvalues alone, ascending; by iteration.
[[nodiscard]] Eigen::Vector2d symmetric_eigenvalues(const Eigen::Matrix2d& matrix);
[[nodiscard]] Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix);

}  // namespace setsquare
