// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/lanes.hpp"
#include "setsquare/surfaces/surface_params.hpp"
#include "setsquare/surfaces/surface_points.hpp"

namespace setsquare {

/// What a scan saw in one narrow sector around the sensor: the line of the surface there,
/// normal . q = offset, and how far the scan saw through.
struct SurfaceSector {
  float normal_x = 0.0F;  ///< Unit normal, facing the sensor; zero where no surface was seen.
  float normal_y = 0.0F;  ///< See normal_x.
  float offset_m = 0.0F;  ///< kNoSurface where none was seen.
  float free_square_m2 =
      0.0F;  ///< Nothing stands nearer than its root; zero where nothing is known.
};

/// A scan as a polar depth image. A point that is moved into this scan's frame finds the surface
/// that the scan saw in the point's direction in one access: nothing is searched, nothing is built
/// but the image. Sectors divide the circle by the diamond angle y / (|x| + |y|), monotone in the
/// bearing and free of trigonometry. A sector is a number of two bytes, for what it shows is what
/// one beam saw: most of a large circle shows nothing or the same as its neighbour.
class SurfaceImage {
 public:
  /// Offset of a sector without a surface: every point lies far behind it.
  static constexpr float kNoSurface_m = 1e9F;

  using Params = SurfaceImageParams;  ///< Of the image: see surface_params.hpp.

  /// Of no scan: to be assigned to.
  SurfaceImage() = default;
  /// Of a scan and the points that were made of it.
  SurfaceImage(const Scan& scan, const SurfacePoints& points, const Params& params);
  /// The same with the default parameters.
  SurfaceImage(const Scan& scan, const SurfacePoints& points)
      : SurfaceImage(scan, points, Params{}) {}

  /// The sector in the direction of (x, y), sensor frame; any point but the origin itself.
  [[nodiscard]] const SurfaceSector& at(float x_m, float y_m) const {
    return sector(sector_index(x_m, y_m));
  }
  /// Points behind the surface have a negative distance, points before it a positive one.
  [[nodiscard]] static float signed_distance_m(const SurfaceSector& sector, float x_m, float y_m) {
    return sector.normal_x * x_m + sector.normal_y * y_m - sector.offset_m;
  }

  /// The number of the sector of at(), for sector().
  [[nodiscard]] std::int32_t sector_index(float x_m, float y_m) const {
    return static_cast<std::int32_t>((diamond_angle(x_m, y_m) + 1.0F) * sectors_per_unit_) & mask_;
  }
  /// The same for four points at once.
  [[nodiscard]] Ints sector_indices(Floats x_m, Floats y_m) const {
    const Floats quotient = y_m / (absolute(x_m) + absolute(y_m) + 1e-12F);
    const Floats angle = select(x_m >= Floats{}, quotient, 2.0F - quotient);
    return __builtin_convertvector((angle + 1.0F) * sectors_per_unit_, Ints) & mask_;
  }
  /// What a sector shows; they are counted from -90 deg on.
  [[nodiscard]] const SurfaceSector& sector(std::int32_t index) const {
    return seen_[seen_at_[static_cast<std::size_t>(index)]];
  }
  /// Sectors of the circle.
  [[nodiscard]] std::size_t num_sectors() const { return seen_at_.size(); }

  /// Monotone in the bearing from -90 deg (-1) through 0, 90 (1) and 180 deg (2) up to 270 deg (3).
  [[nodiscard]] static float diamond_angle(float x, float y) {
    const float sum = (x < 0.0F ? -x : x) + (y < 0.0F ? -y : y);
    const float quotient = y / (sum + 1e-12F);
    return x >= 0.0F ? quotient : 2.0F - quotient;
  }

 private:
  float sectors_per_unit_ = 0.0F;
  std::int32_t mask_ = 0;
  std::vector<SurfaceSector> seen_;     ///< What beams saw; the first one nothing.
  std::vector<std::uint16_t> seen_at_;  ///< Which of them each sector shows.
};

}  // namespace setsquare
