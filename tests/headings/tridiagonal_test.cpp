// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <Eigen/Dense>
#include <vector>

#include "setsquare/headings/equations.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::tridiagonal_test {

using testing::make_generator;
using testing::uniform;

/// The same terms as rows of a dense least-squares problem.
struct DenseTwin {
  explicit DenseTwin(std::size_t num_unknowns)
      : hessian(Eigen::MatrixXd::Zero(num_unknowns, num_unknowns)),
        right(Eigen::VectorXd::Zero(num_unknowns)) {}
  void add(const Eigen::VectorXd& row, double value, double weight) {
    hessian += weight * row * row.transpose();
    right += weight * value * row;
  }
  Eigen::MatrixXd hessian;
  Eigen::VectorXd right;
};

TEST(Tridiagonal, EqualsTheDenseSolution) {
  auto generator = make_generator();
  for (const std::size_t n : {1U, 2U, 3U, 40U}) {
    TridiagonalSystem system(n);
    DenseTwin twin(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double value = uniform(generator, -3.0, 3.0);
      const double weight = uniform(generator, 0.1, 2.0);
      system.bind(i, value, weight);
      twin.add(Eigen::VectorXd::Unit(n, i), value, weight);
      if (i + 1 == n) continue;
      const double step = uniform(generator, -1.0, 1.0);
      const double step_weight = uniform(generator, 0.0, 100.0);
      system.bind_step(i, step, step_weight);
      twin.add(Eigen::VectorXd::Unit(n, i + 1) - Eigen::VectorXd::Unit(n, i), step, step_weight);
    }
    const std::vector<double> x = solve(system);
    const Eigen::VectorXd expected = twin.hessian.ldlt().solve(twin.right);
    const std::vector<double> variance = TridiagonalFactor(system).inverse_diagonal();
    const Eigen::VectorXd expected_variance = twin.hessian.inverse().diagonal();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(x[i], expected(i), 1e-10) << i << " of " << n;
      EXPECT_NEAR(variance[i], expected_variance(i), 1e-10) << i << " of " << n;
    }
  }
}

TEST(Tridiagonal, OneBoundEndCarriesTheWholeChain) {
  TridiagonalSystem system(5);
  system.bind(0, 2.0, 1e-3);
  for (std::size_t i = 0; i < 4; ++i) system.bind_step(i, 0.5, 1e6);
  const std::vector<double> x = solve(system);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(x[i], 2.0 + 0.5 * static_cast<double>(i), 1e-5);
  }
}

TEST(Tridiagonal, NoUnknownsNoSolution) { EXPECT_TRUE(solve(TridiagonalSystem(0)).empty()); }

}  // namespace setsquare::tridiagonal_test
