// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Four points at a time: most of a mapper's time is spent here (benchmarks/stages, submap).
#include "setsquare/tracking/submap_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

// What a point met, as bits.
constexpr std::int32_t kCompared = 1;
constexpr std::int32_t kExplained = 2;
constexpr std::int32_t kContradicted = 4;

/// Counts points for the score and has no part in the pose: a surface that is seen again is found
/// within it. AlignmentScale says what the pose depends on.
constexpr float kExplainedDistance_m = 0.10F;

Ints spread_bits(std::int32_t value) { return Ints{value, value, value, value}; }

Ints load_bits(const std::int32_t* values) {
  Ints bits;
  std::memcpy(&bits, values, sizeof bits);
  return bits;
}

/// Four points that an image may show, padding left out.
struct ComparedPoints {
  ComparedPoints(const SampleComparison<Floats>& compared, std::size_t num_points_left)
      : comparison(compared) {
    constexpr Ints kLane{0, 1, 2, 3};
    const Ints is_point = kLane < spread_bits(static_cast<std::int32_t>(num_points_left));
    is_compared = is_point & compared.has_surface();
    distance_m = where(is_compared, compared.distance_m);
  }

  const SampleComparison<Floats>& comparison;
  Ints is_compared;
  Floats distance_m;
};

/// The image's values at the points.
Ints bits_of(const ComparedPoints& p, Ints may_be_same) {
  const Ints is_explained =
      p.is_compared & may_be_same & (absolute(p.distance_m) < spread(kExplainedDistance_m));
  const Ints is_seen_through = p.is_compared & p.comparison.is_in_free_space() & ~is_explained;
  return (p.is_compared & kCompared) | (is_explained & kExplained) |
         (is_seen_through & kContradicted);
}

/// Normal equations in the image's frame, about the points' own sensor.
struct PointSums {
  LineSums lines;
  Ints num_pairs{};
};

PointSums sum_lines(const SurfaceImage& image,
                    const SurfaceSamples& points,
                    const Pose2& T_image_sensor,
                    const AlignmentScale& scale,
                    PointMarks& marks) {
  const Floats gate_m = spread(static_cast<float>(scale.gate_m));
  const Floats inverse_square = spread(static_cast<float>(1.0 / (scale.scale_m * scale.scale_m)));
  PointSums sums;
  compare_by_fours(image, points, T_image_sensor, [&](std::size_t first, const auto& compared) {
    const ComparedPoints p(compared, points.size() - first);
    const Ints faces_alike = compared.faces_alike();
    // Where no line fits (a post, clutter) only nearness can be tested.
    const Ints bits = load_bits(&marks[first]) | bits_of(p, faces_alike | ~compared.has_normal());
    std::memcpy(&marks[first], &bits, sizeof bits);
    const Ints is_pair = p.is_compared & faces_alike;
    sums.num_pairs -= is_pair;  // a set mask is -1
    // Geman and McClure's weight (core/robust_weight), four at a time.
    const Floats ratio = p.distance_m * p.distance_m * inverse_square;
    const Floats root = 1.0F / (1.0F + ratio);
    const Ints is_near = is_pair & (absolute(p.distance_m) <= gate_m);
    sums.lines.add(compared.sector,
                   compared.lever_m(compared.sample.arm_x_m, compared.sample.arm_y_m),
                   where(is_near, root * root),
                   p.distance_m);
  });
  return sums;
}

void add_rotated(const LineSums& sums, double heading_rad, SubmapAlignment& alignment) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix3d rotation;
  rotation << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  alignment.hessian += rotation * sums.hessian() * rotation.transpose();
  alignment.gradient += rotation * sums.gradient();
}

void count_marks(const PointMarks& marks, SubmapAlignment& alignment) {
  int num_compared = 0;
  int num_explained = 0;
  int num_contradicted = 0;
  for (const std::int32_t mark : marks) {
    num_compared += (mark & kCompared) != 0;
    num_explained += (mark & kExplained) != 0;
    num_contradicted += (mark & (kExplained | kContradicted)) == kContradicted;
  }
  alignment.num_compared = num_compared;
  alignment.num_explained = num_explained;
  alignment.num_contradicted = num_contradicted;
}

}  // namespace

bool is_explained(std::int32_t mark) { return (mark & kExplained) != 0; }

void AlignmentScale::validate(const std::string& owner) const {
  require_positive(gate_m, owner + ".gate_m");
  require_positive(scale_m, owner + ".scale_m");
}

SubmapAlignment align_with_submap(std::span<const PlacedImage> submap,
                                  const SurfaceSamples& points,
                                  const Pose2& T_submap_sensor,
                                  const AlignmentScale& scale,
                                  PointMarks& marks) {
  marks.assign(points.padded_size(), 0);
  SubmapAlignment alignment;
  double num_pairs = 0.0;
  for (const PlacedImage& placed : submap) {
    const Pose2 T_image_sensor = placed.T_submap_sensor.inverse() * T_submap_sensor;
    const PointSums sums = sum_lines(*placed.image, points, T_image_sensor, scale, marks);
    add_rotated(sums.lines, placed.T_submap_sensor.theta_rad, alignment);
    for (std::size_t lane = 0; lane < kLanes; ++lane) num_pairs += sums.num_pairs[lane];
  }
  count_marks(marks, alignment);
  const double sightings = std::max(1.0, num_pairs / std::max(1.0, alignment.num_compared));
  alignment.hessian /= sightings;
  alignment.gradient /= sightings;
  return alignment;
}

double closeness_to_submap(std::span<const PlacedImage> submap,
                           const SurfaceSamples& points,
                           const Pose2& T_submap_sensor,
                           double scale_m) {
  const Floats inverse_square = spread(static_cast<float>(1.0 / (scale_m * scale_m)));
  double sum = 0.0;
  double count = 0.0;
  for (const PlacedImage& placed : submap) {
    const Pose2 T_image_sensor = placed.T_submap_sensor.inverse() * T_submap_sensor;
    Floats closeness{};
    Ints num_compared{};
    const auto add = [&](std::size_t first, const SampleComparison<Floats>& compared) {
      const ComparedPoints p(compared, points.size() - first);
      const Floats ratio = p.distance_m * p.distance_m * inverse_square;
      closeness += where(p.is_compared, 1.0F / (1.0F + ratio));
      num_compared -= p.is_compared;
    };
    compare_by_fours(*placed.image, points, T_image_sensor, add);
    sum += sum_of(closeness);
    for (std::size_t lane = 0; lane < kLanes; ++lane) count += num_compared[lane];
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace setsquare
