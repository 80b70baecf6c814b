// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/surface_image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

constexpr double kSectorsPerBeam = 2.0;
constexpr std::uint32_t kMinSectors = 512;
constexpr std::uint32_t kMaxSectors = 8192;

std::uint32_t sectors_for(const Scan& scan) {
  const double step_rad = std::abs(scan.bearing_step_rad);
  const double wanted = step_rad > 0.0 ? kSectorsPerBeam * kTwoPi / step_rad : 0.0;
  const double limited = std::min(wanted, static_cast<double>(kMaxSectors));
  return std::clamp(std::bit_ceil(static_cast<std::uint32_t>(limited)), kMinSectors, kMaxSectors);
}

SurfaceSector unknown_sector() { return {.offset_m = SurfaceImage::kNoSurface_m}; }

float free_square(double range_m, const SurfaceImage::Params& params) {
  const double free_m =
      std::max(0.0, range_m * (1.0 - params.free_margin_ratio) - params.free_margin_m);
  return static_cast<float>(free_m * free_m);
}

bool is_same(const SurfaceSector& a, const SurfaceSector& b) {
  return a.normal_x == b.normal_x && a.normal_y == b.normal_y && a.offset_m == b.offset_m &&
         a.free_square_m2 == b.free_square_m2;
}

/// Free range of a beam without a usable return, at most the sensor's reach.
double seen_free_m(const Scan& scan, std::size_t beam, const SurfaceImage::Params& params) {
  const BeamOutcome outcome = scan.outcome(beam);
  if (outcome == BeamOutcome::kInvalid) return 0.0;
  const double reach_m = outcome == BeamOutcome::kReturn ? scan.ranges_m[beam] : scan.max_range_m;
  return std::min(params.no_return_free_m, reach_m);
}

/// The line at a return; across the ray where none fits (a post, a leg of a chair).
SurfaceSector sector_of_return(const SurfacePoints& points,
                               std::size_t i,
                               const SurfaceImage::Params& params) {
  SurfaceSector sector;
  sector.normal_x = points.normal_x[i];
  sector.normal_y = points.normal_y[i];
  const bool has_line = sector.normal_x != 0.0F || sector.normal_y != 0.0F;
  if (!has_line && points.range_m[i] >= std::numeric_limits<float>::min()) {
    sector.normal_x = -points.x_m[i] / points.range_m[i];
    sector.normal_y = -points.y_m[i] / points.range_m[i];
  }
  sector.offset_m = sector.normal_x * points.x_m[i] + sector.normal_y * points.y_m[i];
  sector.free_square_m2 = free_square(points.range_m[i], params);
  return sector;
}

}  // namespace

void SurfaceImageParams::validate() const {
  require_not_negative(no_return_free_m, "image.no_return_free_m");
  require_not_negative(free_margin_m, "image.free_margin_m");
  require_not_negative(free_margin_ratio, "image.free_margin_ratio");
}

SurfaceImage::SurfaceImage(const Scan& scan, const SurfacePoints& points, const Params& params) {
  const std::uint32_t count = sectors_for(scan);
  sectors_per_unit_ = static_cast<float>(count) / 4.0F;
  mask_ = static_cast<std::int32_t>(count) - 1;
  seen_at_.assign(count, 0);
  seen_.reserve(std::min<std::size_t>(scan.num_beams(), count) + 1);
  seen_.push_back(unknown_sector());

  // Each beam fills the sectors between the half-way directions to its neighbours.
  const double half_step_rad = 0.5 * scan.bearing_step_rad;
  double c = std::cos(scan.first_bearing_rad - half_step_rad);
  double s = std::sin(scan.first_bearing_rad - half_step_rad);
  const double step_c = std::cos(scan.bearing_step_rad);
  const double step_s = std::sin(scan.bearing_step_rad);
  std::size_t point = 0;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double next_c = c * step_c - s * step_s;
    const double next_s = s * step_c + c * step_s;
    SurfaceSector sector = unknown_sector();
    if (point < points.size() && points.beam[point] == static_cast<std::int32_t>(beam)) {
      sector = sector_of_return(points, point, params);
      // An edge: the gap next to it may be covered, so the nearer return bounds the free space.
      if (point + 1 < points.size() && points.beam[point + 1] == points.beam[point] + 1) {
        sector.free_square_m2 =
            std::min(sector.free_square_m2, free_square(points.range_m[point + 1], params));
      }
      if (point > 0 && points.beam[point - 1] == points.beam[point] - 1) {
        sector.free_square_m2 =
            std::min(sector.free_square_m2, free_square(points.range_m[point - 1], params));
      }
      ++point;
    } else {
      sector.free_square_m2 = free_square(seen_free_m(scan, beam, params), params);
    }
    const bool is_clockwise = scan.bearing_step_rad < 0.0;
    std::int32_t from = sector_index(static_cast<float>(c), static_cast<float>(s));
    std::int32_t to = sector_index(static_cast<float>(next_c), static_cast<float>(next_s));
    if (is_clockwise) std::swap(from, to);
    if (from != to) {
      if (!is_same(sector, seen_.back())) seen_.push_back(sector);
      const auto seen = static_cast<std::uint16_t>(seen_.size() - 1);
      for (std::int32_t k = from; k != to; k = (k + 1) & mask_) seen_at_[k] = seen;
    }
    c = next_c;
    s = next_s;
  }
}

}  // namespace setsquare
