// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// The odometry's last poses, to be asked for the pose at a scan's stamp. It holds kMaxAge_s of
/// them, and not more than kMaxPoses.
class PoseHistory {
 public:
  static constexpr double kMaxAge_s = 30.0;
  static constexpr std::size_t kMaxPoses = 20000;
  /// Between poses that are further apart nothing is interpolated, and beyond the outermost ones
  /// the nearest is taken for no longer than half of it.
  static constexpr double kMaxGap_s = 1.0;

  /// Poses come nearly in the order of their stamps: one that is a little older is put in its
  /// place, and of two of the same stamp the later one counts. One that is more than kMaxGap_s
  /// older than the newest begins the history again: the clock has jumped.
  void add(Timestamp stamp, const Pose2& T_odom_base);

  /// The pose at a moment, interpolated between its neighbours: the position on the line between
  /// them, the heading along the shorter turn. Nothing where no pose is near enough in time.
  [[nodiscard]] std::optional<Pose2> at(Timestamp stamp) const;

  /// Whether a later pose can no longer change what at() gives.
  [[nodiscard]] bool reaches(Timestamp stamp) const {
    return !poses_.empty() && poses_.back().stamp >= stamp;
  }
  [[nodiscard]] bool empty() const { return poses_.empty(); }

 private:
  struct Stamped {
    Timestamp stamp;
    Pose2 T_odom_base;
  };
  std::deque<Stamped> poses_;
};

}  // namespace setsquare
