// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/distinct_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <Eigen/Geometry>
#include <vector>

#include "setsquare/matching/angle_histogram.hpp"

namespace setsquare {
namespace {

constexpr float kMaxDistance_m = 0.15F;
constexpr float kMinNormalCosine = 0.7F;
constexpr float kMaxLine_m = 0.5F;
/// Lines are told apart by direction and by offset from the reference's origin, clutter by place.
constexpr int kNumDirections = 20;
constexpr float kOffsetStep_m = 0.4F;
constexpr float kPlaceStep_m = 0.5F;
constexpr int kTableSide = 256;  // Offsets and places farther than 50 m share entries.

int table_index(float coordinate_m, float step_m) {
  return static_cast<int>(std::floor(coordinate_m / step_m)) & (kTableSide - 1);
}

/// Agreeing length, a line or a place each.
class LineLengths {
 public:
  LineLengths() : lengths_m_(static_cast<std::size_t>(kNumDirections + 1) * kTableSide) {
    for (int direction = 0; direction < kNumDirections; ++direction) {
      const double angle_rad = (direction + 0.5) * kTwoPi / kNumDirections - kPi;
      facing_[direction] = Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)).cast<float>();
    }
  }

  void add(const Eigen::Vector2f& p_m, const Eigen::Vector2f& normal, float length_m) {
    if (normal.isZero(0.0F)) {
      const int place = table_index(p_m.x(), kPlaceStep_m) ^ table_index(p_m.y(), kPlaceStep_m)
                                                                 << 4;
      lengths_m_[kNumDirections * kTableSide + (place & (kTableSide - 1))] += length_m;
      return;
    }
    static_assert(AngleHistogram::kNumBins % kNumDirections == 0);
    constexpr int kBinsPerDirection = AngleHistogram::kNumBins / kNumDirections;
    const int direction = AngleHistogram::bin_of(normal.x(), normal.y()) / kBinsPerDirection;
    const float offset_m = facing_[direction].dot(p_m);
    lengths_m_[direction * kTableSide + table_index(offset_m, kOffsetStep_m)] += length_m;
  }

  [[nodiscard]] double capped_sum_m() const {
    double sum_m = 0.0;
    for (const float length_m : lengths_m_) sum_m += std::min(length_m, kMaxLine_m);
    return sum_m;
  }

 private:
  std::array<Eigen::Vector2f, kNumDirections> facing_;
  std::vector<float> lengths_m_;  ///< A row of offsets a direction, and one of places.
};

/// Adds the samples of frame b that lie on the surfaces of frame a; the lines' frame is r.
void add_agreeing(const SurfaceImage& image_a,
                  const SurfaceSamples& samples_b,
                  const Pose2& T_a_b,
                  const Pose2& T_r_b,
                  LineLengths& lines) {
  const Eigen::Matrix2f R_a_b =
      Eigen::Rotation2Dd(T_a_b.theta_rad).cast<float>().toRotationMatrix();
  const Eigen::Matrix2f R_r_b =
      Eigen::Rotation2Dd(T_r_b.theta_rad).cast<float>().toRotationMatrix();
  const Eigen::Vector2f t_a_b = T_a_b.translation().cast<float>();
  const Eigen::Vector2f t_r_b = T_r_b.translation().cast<float>();
  for (std::size_t i = 0; i < samples_b.size(); ++i) {
    const Eigen::Vector2f p_b(samples_b.x_m[i], samples_b.y_m[i]);
    const Eigen::Vector2f p_a = R_a_b * p_b + t_a_b;
    const SurfaceSector& sector = image_a.at(p_a.x(), p_a.y());
    const float distance_m = SurfaceImage::signed_distance_m(sector, p_a.x(), p_a.y());
    if (!(std::abs(distance_m) < kMaxDistance_m)) continue;
    const Eigen::Vector2f normal_b(samples_b.normal_x[i], samples_b.normal_y[i]);
    const float cosine = (R_a_b * normal_b).dot(Eigen::Vector2f(sector.normal_x, sector.normal_y));
    if (!normal_b.isZero(0.0F) && cosine < kMinNormalCosine) continue;
    lines.add(R_r_b * p_b + t_r_b, R_r_b * normal_b, samples_b.weight_m[i]);
  }
}

}  // namespace

double distinct_wall_m(const AlignedScan& reference,
                       const AlignedScan& current,
                       const Pose2& T_reference_current) {
  LineLengths lines;
  add_agreeing(reference.image, current.samples, T_reference_current, T_reference_current, lines);
  add_agreeing(current.image, reference.samples, T_reference_current.inverse(), {}, lines);
  return lines.capped_sum_m();
}

}  // namespace setsquare
