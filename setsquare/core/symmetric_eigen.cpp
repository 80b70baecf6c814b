// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

namespace setsquare {
namespace {

template <typename Matrix>
using Solver = Eigen::SelfAdjointEigenSolver<Matrix>;

template <typename Matrix>
SymmetricEigen<Matrix::RowsAtCompileTime> solution(const Solver<Matrix>& solver) {
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// With the eigenvalues of `matrix` / scale. As Eigen's compute(), which costs the build 13 s for
/// two rows: it makes the matrix tridiagonal first, as two rows already are.
struct ScaledSolver {
  ScaledSolver(const Eigen::Matrix2d& matrix, int options)
      : scale(std::max({std::abs(matrix(0, 0)), std::abs(matrix(1, 0)), std::abs(matrix(1, 1))})) {
    if (scale == 0.0) scale = 1.0;
    const Eigen::Vector2d diagonal = matrix.diagonal() / scale;
    const Eigen::Matrix<double, 1, 1> below(matrix(1, 0) / scale);
    solver.computeFromTridiagonal(diagonal, below, options);
  }
  [[nodiscard]] Eigen::Vector2d eigenvalues() const { return solver.eigenvalues() * scale; }
  double scale;
  Solver<Eigen::Matrix2d> solver;
};

}  // namespace

SymmetricEigen<2> symmetric_eigen(const Eigen::Matrix2d& matrix) {
  const ScaledSolver scaled(matrix, Eigen::ComputeEigenvectors);
  return {scaled.eigenvalues(), scaled.solver.eigenvectors()};
}

SymmetricEigen<3> symmetric_eigen(const Eigen::Matrix3d& matrix) {
  return solution(Solver<Eigen::Matrix3d>(matrix));
}

SymmetricEigen<2> symmetric_eigen_direct(const Eigen::Matrix2d& matrix) {
  Solver<Eigen::Matrix2d> solver;
  solver.computeDirect(matrix);
  return solution(solver);
}

Eigen::Vector2d symmetric_eigenvalues(const Eigen::Matrix2d& matrix) {
  return ScaledSolver(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix) {
  return Solver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace setsquare
