// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/distinct_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <Eigen/Geometry>
#include <vector>

namespace setsquare {
namespace {

constexpr float kMaxDistance_m = 0.15F;
/// Samples lie on one line whose normals are so alike and that are so near to it; clutter is one
/// thing where it is that near together.
constexpr float kSameLineCosine = 0.97F;
constexpr float kSameLine_m = 0.25F;
constexpr float kSameThing_m = 0.4F;
constexpr float kMaxLine_m = 0.5F;

/// A line, or a piece of clutter (normal zero), as the mean of its samples so far.
struct Line {
  Eigen::Vector2f mean_m;
  Eigen::Vector2f normal;
  float length_m = 0.0F;

  [[nodiscard]] bool holds(const Eigen::Vector2f& p_m, const Eigen::Vector2f& p_normal) const {
    const Eigen::Vector2f from_mean_m = p_m - mean_m;
    if (p_normal.isZero(0.0F)) {
      return normal.isZero(0.0F) && from_mean_m.squaredNorm() < kSameThing_m * kSameThing_m;
    }
    return normal.dot(p_normal) > kSameLineCosine &&
           std::abs(normal.dot(from_mean_m)) < kSameLine_m;
  }

  void add(const Eigen::Vector2f& p_m, const Eigen::Vector2f& p_normal, float p_length_m) {
    length_m += p_length_m;
    const float share = p_length_m / length_m;
    mean_m += share * (p_m - mean_m);
    if (normal.isZero(0.0F)) return;
    normal += share * (p_normal - normal);
    normal.normalize();
  }
};

/// Agreeing samples sorted into lines. Neighbouring samples mostly lie on one line.
class LineLengths {
 public:
  void add(const Eigen::Vector2f& p_m, const Eigen::Vector2f& normal, float length_m) {
    if (last_ < lines_.size() && lines_[last_].holds(p_m, normal)) {
      lines_[last_].add(p_m, normal, length_m);
      return;
    }
    const auto found = std::find_if(
        lines_.begin(), lines_.end(), [&](const Line& line) { return line.holds(p_m, normal); });
    last_ = static_cast<std::size_t>(found - lines_.begin());
    if (found == lines_.end()) lines_.push_back({.mean_m = p_m, .normal = normal});
    lines_[last_].add(p_m, normal, length_m);
  }

  [[nodiscard]] double capped_sum_m() const {
    double sum_m = 0.0;
    for (const Line& line : lines_) sum_m += std::min(line.length_m, kMaxLine_m);
    return sum_m;
  }

 private:
  std::vector<Line> lines_;
  std::size_t last_ = 0;
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
