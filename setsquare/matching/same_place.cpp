// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/same_place.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/matching/distinct_wall.hpp"
#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

constexpr double kClose_m = 0.02;
constexpr float kAgreeing_m = 0.15F;
/// Keeps the logarithm of next to no wall near zero.
constexpr double kLittleClose_m = 0.5;

// The figures below are those that `match_probability fit-place` prints
// (benchmarks/match_probability): a logistic regression over 1408 answers that might stand, of
// simulated buildings. No real log had a part in them.

/// Weights of place_features in that order, and the constant.
constexpr PlaceFeatures kPlaceWeights{
    0.809727, 1.49719, -0.586263, 5.1391, -2.35652, -16.2251, -0.396763, 1.82335};
constexpr double kPlaceConstant = -3.92098;

/// Wall that agrees: where it lies, and how its directions differ.
struct AgreeingWall {
  double wall_m = 0.0;
  double sine_square_m = 0.0;
  Eigen::Vector2d sum_m2 = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square_sum_m3 = Eigen::Matrix2d::Zero();

  void add(double weight_m, double sine, const Eigen::Vector2d& p_m) {
    wall_m += weight_m;
    sine_square_m += weight_m * sine * sine;
    sum_m2 += weight_m * p_m;
    square_sum_m3 += weight_m * p_m * p_m.transpose();
  }
  [[nodiscard]] double normal_rms_rad() const {
    return wall_m > 0.0 ? std::sqrt(sine_square_m / wall_m) : 0.0;
  }
  [[nodiscard]] double narrow_spread_m() const {
    if (!(wall_m > 0.0)) return 0.0;
    const Eigen::Vector2d mean_m = sum_m2 / wall_m;
    const Eigen::Matrix2d covariance_m2 = square_sum_m3 / wall_m - mean_m * mean_m.transpose();
    return std::sqrt(std::max(0.0, symmetric_eigen(covariance_m2).values(0)));
  }
};

/// Adds the samples that lie on the image's surfaces, at their places in the frame that
/// `T_frame_image` has the image in.
void add_agreeing(const SurfaceImage& image,
                  const SurfaceSamples& samples,
                  const Pose2& T_image_samples,
                  const Pose2& T_frame_image,
                  AgreeingWall& wall) {
  compare_by_fours(image, samples, T_image_samples, [&](std::size_t first, const auto& compared) {
    const Ints agrees = (absolute(compared.distance_m) < spread(kAgreeing_m)) &
                        compared.has_normal() & compared.faces_alike();
    const auto& moved = compared.sample;
    const Floats sine =
        compared.sector.normal_x * moved.normal_y - compared.sector.normal_y * moved.normal_x;
    for (std::size_t lane = 0; lane < kLanes && first + lane < samples.size(); ++lane) {
      if (!agrees[lane]) continue;
      const Eigen::Vector2d p_m(moved.x_m[lane], moved.y_m[lane]);
      wall.add(samples.weight_m[first + lane], sine[lane], T_frame_image * p_m);
    }
  });
}

}  // namespace

PlaceEvidence place_evidence(const PreparedScan& reference,
                             const PreparedScan& current,
                             const Pose2& T_reference_current,
                             const ProbabilityEvidence& evidence) {
  const Pose2& T = T_reference_current;
  AgreeingWall wall;
  add_agreeing(reference.image(), current.fine, T, Pose2{}, wall);
  add_agreeing(current.image(), reference.fine, T.inverse(), T, wall);
  const WallKinds& kinds = evidence.kinds;
  return {
      .log_odds = calibrated_log_odds(log_odds_of(probability_features(evidence))),
      .ends = compare_wall_ends(reference, current, T),
      .close_distinct_m = distinct_wall_m(
          reference.fine_alignment(), current.fine_alignment(), T, {.max_distance_m = kClose_m}),
      .unexplained_share = kinds.wall_m > 0.0 ? kinds.unexplained_m / kinds.wall_m : 0.0,
      .normal_rms_rad = wall.normal_rms_rad(),
      .turning_m3 = evidence.constraint.turning_m3,
      .narrow_spread_m = wall.narrow_spread_m()};
}

PlaceFeatures place_features(const PlaceEvidence& evidence) {
  return {evidence.log_odds,
          std::log1p(static_cast<double>(evidence.ends.agreeing)),
          std::log1p(static_cast<double>(evidence.ends.missing)),
          std::log(evidence.close_distinct_m + kLittleClose_m),
          evidence.unexplained_share,
          evidence.normal_rms_rad,
          std::log1p(evidence.turning_m3),
          evidence.narrow_spread_m};
}

double place_log_odds(const PlaceEvidence& evidence) {
  const PlaceFeatures features = place_features(evidence);
  return std::inner_product(
      features.begin(), features.end(), kPlaceWeights.begin(), kPlaceConstant);
}

}  // namespace setsquare
