// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <Eigen/Dense>

#include "setsquare/headings/equations.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_equations_test {

using testing::make_generator;
using testing::uniform;

/// The same terms in one dense system: drifts first, then offsets.
struct DenseTwin {
  DenseTwin(std::size_t num_keyframes, std::size_t num_frames)
      : first_offset(static_cast<Eigen::Index>(num_keyframes)),
        size(first_offset + static_cast<Eigen::Index>(num_frames) - 1),
        hessian(Eigen::MatrixXd::Zero(size, size)),
        right(Eigen::VectorXd::Zero(size)) {}

  Eigen::VectorXd drift(std::size_t k) const {
    return Eigen::VectorXd::Unit(size, static_cast<Eigen::Index>(k));
  }
  Eigen::VectorXd offset(std::size_t frame) const {
    if (frame == 0) return Eigen::VectorXd::Zero(size);
    return Eigen::VectorXd::Unit(size, first_offset + static_cast<Eigen::Index>(frame) - 1);
  }
  void add(const Eigen::VectorXd& row, double value, double weight) {
    hessian += weight * row * row.transpose();
    right += weight * value * row;
  }

  Eigen::Index first_offset;
  Eigen::Index size;
  Eigen::MatrixXd hessian;
  Eigen::VectorXd right;
};

class HeadingEquationsTest : public ::testing::TestWithParam<std::size_t> {};

TEST_P(HeadingEquationsTest, SolutionAndVariancesEqualTheDenseOnes) {
  const std::size_t num_frames = GetParam();
  auto generator = make_generator();
  for (const std::size_t n : {1U, 2U, 30U}) {
    HeadingEquations equations(n, num_frames);
    DenseTwin twin(n, num_frames);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t frame = 0; frame < num_frames; ++frame) {
        const double value_rad = uniform(generator, -3.0, 3.0);
        const double weight = uniform(generator, 0.1, 2.0);
        equations.bind(k, frame, value_rad, weight);
        twin.add(twin.drift(k) + twin.offset(frame), value_rad, weight);
      }
      if (k + 1 == n) continue;
      const double weight = uniform(generator, 0.0, 100.0);
      equations.bind_step(k, weight);
      twin.add(twin.drift(k + 1) - twin.drift(k), 0.0, weight);
    }
    for (std::size_t frame = 1; frame < num_frames; ++frame) {
      equations.bind_offset(frame, 0.5, 0.3);
      twin.add(twin.offset(frame), 0.5, 0.3);
    }
    const HeadingSolution solution = equations.solve();
    const HeadingVariances variances = equations.variances();
    const Eigen::VectorXd expected = twin.hessian.ldlt().solve(twin.right);
    const Eigen::VectorXd expected_variance = twin.hessian.inverse().diagonal();
    for (std::size_t k = 0; k < n; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(solution.drift_rad[k], expected(i), 1e-10) << k << " of " << n;
      EXPECT_NEAR(variances.drift_rad2[k], expected_variance(i), 1e-10) << k << " of " << n;
    }
    for (std::size_t frame = 1; frame < num_frames; ++frame) {
      const auto f = static_cast<Eigen::Index>(frame) - 1;
      EXPECT_NEAR(solution.offset_rad(f), expected(twin.first_offset + f), 1e-10);
      EXPECT_NEAR(variances.offset_rad2(f), expected_variance(twin.first_offset + f), 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Frames, HeadingEquationsTest, ::testing::Values(1U, 2U, 4U));

}  // namespace setsquare::heading_equations_test
