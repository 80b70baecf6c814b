// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/match_result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/LU>

namespace setsquare::match_result_test {

MatchResult result_with(const Eigen::Matrix3d& information) {
  MatchResult result;
  result.status = MatchStatus::kMatched;
  result.T_reference_current = Pose2{1.0, 2.0, 0.3};
  result.information = information;
  return result;
}

TEST(MarginalSigmas, AreTheRootsOfTheCovariancesDiagonal) {
  Eigen::Matrix3d information;
  information << 4e4, 1e4, 9e4,  //
      1e4, 2e4, -3e4,            //
      9e4, -3e4, 6e5;
  const auto sigmas = marginal_sigmas(result_with(information));
  ASSERT_TRUE(sigmas);
  const Eigen::Matrix3d covariance = information.inverse();
  EXPECT_NEAR(sigmas->x_m, std::sqrt(covariance(0, 0)), 1e-12);
  EXPECT_NEAR(sigmas->y_m, std::sqrt(covariance(1, 1)), 1e-12);
  EXPECT_NEAR(sigmas->theta_rad, std::sqrt(covariance(2, 2)), 1e-12);
  // Those with the other parts held fixed are smaller.
  EXPECT_GT(sigmas->theta_rad, 1.1 / std::sqrt(information(2, 2)));
}

TEST(MarginalSigmas, DoNotDependOnTheUnits) {
  const Eigen::Vector3d diagonal(1e-4, 1e12, 1e-8);
  const auto sigmas = marginal_sigmas(result_with(diagonal.asDiagonal()));
  ASSERT_TRUE(sigmas);
  EXPECT_DOUBLE_EQ(sigmas->x_m, 1e2);
  EXPECT_DOUBLE_EQ(sigmas->y_m, 1e-6);
  EXPECT_DOUBLE_EQ(sigmas->theta_rad, 1e4);
}

TEST(MarginalSigmas, NothingWhereADirectionIsOpen) {
  const Eigen::Vector3d across(-std::sin(0.4), std::cos(0.4), 0.0);
  Eigen::Matrix3d corridor = 1e4 * across * across.transpose();
  corridor(2, 2) = 1e5;
  EXPECT_FALSE(marginal_sigmas(result_with(corridor)));
  const Eigen::Vector3d round_hall(1e4, 1e4, 0.0);
  EXPECT_FALSE(marginal_sigmas(result_with(round_hall.asDiagonal())));
  EXPECT_FALSE(marginal_sigmas(MatchResult{}));
}

}  // namespace setsquare::match_result_test
