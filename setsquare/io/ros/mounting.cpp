// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/mounting.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"

namespace setsquare::ros {
namespace {

/// The turn in the plane nearest to a 2 x 2 matrix (its polar decomposition's).
double nearest_turn_rad(const Eigen::Matrix2d& m) {
  return std::atan2(m(1, 0) - m(0, 1), m(0, 0) + m(1, 1));
}

Eigen::Vector2d direction(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

constexpr std::size_t kNoBeam = std::numeric_limits<std::size_t>::max();

/// The beam that points most nearly this way, at most half a beam off; kNoBeam where there is none.
std::size_t nearest_beam(const Scan& scan, double bearing_rad) {
  if (scan.num_beams() < 2) return scan.num_beams() == 1 ? 0 : kNoBeam;
  const double from_middle_rad =
      wrap_to_pi(bearing_rad - scan.first_bearing_rad -
                 0.5 * static_cast<double>(scan.num_beams() - 1) * scan.bearing_step_rad);
  const double nearest = std::round(from_middle_rad / scan.bearing_step_rad +
                                    0.5 * static_cast<double>(scan.num_beams() - 1));
  const bool is_in_scan = nearest >= 0.0 && nearest < static_cast<double>(scan.num_beams());
  return is_in_scan ? static_cast<std::size_t>(nearest) : kNoBeam;
}

}  // namespace

Mounting mounting_from_transform(const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Matrix3d rotation = T_base_sensor.linear();
  Mounting mounting;
  mounting.is_upside_down = rotation(2, 2) < 0.0;
  const double tilt_rad = std::atan2(rotation.col(2).head<2>().norm(), std::abs(rotation(2, 2)));
  mounting.tilt_deg = deg_from_rad(tilt_rad);
  Eigen::Matrix2d horizontal = rotation.topLeftCorner<2, 2>();
  if (mounting.is_upside_down) horizontal.col(1) = -horizontal.col(1);
  const double yaw_rad = nearest_turn_rad(horizontal);
  const Eigen::Vector3d position_m = T_base_sensor.translation();
  mounting.T_base_sensor = {position_m.x(), position_m.y(), wrap_to_pi(yaw_rad)};
  mounting.projection = rotation_matrix(-yaw_rad) * horizontal;
  return mounting;
}

Pose2 planar_pose(const Eigen::Isometry3d& T_odom_base) {
  const Eigen::Vector3d position_m = T_odom_base.translation();
  const Eigen::Matrix2d horizontal = T_odom_base.linear().topLeftCorner<2, 2>();
  return {position_m.x(), position_m.y(), wrap_to_pi(nearest_turn_rad(horizontal))};
}

std::string Mounting::remark() const {
  if (!is_horizontal()) {
    return fmt::format("the scanner is not horizontal: its plane is tilted by {:.0f} degrees",
                       tilt_deg);
  }
  const char* place = is_upside_down ? "the scanner hangs upside down" : "";
  if (tilt_deg < kNotable_deg) return place;
  return fmt::format("{} tilted by {:.1f} degrees, its returns are projected onto the plane",
                     is_upside_down ? "the scanner hangs upside down and" : "the scanner is",
                     tilt_deg);
}

void MountedScans::mount(const Mounting& mounting, Scan& scan) {
  scan.T_base_sensor = mounting.T_base_sensor;
  if (mounting.is_upside_down) {
    scan.first_bearing_rad = -scan.first_bearing_rad;
    scan.bearing_step_rad = -scan.bearing_step_rad;
  }
  if (mounting.is_level()) return;
  find_sources(mounting, scan);
  ranges_m_.resize(scan.num_beams());
  for (std::size_t beam = 0; beam < sources_.size(); ++beam) {
    ranges_m_[beam] = projected_range_m(scan, sources_[beam]);
  }
  scan.ranges_m.swap(ranges_m_);
  scan.min_range_m *= std::cos(rad_from_deg(mounting.tilt_deg));  // No return falls below it.
}

double MountedScans::projected_range_m(const Scan& scan, const Source& source) {
  if (source.beam == kNoBeam) return std::numeric_limits<double>::quiet_NaN();
  const double range_m = scan.ranges_m[source.beam];
  return scan.outcome(source.beam) == BeamOutcome::kReturn ? range_m * source.scale : range_m;
}

void MountedScans::find_sources(const Mounting& mounting, const Scan& scan) {
  if (mounting.projection == projection_ && scan.first_bearing_rad == first_bearing_rad_ &&
      scan.bearing_step_rad == bearing_step_rad_ && scan.num_beams() == sources_.size()) {
    return;
  }
  projection_ = mounting.projection;
  first_bearing_rad_ = scan.first_bearing_rad;
  bearing_step_rad_ = scan.bearing_step_rad;
  sources_.assign(scan.num_beams(), {});
  const Eigen::Matrix2d to_tilted = projection_.inverse();
  for (std::size_t beam = 0; beam < sources_.size(); ++beam) {
    const Eigen::Vector2d tilted = to_tilted * direction(scan.bearing_rad(beam));
    Source& source = sources_[beam];
    source.beam = nearest_beam(scan, std::atan2(tilted.y(), tilted.x()));
    if (source.beam == kNoBeam) continue;
    source.scale = (projection_ * direction(scan.bearing_rad(source.beam))).norm();
  }
}

}  // namespace setsquare::ros
