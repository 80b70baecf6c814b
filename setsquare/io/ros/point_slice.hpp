// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

#include "setsquare/io/ros/messages.hpp"
#include "setsquare/io/ros/sensor_points.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::ros {

/// Which points of a cloud make a scan.
enum class SliceKind : std::uint8_t {
  kAuto,     ///< kPlane where the first cloud is flat, else kHeights within 0.3 m of the sensor's.
  kPlane,    ///< All of them: a 2-D scanner's.
  kRing,     ///< Those of one beam of a scanner of many.
  kHeights,  ///< Those between two heights: walls and obstacles, not the floor.
};

struct SliceParams {
  SliceKind kind = SliceKind::kAuto;
  std::int32_t ring = 0;  ///< kRing: the value of the field "ring" or "channel".
  double low_m = 0.2;     ///< kHeights: above the origin of the base frame.
  double high_m = 1.5;    ///< kHeights: above the origin of the base frame.
  /// From a beam of the scan to the next. By default that of the sensor (kPlane, kRing: what lies
  /// between neighbouring points of the first cloud, 0.05 to 2 degrees), or half a degree.
  std::optional<double> bin_width_rad = {};

  /// Throws ParameterError naming the field that is out of its domain.
  void validate() const;
};

/// Makes point clouds of one sensor into scans of one geometry.
///
/// Points are seen in a frame at the sensor whose axes are those of the base, so that a tilted or
/// hanging sensor needs no more care: the scan's mounting is the sensor's position without a
/// rotation. Bearings go once around in bins; a bin's range is the horizontal distance of its
/// nearest point, so that a low obstacle in front of a wall is not lost. A bin without a point
/// gives NaN, which tells nothing: a cloud does not say whether a beam saw nothing or was not sent.
class PointSlicer {
 public:
  /// Throws ParameterError.
  explicit PointSlicer(const SliceParams& params);

  /// Fills a scan, its stamp and mounting included. The result is empty, or says why there is no
  /// scan: what is wrong with the message, a cloud without a point in the slice, no ring.
  [[nodiscard]] std::string_view slice(const PointCloud2& message,
                                       const Eigen::Isometry3d& T_base_sensor,
                                       Scan& scan);

  /// What kAuto chose; kAuto before the first cloud.
  [[nodiscard]] SliceKind kind() const { return params_.kind; }

 private:
  struct PolarPoint {
    double bearing_rad = 0.0;
    double range_m = 0.0;
  };

  void settle_kind(double sensor_height_m);
  void select(const Eigen::Isometry3d& T_base_sensor);
  void settle_bins();
  [[nodiscard]] double median_gap_rad() const;
  [[nodiscard]] std::optional<std::size_t> bin_of(double bearing_rad) const;

  SliceParams params_;
  SensorPoints points_;
  std::vector<PolarPoint> selected_;  ///< Of the current cloud, in the level frame.
  std::size_t num_bins_ = 0;          ///< 0 until the first cloud settles the bins.
  double first_bearing_rad_ = 0.0;
  double bin_width_rad_ = 0.0;
};

}  // namespace setsquare::ros
