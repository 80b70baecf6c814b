// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/prepared_scan.hpp"

#include "setsquare/surfaces/angle_histogram.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"

namespace setsquare {

PreparedScan prepare(const Scan& scan, const SurfaceParams& params) {
  constexpr std::size_t kMaxFineSamples = 400;
  constexpr std::size_t kMaxDenseSamples = 1200;
  scan.validate();
  PreparedScan prepared;
  prepared.points = surface_points_from_scan(scan, params);
  prepared.image = SurfaceImage(scan, prepared.points);
  prepared.coarse = sample_surface(prepared.points, CorrelationGrid::kMaxSamples);
  prepared.histogram = angle_histogram(prepared.points);
  prepared.fine = sample_surface(prepared.points,
                                 direction_balanced_weights(prepared.points, prepared.histogram),
                                 kMaxFineSamples);
  prepared.dense = sample_surface(prepared.points, kMaxDenseSamples);
  const double last_beam = scan.num_beams() > 0 ? static_cast<double>(scan.num_beams() - 1) : 0.0;
  prepared.middle_rad =
      wrap_to_pi(scan.first_bearing_rad + 0.5 * last_beam * scan.bearing_step_rad);
  prepared.dense_from_middle_rad = bearings_from(prepared.middle_rad, prepared.dense);
  return prepared;
}

}  // namespace setsquare
