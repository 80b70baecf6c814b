// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from paper_matcher, which shows it: one section of the paper, one file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/paper/profile_correlation.hpp"
#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// A thinned scan seen along its dominant direction theta (x') and along theta + 90 deg (y').
struct ProjectedScan {
  double theta_rad = 0.0;      ///< The dominant direction, in rad.
  std::vector<double> x_m;     ///< x' of every point, eq. (4) at theta.
  std::vector<double> y_m;     ///< y' of every point, eq. (4) at theta + 90 deg.
  ProjectedProfile profile_x;  ///< Of x', by which the profiles are correlated.
  ProjectedProfile profile_y;  ///< Of y'.
};

/// Projects the points once for any number of matches.
[[nodiscard]] ProjectedScan project_scan(const PointSet& points,
                                         double theta_rad,
                                         const ProfileBins& bins);

/// One axis' search at one offset.
struct AxisSearch {
  /// Eq. (10), one per lag from -max_lag() to max_lag(); empty where the offset was not tried.
  std::vector<std::int32_t> correlation;
  std::size_t peak = 0;  ///< Index of the chosen lag.

  /// 0 where the offset was not tried.
  [[nodiscard]] std::int32_t peak_value() const {
    return correlation.empty() ? 0 : correlation[peak];
  }
};

/// What Algorithm 3 saw at theta_offset = offset * 90 deg.
struct OffsetSearch {
  AxisSearch x;  ///< Along x'.
  AxisSearch y;  ///< Along y'.

  /// E of Algorithm 3: the product of the two axes' largest correlations.
  [[nodiscard]] std::int64_t product() const {
    return std::int64_t{x.peak_value()} * y.peak_value();
  }
};

/// What Algorithm 3 finds.
struct RelativePose {
  Pose2 T_reference_current;  ///< Of the sensors.
  std::size_t offset = 0;     ///< theta_offset = offset * 90 deg.
  double zncc_x = 0.0;        ///< ZNCC of the profiles along x' at the chosen shift.
  double zncc_y = 0.0;        ///< The same along y'.
};

/// Algorithm 3's view of a match, for pictures and tests: the four offsets, in turn.
using RelativePoseTrace = std::array<OffsetSearch, 4>;

/// GetRelativePose of the paper, Algorithm 3: (1) for each offset of 0, 90, 180 and 270 deg
/// correlate the profiles along x' and along y' for every shift, eqs. (9) and (10); (2) keep the
/// offset whose two largest correlations have the largest product; (3) turn the two shifts into
/// the reference's frame, eq. (8). Offsets whose rotation exceeds `max_rotation_rad` either way are
/// not tried; at half a turn, as in the paper, all are. Nothing where no offset correlates on both
/// axes.
[[nodiscard]] std::optional<RelativePose> relative_pose(const ProjectedScan& reference,
                                                        const ProjectedScan& current,
                                                        const ShiftSearch& search,
                                                        double max_rotation_rad = kPi,
                                                        RelativePoseTrace* trace = nullptr);

}  // namespace setsquare
