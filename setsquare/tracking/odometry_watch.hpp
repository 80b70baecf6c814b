// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Whether poses that come with scans as odometry are odometry.
///
/// A converter that has none writes zeros, a robot whose wheel counter hangs repeats its last pose:
/// believed, they pull every scan back to one place. And one corrupt message puts the robot on
/// another planet.
class OdometryWatch {
 public:
  /// The pose, or nothing where it is no odometry: beyond 10 000 km, or the same to the last digit
  /// for ten scans or more while half of what the scans see has changed. A counter that has hung
  /// once is not given ten scans again.
  [[nodiscard]] std::optional<Pose2> believed(const Scan& scan,
                                              const std::optional<Pose2>& T_wheels_base);

  /// Scans whose poses were no odometry.
  [[nodiscard]] std::size_t num_ignored() const { return num_ignored_; }

 private:
  /// The scan with which the odometry came to rest.
  struct Rest {
    Scan scan;
    Pose2 T_wheels_base;
    std::size_t num_scans = 0;
    bool is_moved = false;
  };

  std::optional<Rest> rest_;
  bool has_hung_ = false;
  std::size_t num_ignored_ = 0;
};

}  // namespace setsquare
