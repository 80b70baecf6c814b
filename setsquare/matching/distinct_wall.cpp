// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/distinct_wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

/// A line, or a piece of clutter (normal zero), as the mean of its samples so far.
struct Line {
  Eigen::Vector2f mean_m;
  Eigen::Vector2f normal;
  float length_m = 0.0F;

  [[nodiscard]] bool holds(const Eigen::Vector2f& p_m,
                           const Eigen::Vector2f& p_normal,
                           const DistinctWallParams& params) const {
    const Eigen::Vector2f from_mean_m = p_m - mean_m;
    if (p_normal.isZero(0.0F)) {
      const auto same_clutter_m = static_cast<float>(params.same_clutter_m);
      return normal.isZero(0.0F) && from_mean_m.squaredNorm() < same_clutter_m * same_clutter_m;
    }
    return normal.dot(p_normal) > static_cast<float>(params.same_line_cosine) &&
           std::abs(normal.dot(from_mean_m)) < static_cast<float>(params.same_line_m);
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
  explicit LineLengths(const DistinctWallParams& params) : params_(params) {}

  void add(const Eigen::Vector2f& p_m, const Eigen::Vector2f& normal, float length_m) {
    if (last_ < lines_.size() && lines_[last_].holds(p_m, normal, params_)) {
      lines_[last_].add(p_m, normal, length_m);
      return;
    }
    const auto found = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) {
      return line.holds(p_m, normal, params_);
    });
    last_ = static_cast<std::size_t>(found - lines_.begin());
    if (found == lines_.end()) lines_.push_back({.mean_m = p_m, .normal = normal});
    lines_[last_].add(p_m, normal, length_m);
  }

  [[nodiscard]] double capped_sum_m() const {
    const auto max_line_m = static_cast<float>(params_.max_line_m);
    double sum_m = 0.0;
    for (const Line& line : lines_) sum_m += std::min(line.length_m, max_line_m);
    return sum_m;
  }

 private:
  const DistinctWallParams& params_;
  std::vector<Line> lines_;
  std::size_t last_ = 0;
};

/// In whose frame the lines are.
enum class FrameOfLines { kImage, kSamples };

/// Adds the samples that lie on the surfaces of an image.
void add_agreeing(const SurfaceImage& image,
                  const SurfaceSamples& samples,
                  const Pose2& T_image_samples,
                  FrameOfLines frame,
                  const DistinctWallParams& params,
                  LineLengths& lines) {
  const Floats max_distance_m = spread(static_cast<float>(params.max_distance_m));
  compare_by_fours(image, samples, T_image_samples, [&](std::size_t first, const auto& compared) {
    const Ints is_near = absolute(compared.distance_m) < max_distance_m;
    const Ints agrees = is_near & (compared.faces_alike() | ~compared.has_normal());
    const MovedSample<Floats>& moved = compared.sample;
    for (std::size_t lane = 0; lane < kLanes && first + lane < samples.size(); ++lane) {
      if (!agrees[lane]) continue;
      const std::size_t i = first + lane;
      const bool is_moved = frame == FrameOfLines::kImage;
      const Eigen::Vector2f p_m = is_moved ? Eigen::Vector2f(moved.x_m[lane], moved.y_m[lane])
                                           : Eigen::Vector2f(samples.x_m[i], samples.y_m[i]);
      const Eigen::Vector2f normal =
          is_moved ? Eigen::Vector2f(moved.normal_x[lane], moved.normal_y[lane])
                   : Eigen::Vector2f(samples.normal_x[i], samples.normal_y[i]);
      lines.add(p_m, normal, samples.weight_m[i]);
    }
  });
}

}  // namespace

double distinct_wall_m(const AlignedScan& reference,
                       const AlignedScan& current,
                       const Pose2& T_reference_current,
                       const DistinctWallParams& params) {
  LineLengths lines(params);
  add_agreeing(
      reference.image, current.samples, T_reference_current, FrameOfLines::kImage, params, lines);
  add_agreeing(current.image,
               reference.samples,
               T_reference_current.inverse(),
               FrameOfLines::kSamples,
               params,
               lines);
  return lines.capped_sum_m();
}

}  // namespace setsquare
