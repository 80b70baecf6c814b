// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The one kernel that compares a scan's samples with another scan's polar image. It moves a sample
// into the image's frame, looks up the sector in its direction and measures the distance from the
// line there. The caller decides what to sum: `alignment` and the tracker's submap sum
// four samples at a time, `distinct_wall` sorts them into lines, the sweep refinement straightens
// each sample by how the robot turned. Number is Floats for four samples side by side, or float.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <Eigen/Core>
#include <type_traits>

#include "setsquare/core/pose2.hpp"
#include "setsquare/surfaces/lanes.hpp"
#include "setsquare/surfaces/surface_image.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// A sample without a fitted line counts for less: it may be anything.
inline constexpr float kClutterWeight = 0.3F;
/// Walls that agree face the same way within this angle's cosine.
inline constexpr float kMinNormalCosine = 0.7F;
/// A sector whose offset is beyond it shows no surface.
inline constexpr float kHalfNoSurface_m = 0.5F * SurfaceImage::kNoSurface_m;

/// The same value in every lane.
template <typename Number>
[[nodiscard]] inline Number everywhere(float value) {
  if constexpr (std::is_same_v<Number, Floats>) {
    return spread(value);
  } else {
    return value;
  }
}

/// A rigid motion in the kernel's precision.
template <typename Number>
struct Motion {
  explicit Motion(const Pose2& T)
      : c(everywhere<Number>(static_cast<float>(std::cos(T.theta_rad)))),
        s(everywhere<Number>(static_cast<float>(std::sin(T.theta_rad)))),
        x_m(everywhere<Number>(static_cast<float>(T.x_m))),
        y_m(everywhere<Number>(static_cast<float>(T.y_m))) {}
  Number c, s, x_m, y_m;
};

/// A sample in the frame of an image.
template <typename Number>
struct MovedSample {
  Number arm_x_m, arm_y_m;    ///< From the place of its own sensor.
  Number x_m, y_m;            ///< From the image's sensor.
  Number normal_x, normal_y;  ///< Zero where no line fits.
};

template <typename Number>
[[nodiscard]] inline MovedSample<Number> moved_sample(
    const Motion<Number>& T, Number x_m, Number y_m, Number normal_x, Number normal_y) {
  const Number arm_x_m = T.c * x_m - T.s * y_m;
  const Number arm_y_m = T.s * x_m + T.c * y_m;
  return {arm_x_m,
          arm_y_m,
          arm_x_m + T.x_m,
          arm_y_m + T.y_m,
          T.c * normal_x - T.s * normal_y,
          T.s * normal_x + T.c * normal_y};
}

/// What an image shows in one direction, or in four: as SurfaceSector.
template <typename Number>
struct SeenSector {
  Number normal_x, normal_y, offset_m, free_square_m2;
};

[[nodiscard]] inline SeenSector<float> seen_sector(const SurfaceImage& image,
                                                   float x_m,
                                                   float y_m) {
  const SurfaceSector& sector = image.at(x_m, y_m);
  return {sector.normal_x, sector.normal_y, sector.offset_m, sector.free_square_m2};
}

/// Four loads and a transposition.
[[nodiscard]] inline SeenSector<Floats> seen_sector(const SurfaceImage& image,
                                                    Floats x_m,
                                                    Floats y_m) {
  static_assert(sizeof(SurfaceSector) == sizeof(Floats));
  const Ints index = image.sector_indices(x_m, y_m);
  std::array<Floats, kLanes> rows;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    std::memcpy(&rows[lane], &image.sector(index[lane]), sizeof(Floats));
  }
  const Floats a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Floats b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Floats c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Floats d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(a, b, 0, 1, 4, 5),
          __builtin_shufflevector(a, b, 2, 3, 6, 7),
          __builtin_shufflevector(c, d, 0, 1, 4, 5),
          __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}

/// A sample and the line that the image shows in its direction.
template <typename Number>
struct SampleComparison {
  SampleComparison(const SurfaceImage& image, const MovedSample<Number>& moved)
      : sample(moved),
        sector(seen_sector(image, moved.x_m, moved.y_m)),
        distance_m(sector.normal_x * moved.x_m + sector.normal_y * moved.y_m - sector.offset_m) {}

  MovedSample<Number> sample;
  SeenSector<Number> sector;
  Number distance_m;  ///< Negative behind the surface, positive before it.

  [[nodiscard]] auto has_surface() const {
    return sector.offset_m < everywhere<Number>(kHalfNoSurface_m);
  }
  [[nodiscard]] auto has_normal() const {
    return (sample.normal_x != Number{}) | (sample.normal_y != Number{});
  }
  [[nodiscard]] auto faces_alike() const {
    return sector.normal_x * sample.normal_x + sector.normal_y * sample.normal_y >
           everywhere<Number>(kMinNormalCosine);
  }
  /// Whether the scan saw through the place of the sample.
  [[nodiscard]] auto is_in_free_space() const {
    return sample.x_m * sample.x_m + sample.y_m * sample.y_m < sector.free_square_m2;
  }
  /// Tukey's biweight is its square, where it is positive.
  [[nodiscard]] Number nearness(Number inverse_tolerance) const {
    const Number u = distance_m * inverse_tolerance;
    return 1.0F - u * u;
  }
  /// How much the distance changes when a point at (x, y) turns about the origin.
  [[nodiscard]] Number lever_m(Number x_m, Number y_m) const {
    return sector.normal_y * x_m - sector.normal_x * y_m;
  }
};

/// How much a sample counts by the way it faces: not at all where it faces another way.
[[nodiscard]] inline float facing_weight(const SampleComparison<float>& compared) {
  if (!compared.has_normal()) return kClutterWeight;
  return compared.faces_alike() ? 1.0F : 0.0F;
}
[[nodiscard]] inline Floats facing_weight(const SampleComparison<Floats>& compared) {
  const Ints has_normal = compared.has_normal();
  return where(has_normal & compared.faces_alike(), spread(1.0F)) +
         where(~has_normal, spread(kClutterWeight));
}

/// Calls visit(first, comparison) for every four samples; the last four may be padded with
/// weightless points.
template <typename Visit>
inline void compare_by_fours(const SurfaceImage& image,
                             const SurfaceSamples& samples,
                             const Pose2& T_image_samples,
                             Visit&& visit) {
  const Motion<Floats> T(T_image_samples);
  for (std::size_t i = 0; i < samples.padded_size(); i += kLanes) {
    const MovedSample<Floats> moved = moved_sample(T,
                                                   load_lanes(&samples.x_m[i]),
                                                   load_lanes(&samples.y_m[i]),
                                                   load_lanes(&samples.normal_x[i]),
                                                   load_lanes(&samples.normal_y[i]));
    visit(i, SampleComparison<Floats>(image, moved));
  }
}

/// Normal equations of point-to-line distances, four at a time: sums of weighted products of rows
/// (n_x, n_y, lever).
struct LineSums {
  Floats xx{}, xy{}, xt{}, yy{}, yt{}, tt{};
  Floats x{}, y{}, t{};

  void add(const SeenSector<Floats>& line, Floats lever_m, Floats weight, Floats distance_m) {
    const Floats wx = weight * line.normal_x;
    const Floats wy = weight * line.normal_y;
    const Floats wt = weight * lever_m;
    xx += wx * line.normal_x;
    xy += wx * line.normal_y;
    xt += wx * lever_m;
    yy += wy * line.normal_y;
    yt += wy * lever_m;
    tt += wt * lever_m;
    x += wx * distance_m;
    y += wy * distance_m;
    t += wt * distance_m;
  }

  [[nodiscard]] Eigen::Matrix3d hessian() const {
    Eigen::Matrix3d sums;
    sums << sum_of(xx), sum_of(xy), sum_of(xt),  //
        sum_of(xy), sum_of(yy), sum_of(yt),      //
        sum_of(xt), sum_of(yt), sum_of(tt);
    return sums;
  }
  [[nodiscard]] Eigen::Vector3d gradient() const { return {sum_of(x), sum_of(y), sum_of(t)}; }
};

}  // namespace setsquare
