// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>

#include "tests/support/seed.hpp"

namespace setsquare::symmetric_eigen_test {

/// Of any scale; now and then diagonal, singular or a multiple of the identity.
Eigen::Matrix2d random_symmetric(std::mt19937_64& generator) {
  const auto scale = [&] { return std::pow(10.0, testing::uniform(generator, -12.0, 12.0)); };
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  matrix(0, 0) = scale() * testing::uniform(generator, -1.0, 1.0);
  matrix(1, 1) = scale() * testing::uniform(generator, -1.0, 1.0);
  const double kind = testing::uniform(generator, 0.0, 1.0);
  if (kind < 0.1) return matrix;
  if (kind < 0.2) return Eigen::Matrix2d::Identity() * matrix(0, 0);
  if (kind < 0.3) matrix(0, 0) = 0.0;
  matrix(0, 1) = matrix(1, 0) = scale() * testing::uniform(generator, -1.0, 1.0);
  return matrix;
}

TEST(SymmetricEigen, OfTwoRowsIsThatOfEigen) {
  std::mt19937_64 generator = testing::make_generator();
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Matrix2d matrix = random_symmetric(generator);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> expected(matrix);
    const SymmetricEigen<2> eigen = symmetric_eigen(matrix);
    // To the last bit: maps stay as they were.
    ASSERT_TRUE(eigen.values == expected.eigenvalues()) << matrix;
    ASSERT_TRUE(eigen.vectors == expected.eigenvectors()) << matrix;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> values(matrix, Eigen::EigenvaluesOnly);
    ASSERT_TRUE(symmetric_eigenvalues(matrix) == values.eigenvalues()) << matrix;
  }
}

TEST(SymmetricEigen, OfZeroIsZero) {
  const Eigen::Matrix2d zero = Eigen::Matrix2d::Zero();
  const SymmetricEigen<2> eigen = symmetric_eigen(zero);
  EXPECT_TRUE(eigen.values == Eigen::Vector2d::Zero());
  EXPECT_TRUE(eigen.vectors == Eigen::Matrix2d::Identity());
}

}  // namespace setsquare::symmetric_eigen_test
