// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/localisation/expected_scan.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localisation_params.hpp"
#include "setsquare/matching/probability.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// A scan as it is searched for in a map.
struct SoughtScan {
  PreparedScan prepared;
  SurfaceSamples proposing;  ///< A few dozen, rare directions favoured.
  BeamLayout beams;
};

/// Throws ParameterError where the scan's geometry is not valid (Scan::validate).
[[nodiscard]] SoughtScan sought_scan(const Scan& scan);

/// A place compared with the scan that is to be expected there.
struct VerifiedPlace {
  Pose2 T_grid_sensor;
  double fit = 0.0;  ///< Of its samples on the walls, free space not looked at: -1 to 1.
  ProbabilityEvidence evidence;  ///< Without a margin.
  TwoWayKinds kinds;
  double score = 0.0;            ///< Of the matcher (score()).
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< In the grid's frame.
};

/// Places near enough to be one answer.
[[nodiscard]] bool is_one_place(const Pose2& a, const Pose2& b);

/// The best places of the whole map, all different, best first:
///
/// 1. every translation is correlated at each rotation (MapCorrelation);
/// 2. the best are moved onto the walls by the distance to them, and compared;
/// 3. the best different ones are verified against the scan that is to be expected there, free
///    space and all, and refined.
[[nodiscard]] std::vector<VerifiedPlace> search_places(const KnownMap& map,
                                                       const SoughtScan& scan,
                                                       std::span<const double> rotations_rad,
                                                       const PlaceSearchParams& params);

/// D.
[[nodiscard]] double fit_at_place(const KnownMap& map, const SoughtScan& scan, const Pose2& T);

/// Step 3 alone, of a place that is right within some decimetres and degrees.
[[nodiscard]] VerifiedPlace verified_place(const KnownMap& map,
                                           const SoughtScan& scan,
                                           const Pose2& T_grid_sensor);

}  // namespace setsquare
