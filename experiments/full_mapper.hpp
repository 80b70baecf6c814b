// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {

/// The full mapper with its defaults over all scans. With `odometry_seed` it is also given
/// what drifting wheels measure (OdometryModel with its defaults).
[[nodiscard]] Map track_by_mapper(std::span<const SimulatedScan> scans,
                                  std::optional<std::uint64_t> odometry_seed = {});

/// Accepted closures against the truth: wrong beyond 0.3 m (along the axes that they bind) or 5
/// deg.
struct ClosureCounts {
  std::size_t num_accepted = 0;
  std::size_t num_wrong = 0;
  std::size_t num_wrong_heavy = 0;  ///< Of those: with a weight above 0.3 in the final graph.

  ClosureCounts& operator+=(const ClosureCounts& other);
};

/// A map against the truth, robot's pose at every scan.
struct MapErrors {
  // The first pose laid onto the truth, its heading included.
  double first_mean_m = 0.0;   ///< Mean distance of all poses.
  double first_final_m = 0.0;  ///< Of the last one.
  // The best rigid motion laid onto the truth (ATE).
  double mean_m = 0.0;
  double highest_m = 0.0;
  double heading_mean_rad = 0.0;
  double heading_highest_rad = 0.0;

  std::size_t num_pieces = 0;
  std::size_t num_unjoined = 0;  ///< Pieces of track whose place in the map is unknown.
  std::size_t num_lost = 0;      ///< Scans that tracking did not place.
  ClosureCounts closures = {};
};

/// `truth`: T_map_base, one per scan of the track, of which there is at least one.
[[nodiscard]] MapErrors map_errors(const Map& track, std::span<const Pose2> truth);

}  // namespace setsquare::experiments
