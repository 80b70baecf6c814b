// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A scan where it was taken. The scan is the caller's and must outlive this. A separate
/// header, so that users of a map need not include the rest of the grid.
struct PlacedScan {
  const Scan* scan = nullptr;  ///< Not null.
  Pose2 T_map_sensor;          ///< Where its sensor was in the map frame.
  std::size_t recency = 0;     ///< Of its session (MapSession): higher is newer.
};

}  // namespace setsquare
