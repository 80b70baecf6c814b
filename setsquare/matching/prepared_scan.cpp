// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/prepared_scan.hpp"

#include "setsquare/matching/correlation_grid.hpp"

namespace setsquare {

PreparedScan prepare(const Scan& scan, const SurfaceParams& params) {
  constexpr std::size_t kMaxFineSamples = 400;
  scan.validate();
  PreparedScan prepared;
  prepared.points = surface_points_from_scan(scan, params);
  prepared.image = SurfaceImage(scan, prepared.points);
  prepared.coarse = sample_surface(prepared.points, CorrelationGrid::kMaxSamples);
  prepared.fine = sample_surface(prepared.points, kMaxFineSamples);
  prepared.histogram = angle_histogram(prepared.points);
  return prepared;
}

}  // namespace setsquare
