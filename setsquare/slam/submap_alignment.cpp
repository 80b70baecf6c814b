// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/submap_alignment.hpp"

#include <cmath>

namespace setsquare {
namespace {

constexpr std::uint8_t kCompared = 1;
constexpr std::uint8_t kExplained = 2;
constexpr std::uint8_t kContradicted = 4;

constexpr float kMinNormalAgreement = 0.7F;  ///< Cosine between the two surfaces' normals.
constexpr float kExplainedDistance_m = 0.10F;

/// Sums of weighted outer products of the rows (n_x, n_y, n . perp(p)), in the keyframe's frame.
struct LineSums {
  double xx = 0.0, xy = 0.0, xt = 0.0, yy = 0.0, yt = 0.0, tt = 0.0;
  double x = 0.0, y = 0.0, t = 0.0;
  std::int64_t num_pairs = 0;

  /// A point `distance_m` off the line of normal n; its arm is p less the sensor's place.
  void add(float nx, float ny, float arm_x, float arm_y, float distance_m, float weight) {
    const float nt = ny * arm_x - nx * arm_y;
    const float wx = weight * nx;
    const float wy = weight * ny;
    const float wt = weight * nt;
    xx += wx * nx;
    xy += wx * ny;
    xt += wx * nt;
    yy += wy * ny;
    yt += wy * nt;
    tt += wt * nt;
    x += wx * distance_m;
    y += wy * distance_m;
    t += wt * distance_m;
  }
};

/// A rigid motion in single precision, as the kernels need it.
struct Motion {
  explicit Motion(const Pose2& T)
      : c(static_cast<float>(std::cos(T.theta_rad))),
        s(static_cast<float>(std::sin(T.theta_rad))),
        x_m(static_cast<float>(T.x_m)),
        y_m(static_cast<float>(T.y_m)) {}
  float c, s, x_m, y_m;
};

/// What the keyframe says of a point: `square_m2` is its squared range from the keyframe's sensor.
std::uint8_t mark_of(bool may_be_same, float distance_m, float square_m2, float free_square_m2) {
  if (may_be_same && std::abs(distance_m) < kExplainedDistance_m) return kCompared | kExplained;
  return square_m2 < free_square_m2 ? kCompared | kContradicted : kCompared;
}

LineSums sum_lines(const SurfaceImage& image,
                   const SurfacePoints& points,
                   const Pose2& T_keyframe_sensor,
                   const AlignmentScale& scale,
                   PointMarks& marks) {
  const Motion T(T_keyframe_sensor);
  const auto gate_m = static_cast<float>(scale.gate_m);
  const auto inverse_square = static_cast<float>(1.0 / (scale.scale_m * scale.scale_m));
  LineSums sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float arm_x = T.c * points.x_m[i] - T.s * points.y_m[i];
    const float arm_y = T.s * points.x_m[i] + T.c * points.y_m[i];
    const float x_m = arm_x + T.x_m;
    const float y_m = arm_y + T.y_m;
    const SurfaceSector& sector = image.at(x_m, y_m);
    if (sector.offset_m == SurfaceImage::kNoSurface_m) continue;
    const float distance_m = SurfaceImage::signed_distance_m(sector, x_m, y_m);
    const float normal_x = T.c * points.normal_x[i] - T.s * points.normal_y[i];
    const float normal_y = T.s * points.normal_x[i] + T.c * points.normal_y[i];
    const float agreement = normal_x * sector.normal_x + normal_y * sector.normal_y;
    const bool faces_alike = agreement > kMinNormalAgreement;
    // Where no line fits (a post, clutter) nearness is all that can be asked.
    const bool has_normal = points.normal_x[i] != 0.0F || points.normal_y[i] != 0.0F;
    marks[i] |= mark_of(
        faces_alike || !has_normal, distance_m, x_m * x_m + y_m * y_m, sector.free_square_m2);
    if (!faces_alike) continue;
    ++sums.num_pairs;
    if (std::abs(distance_m) > gate_m) continue;
    const float root = 1.0F / (1.0F + distance_m * distance_m * inverse_square);
    sums.add(sector.normal_x, sector.normal_y, arm_x, arm_y, distance_m, root * root);
  }
  return sums;
}

void add_rotated(const LineSums& sums, double heading_rad, SubmapAlignment& alignment) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix3d hessian;
  hessian << sums.xx, sums.xy, sums.xt, sums.xy, sums.yy, sums.yt, sums.xt, sums.yt, sums.tt;
  Eigen::Matrix3d rotation;
  rotation << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  alignment.hessian += rotation * hessian * rotation.transpose();
  alignment.gradient += rotation * Eigen::Vector3d(sums.x, sums.y, sums.t);
}

}  // namespace

SubmapAlignment align_with_submap(std::span<const Keyframe> keyframes,
                                  const SurfacePoints& points,
                                  const Pose2& T_odom_sensor,
                                  const AlignmentScale& scale,
                                  PointMarks& marks) {
  marks.assign(points.size(), 0);
  SubmapAlignment alignment;
  std::int64_t num_pairs = 0;
  for (const Keyframe& keyframe : keyframes) {
    const Pose2 T_keyframe_sensor = keyframe.T_odom_sensor.inverse() * T_odom_sensor;
    const LineSums sums = sum_lines(keyframe.image, points, T_keyframe_sensor, scale, marks);
    add_rotated(sums, keyframe.T_odom_sensor.theta_rad, alignment);
    num_pairs += sums.num_pairs;
  }
  for (const std::uint8_t mark : marks) {
    alignment.num_compared += (mark & kCompared) != 0 ? 1.0 : 0.0;
    alignment.num_explained += (mark & kExplained) != 0 ? 1.0 : 0.0;
    alignment.num_contradicted +=
        (mark & (kExplained | kContradicted)) == kContradicted ? 1.0 : 0.0;
  }
  const double sightings =
      std::max(1.0, static_cast<double>(num_pairs) / std::max(1.0, alignment.num_compared));
  alignment.hessian /= sightings;
  alignment.gradient /= sightings;
  return alignment;
}

double closeness_to_submap(std::span<const Keyframe> keyframes,
                           const SurfacePoints& points,
                           const Pose2& T_odom_sensor,
                           double scale_m) {
  const auto inverse_square = static_cast<float>(1.0 / (scale_m * scale_m));
  double sum = 0.0;
  std::int64_t count = 0;
  for (const Keyframe& keyframe : keyframes) {
    const Motion T(keyframe.T_odom_sensor.inverse() * T_odom_sensor);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float x_m = T.c * points.x_m[i] - T.s * points.y_m[i] + T.x_m;
      const float y_m = T.s * points.x_m[i] + T.c * points.y_m[i] + T.y_m;
      const SurfaceSector& sector = keyframe.image.at(x_m, y_m);
      if (sector.offset_m == SurfaceImage::kNoSurface_m) continue;
      const float distance_m = SurfaceImage::signed_distance_m(sector, x_m, y_m);
      sum += 1.0F / (1.0F + distance_m * distance_m * inverse_square);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace setsquare
