// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/localisation/localisation_params.hpp"
#include "setsquare/localisation/locate_scan.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

class KnownMap;  // setsquare/localisation/known_map.hpp

/// Where the robot is at one scan.
struct LocalisedPose {
  Timestamp stamp;                                        ///< Of the scan.
  LocalisationStatus status = LocalisationStatus::kLost;  ///< What is known of the place.
  Pose2 T_map_sensor;  ///< Of the most probable place; without meaning where no place is known.
  Pose2 T_map_base;    ///< The robot's pose there, by the scan's mounting.
  double probability = 0.0;  ///< Of that place.
  /// Of (x, y, theta) of the sensor in the map frame, in m^2, m rad, rad^2, if it is that place.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool is_confirmed = false;   ///< The scan was compared with the map there, and agrees.
  double unconfirmed_m = 0.0;  ///< Driven since a scan was.
  std::vector<PossiblePlace> alternatives;  ///< Other places, the most probable first.
};

/// Finds a robot in a map from its scans, whatever is known of its start, and follows it.
///
///   Localizer localizer(std::make_shared<KnownMap>(grid));
///   for (const Scan& scan : log) use(localizer.add(scan));
///
/// 1. Track: each scan is placed against the last ones (ScanTracker), so that all hypotheses move
///    alike and for nothing.
/// 2. While no place is certain, the whole map is searched (search_places), again after each bit of
///    way, and places are compared with what the map's own scans saw (KnownMap::views); every scan
///    weighs the hypotheses anew.
/// 3. Once one is certain, scans are laid onto the map there; it is searched again only where they
///    contradict the map for long (the robot was carried, or was never there).
/// Scans come in the order of time, from one scanner. Not for several threads at once; several
/// Localizers may share a map.
class Localizer {
 public:
  /// Throws ParameterError that names the field.
  explicit Localizer(std::shared_ptr<const KnownMap> map, const LocalisationParams& params = {});
  ~Localizer();
  /// What was found moves along.
  Localizer(Localizer&&) noexcept;
  /// Likewise.
  Localizer& operator=(Localizer&&) noexcept;

  /// The next scan, with the robot's pose by wheel odometry where the log has one. Throws
  /// ParameterError where the scan's geometry is not valid (Scan::validate) or a pose is not
  /// finite.
  LocalisedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);

  /// Says where the robot is at the next scan, to about 1 m and 30 deg. A wrong pose is told from a
  /// right one by the scans that follow.
  void set_pose(const Pose2& T_map_base);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace setsquare
