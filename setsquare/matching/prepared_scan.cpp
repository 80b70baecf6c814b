// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/prepared_scan.hpp"

#include "setsquare/matching/correlation_grid.hpp"
#include "setsquare/matching/direction_balance.hpp"

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
  return prepared;
}

}  // namespace setsquare
