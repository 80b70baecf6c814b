// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/prepared_scan.hpp"

#include <optional>
#include <utility>

#include "setsquare/core/approximate_bearing.hpp"
#include "setsquare/scan/isolated_returns.hpp"

namespace setsquare {
namespace {

double middle_of_sweep_rad(const Scan& scan) {
  const double last_beam = scan.num_beams() > 0 ? static_cast<double>(scan.num_beams() - 1) : 0.0;
  return wrap_to_pi(scan.first_bearing_rad + 0.5 * last_beam * scan.bearing_step_rad);
}

}  // namespace

ScanSurfacesPtr scan_surfaces(const Scan& scan,
                              const SurfaceParams& params,
                              const SurfaceImage::Params& image_params) {
  return scan_surfaces(scan, surface_points_from_scan(scan, params), image_params);
}

ScanSurfacesPtr scan_surfaces(const Scan& scan,
                              SurfacePoints points,
                              const SurfaceImage::Params& image_params) {
  SurfaceImage image(scan, points, image_params);
  return std::make_shared<const ScanSurfaces>(
      ScanSurfaces{std::move(points), std::move(image), middle_of_sweep_rad(scan)});
}

float bearing_from(float middle_rad, float x_m, float y_m) {
  constexpr float kHalfTurn = static_cast<float>(kPi);
  const float angle_rad = approximate_bearing(y_m, x_m) - middle_rad;
  if (angle_rad >= kHalfTurn) return angle_rad - 2.0F * kHalfTurn;
  return angle_rad < -kHalfTurn ? angle_rad + 2.0F * kHalfTurn : angle_rad;
}

std::vector<float> bearings_from(double middle_rad, const SurfaceSamples& samples) {
  std::vector<float> bearings_rad(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    bearings_rad[i] = bearing_from(static_cast<float>(middle_rad), samples.x_m[i], samples.y_m[i]);
  }
  return bearings_rad;
}

PreparedScan prepare(const Scan& scan, const SurfaceParams& params, const SampleParams& samples) {
  scan.validate();
  const std::optional<Scan> cleared = without_isolated_returns(scan);
  return prepare(scan_surfaces(cleared ? *cleared : scan, params), samples);
}

PreparedScan prepare(ScanSurfacesPtr surfaces, const SampleParams& samples) {
  PreparedScan prepared;
  const SurfacePoints& points = surfaces->points;
  prepared.coarse = sample_surface(points, samples.max_coarse);
  prepared.histogram = angle_histogram(points);
  prepared.fine = sample_surface(
      points, direction_balanced_weights(points, prepared.histogram), samples.max_fine);
  prepared.dense = sample_surface(points, samples.max_dense);
  prepared.dense_from_middle_rad = bearings_from(surfaces->sweep_middle_rad, prepared.dense);
  prepared.surfaces = std::move(surfaces);
  return prepared;
}

}  // namespace setsquare
