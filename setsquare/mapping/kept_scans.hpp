// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Chooses the scans that a map keeps whole: the keyframes, and those that moved on by 0.1 m or 5
/// degrees since the last one kept of the same scanner. Memory grows with the way driven, not with
/// the time. Shared by Mapper and PaperMapper.
class KeptScans {
 public:
  /// The next scan. `share`: gives it as a shared pointer; called only where it is kept.
  template <typename Share>
  void add(const TrackedPose& tracked, std::uint32_t scanner, const Share& share) {
    constexpr double kSpacing_m = 0.1;
    constexpr double kTurn_rad = rad_from_deg(5.0);
    const std::size_t index = num_scans_++;
    const auto [last, is_first] = T_odom_last_.try_emplace(scanner);
    if (!is_first && !tracked.is_keyframe) {
      const Pose2 moved = last->second.inverse() * tracked.T_odom_body;
      if (std::hypot(moved.x_m, moved.y_m) < kSpacing_m && std::abs(moved.theta_rad) < kTurn_rad) {
        return;
      }
    }
    last->second = tracked.T_odom_body;
    kept_.push_back({index, share()});
  }

  /// A scan that a map kept before; those of the scans before it are not kept unless they were.
  void append(std::size_t index, std::shared_ptr<const Scan> scan) {
    kept_.push_back({index, std::move(scan)});
  }

  /// The scans that come next are of another log, and begin with the one of this index.
  void begin_log(std::size_t index) {
    T_odom_last_.clear();
    num_scans_ = index;
  }

  /// Drops those of the scans from an index on.
  void forget_from(std::size_t index) { kept_.resize(num_before(index)); }

  /// Kept scans of an index less than this.
  [[nodiscard]] std::size_t num_before(std::size_t index) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(kept_, index, {}, &KeptScan::index) -
                                    kept_.begin());
  }

  [[nodiscard]] const std::vector<KeptScan>& kept() const { return kept_; }

 private:
  std::vector<KeptScan> kept_;
  std::map<std::uint32_t, Pose2> T_odom_last_;  ///< Of the body, by scanner.
  std::size_t num_scans_ = 0;
};

}  // namespace setsquare
