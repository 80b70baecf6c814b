// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Four points at a time: most of a mapper's time is spent here (benchmarks/stages, submap).
#include "setsquare/tracking/submap_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/sector_lanes.hpp"

namespace setsquare {
namespace {

// What a point met, as bits.
constexpr std::int32_t kCompared = 1;
constexpr std::int32_t kExplained = 2;
constexpr std::int32_t kContradicted = 4;

constexpr float kExplainedDistance_m = 0.10F;

Ints spread_bits(std::int32_t value) { return Ints{value, value, value, value}; }

Ints load_bits(const std::int32_t* values) {
  Ints bits;
  std::memcpy(&bits, values, sizeof bits);
  return bits;
}

/// A rigid motion, four times.
struct MotionLanes {
  explicit MotionLanes(const Pose2& T)
      : c(spread(static_cast<float>(std::cos(T.theta_rad)))),
        s(spread(static_cast<float>(std::sin(T.theta_rad)))),
        x_m(spread(static_cast<float>(T.x_m))),
        y_m(spread(static_cast<float>(T.y_m))) {}
  Floats c, s, x_m, y_m;
};

/// Four points in the frame of an image, with what the image shows in their directions.
struct ComparedLanes {
  ComparedLanes(const SurfaceImage& image,
                const SurfaceSamples& points,
                std::size_t first,
                const MotionLanes& T) {
    const Floats px = load_lanes(&points.x_m[first]);
    const Floats py = load_lanes(&points.y_m[first]);
    arm_x = T.c * px - T.s * py;
    arm_y = T.s * px + T.c * py;
    x_m = arm_x + T.x_m;
    y_m = arm_y + T.y_m;
    sector = gather(image.sectors().data(), image.sector_indices(x_m, y_m));
    constexpr Ints kLane{0, 1, 2, 3};
    const Ints is_point =
        kLane < spread_bits(static_cast<std::int32_t>(points.size() - first));  // not padding
    is_compared = is_point & (sector.offset_m < spread(kHalfNoSurface_m));
    distance_m =
        where(is_compared, sector.normal_x * x_m + sector.normal_y * y_m - sector.offset_m);
  }

  Floats arm_x, arm_y;  ///< The point less the place of its own sensor.
  Floats x_m, y_m;
  SectorLanes sector;
  Floats distance_m;
  Ints is_compared;
};

/// Sums of weighted outer products of the rows (n_x, n_y, n . perp(arm)), in the image's frame.
struct LineSums {
  Floats xx{}, xy{}, xt{}, yy{}, yt{}, tt{};
  Floats x{}, y{}, t{};
  Ints num_pairs{};

  void add(const ComparedLanes& p, Floats weight) {
    const Floats nx = p.sector.normal_x;
    const Floats ny = p.sector.normal_y;
    const Floats nt = ny * p.arm_x - nx * p.arm_y;
    const Floats wx = weight * nx;
    const Floats wy = weight * ny;
    const Floats wt = weight * nt;
    xx += wx * nx;
    xy += wx * ny;
    xt += wx * nt;
    yy += wy * ny;
    yt += wy * nt;
    tt += wt * nt;
    x += wx * p.distance_m;
    y += wy * p.distance_m;
    t += wt * p.distance_m;
  }
};

/// What the image says of the points.
Ints bits_of(const ComparedLanes& p, Ints may_be_same) {
  const Ints is_explained =
      p.is_compared & may_be_same & (absolute(p.distance_m) < spread(kExplainedDistance_m));
  const Ints is_seen_through =
      p.is_compared & (p.x_m * p.x_m + p.y_m * p.y_m < p.sector.free_square_m2) & ~is_explained;
  return (p.is_compared & kCompared) | (is_explained & kExplained) |
         (is_seen_through & kContradicted);
}

LineSums sum_lines(const SurfaceImage& image,
                   const SurfaceSamples& points,
                   const Pose2& T_image_sensor,
                   const AlignmentScale& scale,
                   PointMarks& marks) {
  const MotionLanes T(T_image_sensor);
  const Floats gate_m = spread(static_cast<float>(scale.gate_m));
  const Floats inverse_square = spread(static_cast<float>(1.0 / (scale.scale_m * scale.scale_m)));
  LineSums sums;
  for (std::size_t i = 0; i < points.padded_size(); i += kLanes) {
    const ComparedLanes p(image, points, i, T);
    const Floats own_x = load_lanes(&points.normal_x[i]);
    const Floats own_y = load_lanes(&points.normal_y[i]);
    const Floats agreement = (T.c * own_x - T.s * own_y) * p.sector.normal_x +
                             (T.s * own_x + T.c * own_y) * p.sector.normal_y;
    const Ints faces_alike = agreement > spread(kMinNormalCosine);
    // Where no line fits (a post, clutter) nearness is all that can be asked.
    const Ints has_no_normal = (own_x == Floats{}) & (own_y == Floats{});
    const Ints bits = load_bits(&marks[i]) | bits_of(p, faces_alike | has_no_normal);
    std::memcpy(&marks[i], &bits, sizeof bits);
    const Ints is_pair = p.is_compared & faces_alike;
    sums.num_pairs -= is_pair;  // a set mask is -1
    const Floats ratio = p.distance_m * p.distance_m * inverse_square;
    const Floats root = 1.0F / (1.0F + ratio);
    const Ints is_near = is_pair & (absolute(p.distance_m) <= gate_m);
    sums.add(p, where(is_near, root * root));
  }
  return sums;
}

void add_rotated(const LineSums& sums, double heading_rad, SubmapAlignment& alignment) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix3d hessian;
  hessian << sum_of(sums.xx), sum_of(sums.xy), sum_of(sums.xt),  //
      sum_of(sums.xy), sum_of(sums.yy), sum_of(sums.yt),         //
      sum_of(sums.xt), sum_of(sums.yt), sum_of(sums.tt);
  Eigen::Matrix3d rotation;
  rotation << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  alignment.hessian += rotation * hessian * rotation.transpose();
  alignment.gradient += rotation * Eigen::Vector3d(sum_of(sums.x), sum_of(sums.y), sum_of(sums.t));
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
    const LineSums sums = sum_lines(*placed.image, points, T_image_sensor, scale, marks);
    add_rotated(sums, placed.T_submap_sensor.theta_rad, alignment);
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
    const MotionLanes T(placed.T_submap_sensor.inverse() * T_submap_sensor);
    Floats closeness{};
    Ints num_compared{};
    for (std::size_t i = 0; i < points.padded_size(); i += kLanes) {
      const ComparedLanes p(*placed.image, points, i, T);
      const Floats ratio = p.distance_m * p.distance_m * inverse_square;
      closeness += where(p.is_compared, 1.0F / (1.0F + ratio));
      num_compared -= p.is_compared;
    }
    sum += sum_of(closeness);
    for (std::size_t lane = 0; lane < kLanes; ++lane) count += num_compared[lane];
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace setsquare
