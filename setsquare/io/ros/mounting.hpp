// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::ros {

/// How a scanner sits on the robot, seen from above.
///
/// A scanner upside down (a roll of 180 degrees) whose beams run counterclockwise in its own frame
/// runs clockwise seen from above: bearings change their sign, the order of the beams stays.
///
/// Of a tilted scanner each return is projected onto the plane, which is right for walls that stand
/// upright: its range becomes the horizontal distance, and its bearing the horizontal one. Since a
/// scan's bearings are evenly spaced, each beam of the projected scan takes the beam of the tilted
/// one that points most nearly its way, or tells nothing where none does. At a tilt of 10 degrees
/// ranges shrink by up to 1.5 % and beams move by up to 0.4 degrees; at 30 degrees by 13 % and 4
/// degrees, and such a scanner sees the floor or the ceiling rather than walls.
struct Mounting {
  /// Below it a tilt is left alone: it changes ranges by less than 0.004 %.
  static constexpr double kLevel_deg = 0.5;
  /// Above it a tilt deserves a remark.
  static constexpr double kNotable_deg = 3.0;
  /// Above it there is no scan of the plane.
  static constexpr double kMaxTilt_deg = 30.0;

  Pose2 T_base_sensor;  ///< Of the sensor's frame turned level.
  bool is_upside_down = false;
  double tilt_deg = 0.0;  ///< Between the scan's plane and the robot's.
  /// From a direction in the scan's plane, y turned round where upside down, to its horizontal part
  /// in the level frame.
  Eigen::Matrix2d projection = Eigen::Matrix2d::Identity();

  [[nodiscard]] bool is_level() const { return tilt_deg < kLevel_deg; }
  [[nodiscard]] bool is_horizontal() const { return tilt_deg <= kMaxTilt_deg; }

  /// Why the mounting deserves a word, one sentence: not horizontal, tilted, upside down. Empty for
  /// an upright level scanner.
  [[nodiscard]] std::string remark() const;
};

/// The mounting of a sensor whose pose on the robot is known in space.
[[nodiscard]] Mounting mounting_from_transform(const Eigen::Isometry3d& T_base_sensor);

/// Where a robot is in the plane: its position and its heading, tilt left out.
[[nodiscard]] Pose2 planar_pose(const Eigen::Isometry3d& T_odom_base);

/// Puts mountings on scans of one sensor; keeps what it worked out as long as the geometry stays.
class MountedScans {
 public:
  /// Gives the scan its mounting, and turns or projects its beams as the mounting demands. The
  /// mounting is horizontal. Outcomes of beams stay what they were.
  void mount(const Mounting& mounting, Scan& scan);

 private:
  /// Which beam of the tilted scan a beam of the projected one takes, if any points its way, and
  /// its range's factor.
  struct Source {
    std::size_t beam = 0;
    double scale = 1.0;
  };

  [[nodiscard]] static double projected_range_m(const Scan& scan, const Source& source);
  void find_sources(const Mounting& mounting, const Scan& scan);

  Eigen::Matrix2d projection_ = Eigen::Matrix2d::Zero();
  double first_bearing_rad_ = 0.0;
  double bearing_step_rad_ = 0.0;
  std::vector<Source> sources_;
  std::vector<double> ranges_m_;
};

}  // namespace setsquare::ros
