// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/relative_pose.hpp"

#include <cmath>
#include <utility>

#include "setsquare/paper/zncc.hpp"

namespace setsquare {
namespace {

/// Far below the lattice of directions: at a limit of 45 deg some offset always passes.
constexpr double kAngleRounding_rad = 1e-9;

/// Coordinates of a scan along both axes once its theta is raised by an offset.
struct TurnedCoordinates {
  std::vector<double> x_m;
  std::vector<double> y_m;
};

std::vector<double> negated(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

double theta_at_offset(const ProjectedScan& scan, std::size_t offset) {
  return scan.theta_rad + static_cast<double>(offset) * 0.5 * kPi;
}

/// Eq. (4) at theta + 90 deg of x' is y', and of y' is -x'.
TurnedCoordinates turned_by_offset(const ProjectedScan& scan, std::size_t offset) {
  switch (offset) {
    case 0:
      return {scan.x_m, scan.y_m};
    case 1:
      return {scan.y_m, negated(scan.x_m)};
    case 2:
      return {negated(scan.x_m), negated(scan.y_m)};
    default:
      return {negated(scan.y_m), scan.x_m};
  }
}

AxisSearch search_axis(const ProjectedProfile& reference,
                       const std::vector<double>& current_m,
                       const ShiftSearch& search) {
  AxisSearch axis{correlate(reference, current_m, search), 0};
  axis.peak = first_peak(axis.correlation);
  return axis;
}

/// ZNCC of the reference's profile and the current one moved by the shift, eq. (9).
double zncc_at(const ProjectedProfile& reference,
               const std::vector<double>& current_m,
               double shift_m) {
  const ProjectedProfile moved = profile_of_coordinates(current_m, reference.bins, shift_m);
  return zncc(reference.counts, moved.counts);
}

/// Eq. (8). The axes of eq. (4) are x' = (sin theta, cos theta) and y' = (cos theta, -sin theta)
/// of the reference's frame, so the rotation printed in the paper becomes this one.
Pose2 pose_from_shifts(double theta_reference_rad,
                       double theta_current_rad,
                       double shift_x_m,
                       double shift_y_m) {
  const double s = std::sin(theta_reference_rad);
  const double c = std::cos(theta_reference_rad);
  return {shift_x_m * s + shift_y_m * c,
          shift_x_m * c - shift_y_m * s,
          wrap_to_pi(theta_current_rad - theta_reference_rad)};
}

}  // namespace

ProjectedScan project_scan(const PointSet& points, double theta_rad, const ProfileBins& bins) {
  ProjectedScan scan;
  scan.theta_rad = theta_rad;
  scan.x_m = project(points, theta_rad);
  scan.y_m = project(points, theta_rad + 0.5 * kPi);
  scan.profile_x = profile_of_coordinates(scan.x_m, bins);
  scan.profile_y = profile_of_coordinates(scan.y_m, bins);
  return scan;
}

std::optional<RelativePose> relative_pose(const ProjectedScan& reference,
                                          const ProjectedScan& current,
                                          const ShiftSearch& search,
                                          double max_rotation_rad,
                                          RelativePoseTrace* trace) {
  RelativePoseTrace searches;
  std::int64_t best_product = 0;  // E_max of Algorithm 3.
  std::size_t best = 0;
  for (std::size_t offset = 0; offset < searches.size(); ++offset) {
    const double rotation_rad =
        wrap_to_pi(theta_at_offset(current, offset) - reference.theta_rad);  // Eq. (8)
    if (std::abs(rotation_rad) > max_rotation_rad + kAngleRounding_rad) continue;
    const TurnedCoordinates turned = turned_by_offset(current, offset);
    searches[offset].x = search_axis(reference.profile_x, turned.x_m, search);
    searches[offset].y = search_axis(reference.profile_y, turned.y_m, search);
    if (searches[offset].product() > best_product) {
      best_product = searches[offset].product();
      best = offset;
    }
  }
  std::optional<RelativePose> result;
  if (best_product > 0) {
    const double shift_x_m = search.shift_m(searches[best].x.peak);
    const double shift_y_m = search.shift_m(searches[best].y.peak);
    const double theta_current_rad = theta_at_offset(current, best);
    const TurnedCoordinates turned = turned_by_offset(current, best);
    result = {pose_from_shifts(reference.theta_rad, theta_current_rad, shift_x_m, shift_y_m),
              best,
              zncc_at(reference.profile_x, turned.x_m, shift_x_m),
              zncc_at(reference.profile_y, turned.y_m, shift_y_m)};
  }
  if (trace != nullptr) *trace = std::move(searches);
  return result;
}

}  // namespace setsquare
