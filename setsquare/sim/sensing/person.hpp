// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace setsquare {

/// A person who stands (from = to) or walks to and fro along a straight line. Times in s since the
/// start of the run.
struct Person {
  Eigen::Vector2d from_m;
  Eigen::Vector2d to_m;
  double speed_m_per_s = 1.2;
  double phase_s = 0.0;  ///< At this time the person is at `from_m`, leaving it.
};

/// A leg at scanner height, or anything round that moves.
struct Disc {
  Eigen::Vector2d center_m;
  double radius_m = 0.0;
};

/// Two legs per person, at a given time: 12 cm thick and 20 cm apart; they swing while the person
/// walks. Continuous in time. A standing person faces the direction of `phase_s` taken as an angle
/// in rad.
[[nodiscard]] std::vector<Disc> legs_at(const std::vector<Person>& people, double time_s);

}  // namespace setsquare
