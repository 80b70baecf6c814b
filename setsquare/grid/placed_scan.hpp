// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A scan where it was taken. The scan is the caller's and must outlive this. A header of its own:
/// who has a map needs it without the parameters of the grid.
struct PlacedScan {
  const Scan* scan = nullptr;
  Pose2 T_map_sensor;
};

}  // namespace setsquare
