// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/surface_image.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A scan kept as a part of the submap, with its pose by tracking.
struct Keyframe {
  std::size_t scan_index = 0;
  Pose2 T_odom_sensor;
  SurfaceImage image;
  Scan scan;  ///< For the guess-free matcher, should tracking get lost.
};

}  // namespace setsquare
