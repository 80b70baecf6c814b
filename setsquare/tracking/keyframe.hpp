// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// A scan kept, with its pose by tracking. Never changed once it is made, so that the tracker and
/// the mapper share it.
struct Keyframe {
  std::size_t scan_index = 0;
  Pose2 T_odom_sensor;
  Pose2 T_odom_body;                 ///< See BodyMounting.
  std::shared_ptr<const Scan> scan;  ///< Shared with the map, which outlives the surfaces.
  ScanSurfacesPtr surfaces;          ///< Of the scan, as tracking made them.

  [[nodiscard]] const SurfacePoints& points() const { return surfaces->points; }
  [[nodiscard]] const SurfaceImage& image() const { return surfaces->image; }
};

using KeyframePtr = std::shared_ptr<const Keyframe>;

/// What one scan of a submap saw, and where it stands in the submap's frame. The image is not
/// owned and must outlive this.
struct PlacedImage {
  const SurfaceImage* image = nullptr;
  Pose2 T_submap_sensor;
};

}  // namespace setsquare
