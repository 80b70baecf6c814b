// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/story/scan.hpp"

#include <cmath>

#include "setsquare/drawing/text.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare {

StoryScan story_scan(const Scan& scan, const PaperParams& params) {
  StoryScan story;
  story.scan = scan;
  story.points = points_from_scan(scan);
  story.thinned = thin(story.points, params.min_spacing_m);
  const auto num_directions =
      static_cast<std::size_t>(std::lround(kPi / params.direction_step_rad));
  story.directions = {0.0, params.direction_step_rad, num_directions};
  story.moments = direction_curve(story.thinned, story.directions, params.bins());
  story.dominant = dominant_direction(story.thinned, params.direction());
  const double theta_rad = story.dominant.theta_rad;
  story.along = projected_profile(story.thinned, theta_rad, params.bins());
  story.across = projected_profile(story.thinned, theta_rad + 0.5 * kPi, params.bins());
  story.off = projected_profile(story.thinned, theta_rad + kOffDirection_rad, params.bins());
  return story;
}

AxisShifts shifts_of_pose(const Pose2& T_reference_current, double theta_reference_rad) {
  // x' = (sin theta, cos theta), y' = (cos theta, -sin theta) in the reference's frame, eq. (4).
  const double s = std::sin(theta_reference_rad);
  const double c = std::cos(theta_reference_rad);
  return {T_reference_current.x_m * s + T_reference_current.y_m * c,
          T_reference_current.x_m * c - T_reference_current.y_m * s};
}

StoryRotation story_rotation(const StoryScan& reference,
                             const StoryScan& current,
                             const Pose2& T_reference_current,
                             const ShiftSearch& search) {
  const double theta_reference_rad = reference.dominant.theta_rad;
  const double theta_current_rad = theta_reference_rad + T_reference_current.theta_rad;  // Eq. (8)
  const AxisShifts shifts = shifts_of_pose(T_reference_current, theta_reference_rad);
  StoryRotation rotation;
  rotation.rotation_rad = T_reference_current.theta_rad;
  rotation.label =
      joined({"rotation ", fixed(deg_from_rad(T_reference_current.theta_rad), 1), " deg"});
  rotation.along = correlate(reference.along, project(current.thinned, theta_current_rad), search);
  rotation.across =
      correlate(reference.across, project(current.thinned, theta_current_rad + 0.5 * kPi), search);
  rotation.shift_along_m = shifts.along_m;
  rotation.shift_across_m = shifts.across_m;
  return rotation;
}

}  // namespace setsquare
