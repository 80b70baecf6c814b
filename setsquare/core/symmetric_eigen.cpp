// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace setsquare {
namespace {

template <typename Matrix>
using Solver = Eigen::SelfAdjointEigenSolver<Matrix>;

template <typename Matrix>
SymmetricEigen<Matrix::RowsAtCompileTime> solution(const Solver<Matrix>& solver) {
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

SymmetricEigen<2> symmetric_eigen(const Eigen::Matrix2d& matrix) {
  return solution(Solver<Eigen::Matrix2d>(matrix));
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
  return Solver<Eigen::Matrix2d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix) {
  return Solver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace setsquare
