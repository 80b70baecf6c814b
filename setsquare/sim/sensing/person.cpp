// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/person.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kLegRadius_m = 0.06;
constexpr double kHalfStance_m = 0.10;  // From the middle of the body to a leg, sideways.
constexpr double kSwing_m = 0.25;       // Of a foot before and behind the body.
constexpr double kStride_m = 1.3;       // Two steps: the swing's period.

/// Way walked since `from_m`, there and back, in [0, 2 length).
double way_m(const Person& person, double length_m, double time_s) {
  const double lap_m = 2.0 * length_m;
  const double walked_m = person.speed_m_per_s * (time_s - person.phase_s);
  return walked_m - lap_m * std::floor(walked_m / lap_m);
}

void add_legs(const Person& person, double time_s, std::vector<Disc>& legs) {
  const Eigen::Vector2d way = person.to_m - person.from_m;
  const double length_m = way.norm();
  Eigen::Vector2d along(std::cos(person.phase_s), std::sin(person.phase_s));
  Eigen::Vector2d middle_m = person.from_m;
  double swing_m = 0.0;
  if (length_m > 0.0 && person.speed_m_per_s > 0.0) {
    const double walked_m = way_m(person, length_m, time_s);
    along = way / length_m;
    middle_m += along * (walked_m < length_m ? walked_m : 2.0 * length_m - walked_m);
    // The sine of the way back mirrors that of the way there: no leg jumps where the lap ends.
    const double from_start_m = walked_m < length_m ? walked_m : walked_m - 2.0 * length_m;
    swing_m = kSwing_m * std::sin(kTwoPi * std::abs(from_start_m) / kStride_m);
  }
  const Eigen::Vector2d sideways(-along.y(), along.x());
  const Eigen::Vector2d to_leg = kHalfStance_m * sideways + swing_m * along;
  legs.push_back({middle_m + to_leg, kLegRadius_m});
  legs.push_back({middle_m - to_leg, kLegRadius_m});
}

}  // namespace

std::vector<Disc> legs_at(const std::vector<Person>& people, double time_s) {
  std::vector<Disc> legs;
  legs.reserve(2 * people.size());
  for (const Person& person : people) add_legs(person, time_s, legs);
  return legs;
}

}  // namespace setsquare
