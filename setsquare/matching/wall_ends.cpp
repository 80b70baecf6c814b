// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/wall_ends.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace setsquare {
namespace {

constexpr float kFarther_m = 0.3F;          ///< What lies behind an end is farther by this.
constexpr std::int32_t kNextBeams = 3;      ///< A wider gap without returns hides what is there.
constexpr double kNear_m = 0.15;            ///< Ends are the same within this ...
constexpr double kNearPerMetre = 0.01;      ///< ... and this for each metre, for beams spread.
constexpr double kSameSideCosine = 0.5;     ///< Of the directions into the walls.
constexpr double kBehindSurface_m = -0.15;  ///< Farther behind a surface nothing is seen.

/// The end at a return; `side` is +1 where its wall lies counterclockwise of it, -1 otherwise.
WallEnd end_at(const SurfacePoints& points, std::size_t i, double side) {
  const Eigen::Vector2d counterclockwise(points.normal_y[i], -points.normal_x[i]);
  return {{points.x_m[i], points.y_m[i]}, side * counterclockwise};
}

/// Whether the scan sees this place: in its view and not behind a surface.
bool sees(const SurfaceImage& image, const Eigen::Vector2d& p_m) {
  const auto x_m = static_cast<float>(p_m.x());
  const auto y_m = static_cast<float>(p_m.y());
  const SurfaceSector& sector = image.at(x_m, y_m);
  if (p_m.squaredNorm() < sector.free_square_m2) return true;
  constexpr float kHalfNoSurface_m = 0.5F * SurfaceImage::kNoSurface_m;
  if (sector.offset_m > kHalfNoSurface_m) return false;
  return SurfaceImage::signed_distance_m(sector, x_m, y_m) >= kBehindSurface_m;
}

bool is_shown(std::span<const WallEnd> ends, const WallEnd& end) {
  const double near_m = kNear_m + kNearPerMetre * end.at_m.norm();
  return std::ranges::any_of(ends, [&](const WallEnd& other) {
    if ((other.at_m - end.at_m).squaredNorm() > near_m * near_m) return false;
    const bool has_sides = !other.into_wall.isZero() && !end.into_wall.isZero();
    return !has_sides || other.into_wall.dot(end.into_wall) > kSameSideCosine;
  });
}

void count_one_way(const SurfaceImage& image,
                   std::span<const WallEnd> shown,
                   std::span<const WallEnd> moving,
                   const Pose2& T_image_moving,
                   WallEndCount& count) {
  const Pose2 turn{0.0, 0.0, T_image_moving.theta_rad};
  for (const WallEnd& end : moving) {
    const WallEnd moved{T_image_moving * end.at_m, turn * end.into_wall};
    if (!sees(image, moved.at_m)) continue;
    ++(is_shown(shown, moved) ? count.agreeing : count.missing);
  }
}

}  // namespace

std::vector<WallEnd> wall_ends(const SurfacePoints& points) {
  std::vector<WallEnd> ends;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points.joined[i] != 0 || points.beam[i + 1] - points.beam[i] > kNextBeams) continue;
    const float farther_m = points.range_m[i + 1] - points.range_m[i];
    if (farther_m > kFarther_m) ends.push_back(end_at(points, i, -1.0));
    if (farther_m < -kFarther_m) ends.push_back(end_at(points, i + 1, 1.0));
  }
  return ends;
}

WallEndCount compare_wall_ends(const PreparedScan& reference,
                               const PreparedScan& current,
                               const Pose2& T_reference_current) {
  const std::vector<WallEnd> of_reference = wall_ends(reference.points());
  const std::vector<WallEnd> of_current = wall_ends(current.points());
  WallEndCount count;
  count_one_way(reference.image(), of_reference, of_current, T_reference_current, count);
  count_one_way(current.image(), of_current, of_reference, T_reference_current.inverse(), count);
  return count;
}

}  // namespace setsquare
