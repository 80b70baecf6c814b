// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "setsquare/core/finite_pose.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/isolated_returns.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// The first half of Localizer: each scan placed against the last ones, whatever the map is.
class LocalizerTracker {
 public:
  /// As Localizer::add(). Throws the same.
  TrackedPose track(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
    scan.validate();
    require_finite_pose(scan.T_base_sensor, "T_base_sensor");
    if (T_wheels_base) require_finite_pose(*T_wheels_base, "T_wheels_base");
    const std::optional<Scan> cleared = without_isolated_returns(scan);
    return tracker_.track(cleared ? *cleared : scan, T_wheels_base);
  }

  /// The last scan as it is compared with the map: straight, where it was deskewed.
  [[nodiscard]] const Scan& seen(const Scan& scan) const {
    return tracker_.deskewed_scan() ? *tracker_.deskewed_scan() : scan;
  }

 private:
  ScanTracker tracker_;
};

}  // namespace setsquare
