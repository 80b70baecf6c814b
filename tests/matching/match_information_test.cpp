// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <iostream>
#include <vector>

#include "setsquare/matching/information.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::match_information_test {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::uniform;

/// Symmetric and positive definite, of a few metres of wall.
Matrix3d random_normal(std::mt19937_64& generator) {
  Matrix3d sum = Matrix3d::Zero();
  for (int i = 0; i < 8; ++i) {
    const Vector3d j(
        uniform(generator, -1, 1), uniform(generator, -1, 1), uniform(generator, -5, 5));
    sum += uniform(generator, 0.1, 2.0) * j * j.transpose();
  }
  return sum;
}

Matrix3d turn(double angle_rad) {
  Matrix3d R = Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
  return R;
}

TEST(MatchInformation, OfEvenPiecesIsTheHessianOverTheirVariance) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3d hessian = random_normal(generator);
    const double variance_m3 = uniform(generator, 1e-4, 1e-2);
    const Matrix3d information =
        match_information({.hessian = hessian, .scatter = variance_m3 * hessian});
    // Up to the variance that is always added.
    const Matrix3d expected = hessian / (variance_m3 + 1e-5);
    EXPECT_LT((information - expected).norm(), 1e-6 * expected.norm());
  }
}

TEST(MatchInformation, IsTheSandwich) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const MatchNormal normal{.hessian = random_normal(generator),
                             .scatter = random_normal(generator)};
    const Matrix3d expected = normal.hessian * normal.scatter.inverse() * normal.hessian;
    EXPECT_LT((match_information(normal) - expected).norm(), 1e-3 * expected.norm());
  }
}

TEST(MatchInformation, TurnsWithTheFrame) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const MatchNormal normal{.hessian = random_normal(generator),
                             .scatter = 1e-3 * random_normal(generator)};
    const Matrix3d R = turn(uniform(generator, -kPi, kPi));
    const Matrix3d before = match_information(normal);
    const Matrix3d after = match_information({.hessian = R * normal.hessian * R.transpose(),
                                              .scatter = R * normal.scatter * R.transpose()});
    EXPECT_LT((after - R * before * R.transpose()).norm(), 1e-6 * before.norm());
  }
}

TEST(MatchInformation, FallsAsTheScatterGrows) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    MatchNormal normal{.hessian = random_normal(generator),
                       .scatter = 1e-3 * random_normal(generator)};
    const Matrix3d before = match_information(normal);
    normal.scatter += 1e-3 * random_normal(generator);
    const Matrix3d lost = before - match_information(normal);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(lost);
    EXPECT_GT(solver.eigenvalues()(0), -1e-9 * before.norm());
    EXPECT_GT(solver.eigenvalues()(2), 0.0);
  }
}

TEST(MatchInformation, IsNothingAlongACorridorWhateverPullsThere) {
  for (const double along_rad : {0.0, 0.4, -2.0}) {
    const Vector3d along = turn(along_rad) * Vector3d::UnitX();
    const Vector3d across = turn(along_rad) * Vector3d::UnitY();
    const Matrix3d hessian = 8.0 * across * across.transpose() +
                             60.0 * Vector3d::UnitZ() * Vector3d::UnitZ().transpose();
    const Matrix3d scatter = 1e-3 * hessian + 0.5 * along * along.transpose();
    const Matrix3d information = match_information({.hessian = hessian, .scatter = scatter});
    ASSERT_TRUE(information.allFinite());
    EXPECT_LT((information * along).norm(), 1e-6 * information.norm());
    EXPECT_NEAR(across.dot(information * across), 8.0 / 1.01e-3, 1.0);
  }
  EXPECT_EQ(match_information({}).norm(), 0.0);
}

TEST(WithoutDirection, IsSingularThereAndAsItWasAcross) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3d information = random_normal(generator);
    const Vector3d free = Vector3d(uniform(generator, -1, 1), uniform(generator, -1, 1), 0.3);
    const Matrix3d rest = without_direction(information, free);
    EXPECT_LT((rest * free).norm(), 1e-9 * information.norm());
    // What is left is that of all poses that `free` joins: the least of the quadratic form.
    const Vector3d any(uniform(generator, -1, 1), uniform(generator, -1, 1), 0.1);
    const double along = -free.dot(information * any) / free.dot(information * free);
    const Vector3d least = any + along * free;
    EXPECT_NEAR(any.dot(rest * any), least.dot(information * least), 1e-9 * information.norm());
  }
  EXPECT_EQ(without_direction(Matrix3d::Zero(), Vector3d::UnitX()).norm(), 0.0);
}

/// Errors of matched pairs, as the information sees them.
struct Claims {
  std::vector<double> nees;  ///< Error' information error: 3 on average where it is right.

  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double value : nees) sum += value;
    return sum / static_cast<double>(nees.size());
  }
  [[nodiscard]] double share_below(double bound) const {
    const auto num = std::count_if(nees.begin(), nees.end(), [&](double n) { return n < bound; });
    return static_cast<double>(num) / static_cast<double>(nees.size());
  }
};

/// Pairs 0.8 m apart in a building without people, by a robot that all but stands.
void add_claims(BuildingClass building_class, std::uint64_t seed, Claims& claims) {
  const Building building = make_building(building_class, seed);
  const RayCaster caster(building.plan);
  constexpr RobotSpeed kCreeping{.drive_m_per_s = 1e-3, .turn_rad_per_s = 1e-3};
  const RobotPath path(building.route_m, kCreeping);
  Random random(sub_seed(seed, 77));
  constexpr int kNumPairs = 6;
  for (int i = 0; i < kNumPairs; ++i) {
    const double start_m = random.uniform(0.0, path.length_m() - 1.0);
    const auto look = [&](double distance_m) {
      const double time_s = path.time_at_route_distance(distance_m);
      return simulate_scan(caster, {}, utm_30lx(), path, time_s, random);
    };
    const SimulatedScan reference = look(start_m);
    const SimulatedScan current = look(start_m + 0.8);
    const MatchResult result = match(reference.scan, current.scan);
    if (result.status != MatchStatus::kMatched) continue;
    const Pose2 truth = reference.T_map_base.inverse() * current.T_map_base;
    const Pose2& found = *result.T_reference_current;
    const Vector3d error(found.x_m - truth.x_m,
                         found.y_m - truth.y_m,
                         wrap_to_pi(found.theta_rad - truth.theta_rad));
    claims.nees.push_back(error.dot(result.information * error));
  }
}

TEST(MatchInformation, PromisesWhatIsKeptWhereTheRobotStands) {
  Claims claims;
  constexpr std::uint64_t kNumSeeds = 12;
  for (const BuildingClass building_class : kAllBuildingClasses) {
    for (std::uint64_t seed = 0; seed < kNumSeeds; ++seed) {
      add_claims(building_class, sub_seed(testing::test_seed(), seed), claims);
    }
  }
  std::cout << claims.nees.size() << " matched, mean NEES " << claims.mean() << ", "
            << 100.0 * claims.share_below(7.81) << " % below 7.81\n";
  ASSERT_GT(claims.nees.size(), 200U);
  EXPECT_GT(claims.mean(), 1.2);
  EXPECT_LT(claims.mean(), 5.0);
  EXPECT_GE(claims.share_below(7.81), 0.90);  // The 95 % point of three degrees of freedom.
}

}  // namespace setsquare::match_information_test
