// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::alignment_test {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::uniform;

/// One sample against one scan, in double precision and plain code.
struct PlainSample {
  Evidence evidence;
  double weight = 0.0;      ///< Of the residual: length of wall by Tukey's biweight and by facing.
  double residual_m = 0.0;  ///< Distance from the surface, where it is near.
  SurfaceSector sector;
};

PlainSample judge_sample(const SurfaceImage& image,
                         const SurfaceSamples& samples,
                         std::size_t i,
                         const Pose2& T_a_b,
                         double tolerance_m) {
  const Eigen::Vector2d q = T_a_b * Eigen::Vector2d(samples.x_m[i], samples.y_m[i]);
  const Eigen::Vector2d normal =
      Pose2{0.0, 0.0, T_a_b.theta_rad} * Eigen::Vector2d(samples.normal_x[i], samples.normal_y[i]);
  PlainSample plain;
  plain.sector = image.at(static_cast<float>(q.x()), static_cast<float>(q.y()));
  const SurfaceSector& sector = plain.sector;
  const double wall_m = samples.weight_m[i];
  plain.evidence.wall_m = wall_m;
  const bool is_unseen = sector.offset_m == SurfaceImage::kNoSurface_m;
  const double distance_m = sector.normal_x * q.x() + sector.normal_y * q.y() - sector.offset_m;
  if (!is_unseen && std::abs(distance_m) < tolerance_m) {
    const double nearness = 1.0 - std::pow(distance_m / tolerance_m, 2);
    const double cosine = sector.normal_x * normal.x() + sector.normal_y * normal.y();
    const double facing = normal.norm() < 0.5 ? 0.3 : cosine > 0.7 ? 1.0 : 0.0;
    plain.evidence.agreeing_m = wall_m * facing * nearness;
    plain.weight = wall_m * facing * nearness * nearness;
    plain.residual_m = distance_m;
  } else if (!is_unseen && distance_m < 0.0) {
    plain.evidence.hidden_m = wall_m;
  } else if (q.squaredNorm() < sector.free_square_m2) {
    plain.evidence.contradicted_m = wall_m;
  } else if (is_unseen) {
    plain.evidence.outside_m = wall_m;
  }
  return plain;
}

/// The residual of a sample whose sector is frozen.
double residual_m(const SurfaceSector& sector,
                  const SurfaceSamples& samples,
                  std::size_t i,
                  const Pose2& T_a_b) {
  const Eigen::Vector2d q = T_a_b * Eigen::Vector2d(samples.x_m[i], samples.y_m[i]);
  return sector.normal_x * q.x() + sector.normal_y * q.y() - sector.offset_m;
}

Pose2 moved(const Pose2& T, int component, double step) {
  return {T.x_m + (component == 0 ? step : 0.0),
          T.y_m + (component == 1 ? step : 0.0),
          T.theta_rad + (component == 2 ? step : 0.0)};
}

/// The plain sum over the samples: derivatives by finite differences of the residuals with the
/// weights and sectors frozen. `is_backward`: T maps the samples' frame into the image's as the
/// inverse of the pose that is varied.
Alignment plain_one_way(const SurfaceImage& image,
                        const SurfaceSamples& samples,
                        const Pose2& T_reference_current,
                        bool is_backward,
                        double tolerance_m) {
  const auto T_a_b = [&](const Pose2& T) { return is_backward ? T.inverse() : T; };
  Alignment sum;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PlainSample plain =
        judge_sample(image, samples, i, T_a_b(T_reference_current), tolerance_m);
    sum.evidence += plain.evidence;
    if (plain.weight == 0.0) continue;
    Vector3d derivative;
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-6;
      derivative(k) =
          (residual_m(plain.sector, samples, i, T_a_b(moved(T_reference_current, k, kStep))) -
           residual_m(plain.sector, samples, i, T_a_b(moved(T_reference_current, k, -kStep)))) /
          (2.0 * kStep);
    }
    sum.hessian += plain.weight * derivative * derivative.transpose();
    sum.gradient += plain.weight * plain.residual_m * derivative;
  }
  return sum;
}

/// Sums of floats; and a sample on the very border of a sector may be judged by either.
void expect_near(const Alignment& lanes, const Alignment& plain) {
  const double scale = plain.evidence.wall_m;
  const double tolerance_m = 2e-3 * scale;
  EXPECT_NEAR(lanes.evidence.wall_m, plain.evidence.wall_m, 1e-5 * scale);
  EXPECT_NEAR(lanes.evidence.agreeing_m, plain.evidence.agreeing_m, tolerance_m);
  EXPECT_NEAR(lanes.evidence.contradicted_m, plain.evidence.contradicted_m, tolerance_m);
  EXPECT_NEAR(lanes.evidence.hidden_m, plain.evidence.hidden_m, tolerance_m);
  EXPECT_NEAR(lanes.evidence.outside_m, plain.evidence.outside_m, tolerance_m);
  constexpr double kLever_m = 6.0;
  const Vector3d unit(1.0, 1.0, kLever_m);
  for (int row = 0; row < 3; ++row) {
    EXPECT_NEAR(lanes.gradient(row), plain.gradient(row), 0.2 * tolerance_m * unit(row));
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(lanes.hessian(row, column),
                  plain.hessian(row, column),
                  tolerance_m * unit(row) * unit(column));
    }
  }
}

struct Pair {
  PreparedScan reference;
  PreparedScan current;
  Pose2 T_reference_current;
};

/// Two scans of one room, and a pose some centimetres and degrees off the truth.
Pair random_pair(std::mt19937_64& generator) {
  const auto room = testing::furnished_room(generator);
  const Pose2 T_world_reference = testing::free_pose(room, generator);
  const Pose2 T_world_current = testing::free_pose(room, generator);
  const testing::Fan reference_fan{361, rad_from_deg(-90), rad_from_deg(0.5)};
  const testing::Fan current_fan{720, kPi, rad_from_deg(-0.5)};
  const auto scan = [&](const Pose2& T, const testing::Fan& fan) {
    return prepare(testing::scan_of_walls(room.walls, T, fan, 0.01, generator(), 0.05));
  };
  const Pose2 beside{uniform(generator, -0.1, 0.1),
                     uniform(generator, -0.1, 0.1),
                     uniform(generator, -0.05, 0.05)};
  return {scan(T_world_reference, reference_fan),
          scan(T_world_current, current_fan),
          T_world_reference.inverse() * T_world_current * beside};
}

TEST(Alignment, OneWayEqualsItsPlainTwin) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    SCOPED_TRACE(trial);
    const Pair pair = random_pair(generator);
    for (const double tolerance_m : {0.1, 0.2, 0.5}) {
      expect_near(
          align_one_way(
              pair.reference.image(), pair.current.fine, pair.T_reference_current, tolerance_m),
          plain_one_way(pair.reference.image(),
                        pair.current.fine,
                        pair.T_reference_current,
                        false,
                        tolerance_m));
    }
  }
}

TEST(Alignment, BothWaysEqualTheirPlainTwins) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 50; ++trial) {
    SCOPED_TRACE(trial);
    const Pair pair = random_pair(generator);
    constexpr double kTolerance_m = 0.2;
    Alignment plain = plain_one_way(
        pair.reference.image(), pair.current.fine, pair.T_reference_current, false, kTolerance_m);
    const Alignment backward = plain_one_way(
        pair.current.image(), pair.reference.fine, pair.T_reference_current, true, kTolerance_m);
    plain.evidence += backward.evidence;
    plain.hessian += backward.hessian;
    plain.gradient += backward.gradient;
    expect_near(align(pair.reference.fine_alignment(),
                      pair.current.fine_alignment(),
                      pair.T_reference_current,
                      kTolerance_m),
                plain);
  }
}

TEST(Alignment, EvidenceIsTheSameSeenFromTheOtherScan) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const Pair pair = random_pair(generator);
    const auto forth = align(pair.reference.fine_alignment(),
                             pair.current.fine_alignment(),
                             pair.T_reference_current,
                             0.2);
    const auto back = align(pair.current.fine_alignment(),
                            pair.reference.fine_alignment(),
                            pair.T_reference_current.inverse(),
                            0.2);
    EXPECT_NEAR(forth.evidence.wall_m, back.evidence.wall_m, 1e-4);
    EXPECT_NEAR(forth.evidence.agreeing_m, back.evidence.agreeing_m, 1e-2);
    EXPECT_NEAR(forth.evidence.contradicted_m, back.evidence.contradicted_m, 0.1);
    EXPECT_NEAR(forth.evidence.hidden_m, back.evidence.hidden_m, 0.1);
  }
}

TEST(Alignment, SharesAreSharesAtAnyPose) {
  auto generator = testing::make_generator();
  const Pair pair = random_pair(generator);
  for (int trial = 0; trial < 500; ++trial) {
    const Pose2 T{uniform(generator, -9, 9), uniform(generator, -9, 9), uniform(generator, -4, 4)};
    const Alignment result =
        align(pair.reference.fine_alignment(), pair.current.fine_alignment(), T, 0.2);
    const Evidence& seen = result.evidence;
    for (const double part :
         {seen.agreeing_m, seen.contradicted_m, seen.hidden_m, seen.outside_m}) {
      EXPECT_GE(part, 0.0);
    }
    EXPECT_LE(seen.agreeing_m + seen.contradicted_m + seen.hidden_m + seen.outside_m,
              seen.wall_m * (1.0 + 1e-5));
    EXPECT_TRUE(result.hessian.allFinite());
    EXPECT_TRUE(result.gradient.allFinite());
  }
}

}  // namespace setsquare::alignment_test
