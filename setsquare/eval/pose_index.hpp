// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {

/// Stamps of one scan in two files differ by their rounding, in ns: relations and trajectories keep
/// five or six decimals of a second.
inline constexpr std::int64_t kSameStamp_ns = 12'000;

/// The poses of a trajectory by their stamps; the trajectory's order does not matter.
class PoseIndex {
 public:
  explicit PoseIndex(const Trajectory& trajectory);

  /// The pose nearest in time, at most `tolerance_ns` away; of two equally near the earlier, of two
  /// at one stamp the first in the trajectory. Nothing where there is none.
  [[nodiscard]] std::optional<StampedPose> find(Timestamp stamp,
                                                std::int64_t tolerance_ns = kSameStamp_ns) const;

  /// All poses, earliest first.
  [[nodiscard]] std::span<const StampedPose> poses() const { return poses_; }

 private:
  Trajectory poses_;
};

}  // namespace setsquare
