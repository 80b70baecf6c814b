// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/localisation/localisation_params.hpp"
#include "setsquare/localisation/localisation_status.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

class KnownMap;  // setsquare/localisation/known_map.hpp

/// A place where a scan may have been taken.
struct PossiblePlace {
  Pose2 T_map_sensor;        ///< Of the sensor there.
  double probability = 0.0;  ///< That it was taken there.
  /// Of (x, y, theta) in the map frame, in m^2, m rad, rad^2, if it is this place. Along a
  /// direction that the walls leave open it is as wide as the search was.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Where a scan was taken.
struct LocatedScan {
  LocalisationStatus status =
      LocalisationStatus::kLost;      ///< By the most probable place and by all.
  std::vector<PossiblePlace> places;  ///< The most probable first; the rest is "elsewhere".
};

/// Localised where the most probable place reaches its threshold, ambiguous where all together
/// (`in_map`) reach params.min_in_map.
[[nodiscard]] LocalisationStatus status_of(double best,
                                           double min_probability,
                                           double in_map,
                                           const LocalisationParams& params);

/// Where in a map a scan was taken, of which nothing is known: the whole map is searched
/// (PlaceSearch), at every rotation. Where no place is certain it is searched again, wider, and the
/// places are compared with what the map's own scans saw about them, where it has any
/// (KnownMap::views). Throws ParameterError where the scan's geometry is not valid
/// (Scan::validate).
[[nodiscard]] LocatedScan locate_scan(const KnownMap& map,
                                      const Scan& scan,
                                      const LocalisationParams& params = {});

}  // namespace setsquare
