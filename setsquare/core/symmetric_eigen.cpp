// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace setsquare {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>;

SymmetricEigen2 symmetric_eigen(const Eigen::Matrix2d& matrix) {
  const Solver solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigen2 symmetric_eigen_direct(const Eigen::Matrix2d& matrix) {
  Solver solver;
  solver.computeDirect(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Vector2d symmetric_eigenvalues(const Eigen::Matrix2d& matrix) {
  return Solver(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace setsquare
