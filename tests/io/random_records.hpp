// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Records of any numbers, for the laws of writers and readers, and their equality bit by bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing {

/// The bits of a number; all NaNs are one.
inline std::uint64_t bits_of(double number) {
  return std::isnan(number) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(number);
}

inline std::vector<std::uint64_t> bits_of(const LogRecord& record) {
  std::vector<std::uint64_t> bits = {static_cast<std::uint64_t>(record.kind),
                                     static_cast<std::uint64_t>(record.stamp.ns),
                                     static_cast<std::uint64_t>(record.scan.stamp.ns)};
  const Scan& scan = record.scan;
  const auto add_pose = [&](const std::optional<Pose2>& pose) {
    bits.push_back(pose ? 1 : 0);
    const Pose2 stated = pose.value_or(Pose2{});
    for (const double number : {stated.x_m, stated.y_m, stated.theta_rad}) {
      bits.push_back(bits_of(number));
    }
  };
  for (const double number : {scan.first_bearing_rad,
                              scan.bearing_step_rad,
                              scan.min_range_m,
                              scan.max_range_m,
                              scan.time_increment_s,
                              scan.scan_time_s,
                              record.forward_m_per_s.value_or(NAN),
                              record.turn_rad_per_s.value_or(NAN)}) {
    bits.push_back(bits_of(number));
  }
  add_pose(record.T_odom_base);
  add_pose(record.T_map_base);
  add_pose(scan.T_base_sensor);
  for (const double range_m : scan.ranges_m) bits.push_back(bits_of(range_m));
  return bits;
}

/// A finite number of any size, or one with few digits, as most logs have them.
inline double any_number(std::mt19937_64& generator) {
  if (generator() % 2 == 0) return static_cast<double>(generator() % 100000) / 1000.0;
  const double number = std::bit_cast<double>(generator());
  return std::isfinite(number) ? number : -0.0;
}

inline double any_range(std::mt19937_64& generator) {
  switch (generator() % 10) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return -std::numeric_limits<double>::infinity();
    default:
      return any_number(generator);
  }
}

inline Pose2 any_pose(std::mt19937_64& generator) {
  return {any_number(generator), any_number(generator), any_number(generator)};
}

/// A scan with odometry or without. The mounting's angle is in [-pi, pi), as readers settle it.
inline LogRecord any_scan(std::mt19937_64& generator) {
  LogRecord record;
  record.sensor =
      std::vector<std::string>{"front", "a \"b\", c;\\", "", "\xc3\xb6"}[generator() % 4];
  record.stamp.ns = static_cast<std::int64_t>(generator() % 4'000'000'000'000'000'000) - 1000;
  Scan& scan = record.scan;
  scan.stamp = record.stamp;
  scan.first_bearing_rad = any_number(generator);
  scan.bearing_step_rad = uniform(generator, 1e-5, 0.03);
  scan.min_range_m = uniform(generator, 0.0, 1.0);
  const bool is_unlimited = generator() % 4 == 0;
  scan.max_range_m =
      is_unlimited ? std::numeric_limits<double>::infinity() : uniform(generator, 1.0, 100.0);
  scan.time_increment_s = any_number(generator);
  scan.scan_time_s = any_number(generator);
  scan.ranges_m.resize(1 + generator() % 200);
  for (double& range_m : scan.ranges_m) range_m = any_range(generator);
  scan.T_base_sensor = any_pose(generator);
  if (generator() % 2 == 0) record.T_odom_base = any_pose(generator);
  return record;
}

}  // namespace setsquare::testing
