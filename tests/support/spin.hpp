// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::testing {

/// A robot that stands, turns on the spot by whole turns, and stands, with a cheap scanner that
/// spins: 360 beams, noise of a hundredth of the range and 15 mm at most.
struct Spin {
  double rate_hz = 7.0;
  double turn_deg_per_s = 90.0;
  double num_turns = 1.0;
  /// Of the time from scan to scan that a sweep takes; negative: the last beam comes first.
  double sweep_share = 1.0;
  bool states_sweep = true;  ///< In Scan::time_increment_s.
};

struct SpunScan {
  Scan scan;
  Pose2 T_wheels_base;    ///< By wheels that measure the truth.
  double turn_rad = 0.0;  ///< Since the first scan, in the middle of the sweep; not wrapped.
};

/// A rectangular room with five boxes, and a place in it from which they are half a metre away or
/// more.
struct SpinRoom {
  std::vector<Wall> walls;
  double x_m = 0.0;
  double y_m = 0.0;
};

inline SpinRoom spin_room(std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  SpinRoom room;
  const auto add_box = [&](double left_m, double low_m, double right_m, double high_m) {
    room.walls.insert(room.walls.end(),
                      {{left_m, low_m, right_m, low_m},
                       {right_m, low_m, right_m, high_m},
                       {right_m, high_m, left_m, high_m},
                       {left_m, high_m, left_m, low_m}});
  };
  const double width_m = draw(3.5, 7.0);
  const double depth_m = draw(3.0, 6.0);
  room.x_m = draw(0.35, 0.65) * width_m;
  room.y_m = draw(0.35, 0.65) * depth_m;
  add_box(0.0, 0.0, width_m, depth_m);
  while (room.walls.size() < 24) {
    const double x_m = draw(0.0, width_m);
    const double y_m = draw(0.0, depth_m);
    const double half_width_m = draw(0.15, 0.6);
    const double half_depth_m = draw(0.15, 0.4);
    const bool is_clear = std::abs(x_m - room.x_m) > half_width_m + 0.5 ||
                          std::abs(y_m - room.y_m) > half_depth_m + 0.5;
    if (!is_clear) continue;
    add_box(x_m - half_width_m, y_m - half_depth_m, x_m + half_width_m, y_m + half_depth_m);
  }
  return room;
}

/// The scans of a spin in a spin_room() of the seed, which decides the way around, too, and
/// when in a sweep the turn begins.
inline std::vector<SpunScan> scans_of_spin(const Spin& spin, std::uint64_t seed) {
  constexpr std::size_t kNumBeams = 360;
  constexpr double kRest_s = 1.0;
  const SpinRoom room = spin_room(seed);
  std::mt19937_64 generator(seed + 1'000'000);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 1.0);
  const double period_s = 1.0 / spin.rate_hz;
  const double sweep_s = std::abs(spin.sweep_share) * period_s * (kNumBeams - 1) / kNumBeams;
  const double begin_s = kRest_s + draw(generator) * period_s;
  const double rate = rad_from_deg(spin.turn_deg_per_s) * (draw(generator) < 0.5 ? -1.0 : 1.0);
  const double turning_s = spin.num_turns * kTwoPi / std::abs(rate);
  const double first_rad = kTwoPi * draw(generator);
  const auto turned_rad = [&](double time_s) {
    return rate * std::clamp(time_s - begin_s, 0.0, turning_s);
  };
  std::vector<SpunScan> scans;
  for (double time_s = 0.0; time_s < begin_s + turning_s + kRest_s; time_s += period_s) {
    SpunScan spun;
    spun.turn_rad = turned_rad(time_s + 0.5 * sweep_s);
    spun.T_wheels_base = {0.0, 0.0, wrap_to_pi(spun.turn_rad)};
    Scan& scan = spun.scan;
    scan.stamp.ns = std::llround(1e9 * time_s);
    scan.first_bearing_rad = -kPi;
    scan.bearing_step_rad = kTwoPi / kNumBeams;
    scan.max_range_m = 8.0;
    if (spin.states_sweep) {
      scan.time_increment_s = std::copysign(sweep_s, spin.sweep_share) / (kNumBeams - 1);
    }
    for (std::size_t beam = 0; beam < kNumBeams; ++beam) {
      const std::size_t turn = spin.sweep_share < 0.0 ? kNumBeams - 1 - beam : beam;
      const double since_s = sweep_s * static_cast<double>(turn) / (kNumBeams - 1);
      const double angle_rad = first_rad + turned_rad(time_s + since_s) + scan.bearing_rad(beam);
      const double range_m = cast_ray(room.walls, room.x_m, room.y_m, angle_rad);
      scan.ranges_m.push_back(range_m + noise(generator) * std::min(0.01 * range_m, 0.015));
    }
    scans.push_back(spun);
  }
  return scans;
}

}  // namespace setsquare::testing
