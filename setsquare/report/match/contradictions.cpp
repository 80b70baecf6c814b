// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/contradictions.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kClearance_m = 0.3;

bool returns_from_behind(const Scan& scan, double beam, double distance_m) {
  if (beam < 0.0 || beam >= static_cast<double>(scan.num_beams())) return false;
  const auto index = static_cast<std::size_t>(beam);
  return scan.outcome(index) == BeamOutcome::kReturn &&
         scan.ranges_m[index] > distance_m + kClearance_m;
}

}  // namespace

std::vector<Eigen::Vector2d> contradictions(const Scan& observing,
                                            const PointSet& points,
                                            const Pose2& T_observing_points) {
  std::vector<Eigen::Vector2d> contradicted;
  if (observing.num_beams() < 3) return contradicted;
  const double middle_rad =
      observing.first_bearing_rad +
      0.5 * observing.bearing_step_rad * static_cast<double>(observing.num_beams() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d place =
        T_observing_points * Eigen::Vector2d(points.x_m[i], points.y_m[i]);
    const double from_middle_rad = wrap_to_pi(std::atan2(place.y(), place.x()) - middle_rad);
    const double bearing_rad = middle_rad + from_middle_rad;
    const double beam =
        std::round((bearing_rad - observing.first_bearing_rad) / observing.bearing_step_rad);
    const double distance_m = place.norm();
    if (returns_from_behind(observing, beam - 1.0, distance_m) &&
        returns_from_behind(observing, beam, distance_m) &&
        returns_from_behind(observing, beam + 1.0, distance_m)) {
      contradicted.push_back(place);
    }
  }
  return contradicted;
}

}  // namespace setsquare
