// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/surface_params.hpp"

namespace setsquare {

/// From a scan's first beam to its last, in s, by its time_increment_s; negative where the beams
/// were measured last to first, 0 where the scan does not say.
[[nodiscard]] double sweep_time_s(const Scan& scan);

/// Where a beam was measured in its sweep: -1 the first of the array, 0 the middle, 1 the last.
[[nodiscard]] double sweep_share(std::size_t beam, std::size_t num_beams);

/// How the sensor moved while it swept. It drives evenly, and turns evenly within each half.
struct SweepMotion {
  /// From the middle of the sweep to the last beam, along the arc; x ahead of the sensor.
  Eigen::Vector2d way_m = Eigen::Vector2d::Zero();
  double turn_before_rad = 0.0;  ///< From the first beam to the middle.
  double turn_after_rad = 0.0;   ///< From the middle to the last beam.

  /// T_middle_sensor: where the sensor was at a share of the sweep, seen from its middle.
  [[nodiscard]] Pose2 pose_at(double share) const;
  [[nodiscard]] double turn_at(double share) const {
    return share * (share < 0.0 ? turn_before_rad : turn_after_rad);
  }
  [[nodiscard]] bool is_rest() const {
    return way_m.isZero(0.0) && turn_before_rad == 0.0 && turn_after_rad == 0.0;
  }
};

/// The motion during a sweep of a sensor that goes on as it moved from one pose to the next:
/// `T_from_to` in `elapsed_s`. Rest where the times are not positive.
[[nodiscard]] SweepMotion even_motion(const Pose2& T_from_to, double elapsed_s, double sweep_s);

/// By how much the turn of either half differs, at most.
[[nodiscard]] double change_rad(const SweepMotion& a, const SweepMotion& b);

/// A scan as if all its beams had been measured at once.
struct DeskewedScan {
  Scan scan;
  std::vector<float> share;  ///< sweep_share() of the beam that each beam's range is of.
};

/// The scan that the sensor would have measured had it stood still where it was in the *middle* of
/// its sweep, which is the pose that the scan as a whole shows best: so an error of the motion
/// turns and moves nothing but the ends of the sweep. Its stamp stays that of the first beam.
///
/// 1. Each return is taken to the middle; the beams are then no longer evenly spread.
/// 2. Between two returns of one surface (surface_points_from_scan) lies a straight piece of wall,
///    and the ranges of the beams between are those to it. Elsewhere the nearer beam counts.
/// 3. What is seen twice, because the sensor turned on while it swept all around, is taken from the
///    beam nearer to the middle; what nothing saw is no measurement (NaN).
///
/// Without motion the scan stays as it is, to the last bit.
[[nodiscard]] DeskewedScan deskewed(const Scan& scan,
                                    const SweepMotion& motion,
                                    const SurfaceParams& surfaces = {});

}  // namespace setsquare
