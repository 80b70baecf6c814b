// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/tracked_scans.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::uint32_t kMaxMountings = (1U << 24U) - 1U;  // As bits of a record, too.

/// Of mountings that were worked out of two poses.
bool is_same_but_for_rounding(const Pose2& a, const Pose2& b) {
  constexpr double kRounding = 1e-12;
  return std::abs(a.x_m - b.x_m) <= kRounding && std::abs(a.y_m - b.y_m) <= kRounding &&
         std::abs(a.theta_rad - b.theta_rad) <= kRounding;
}

bool is_any_open(const OpenMotion& open) {
  return open.is_turn_open || open.sigma_m != 0.0 || open.turn_sigma_rad != 0.0 ||
         !open.turn_motion_m.isZero(0.0);
}

void turn(OpenMotion& open, double turn_rad) {
  const Eigen::Matrix2d R = rotation_matrix(turn_rad);
  open.direction = R * open.direction;
  open.turn_motion_m = R * open.turn_motion_m;
}

}  // namespace

TrackedScan TrackedScans::operator[](std::size_t index) const {
  const Record& record = records_[index];
  TrackedScan scan{.stamp = record.stamp,
                   .status = static_cast<TrackStatus>(record.status),
                   .has_odometry = record.has_odometry != 0,
                   .is_restart = record.is_restart != 0,
                   .is_same_again = record.is_same_again != 0,
                   .score = record.score,
                   .T_odom_sensor = record.T_odom_sensor,
                   .T_base_sensor = mountings_[record.mounting],
                   .open = {}};
  if (record.is_open != 0) scan.open = open_[open_from(index)].open;
  return scan;
}

void TrackedScans::add(const TrackedScan& scan) {
  const bool is_open = is_any_open(scan.open);
  if (is_open) open_.push_back({records_.size(), scan.open});
  records_.push_back({.stamp = scan.stamp,
                      .T_odom_sensor = scan.T_odom_sensor,
                      .score = scan.score,
                      .mounting = mounting_of(scan.T_base_sensor) & kMaxMountings,
                      .status = static_cast<std::uint32_t>(scan.status) & 0xFU,
                      .has_odometry = scan.has_odometry,
                      .is_restart = scan.is_restart,
                      .is_same_again = scan.is_same_again,
                      .is_open = is_open});
}

void TrackedScans::move_to_odom(std::size_t index, const Pose2& T_odom_sensor) {
  Record& record = records_[index];
  if (record.is_open != 0) {
    turn(open_[open_from(index)].open, T_odom_sensor.theta_rad - record.T_odom_sensor.theta_rad);
  }
  record.T_odom_sensor = T_odom_sensor;
}

void TrackedScans::resize(std::size_t num) { erase(num, size()); }

void TrackedScans::erase(std::size_t first, std::size_t end) {
  if (first == end) return;
  const auto open_first = open_.begin() + static_cast<std::ptrdiff_t>(open_from(first));
  const auto open_end = open_.begin() + static_cast<std::ptrdiff_t>(open_from(end));
  for (auto open = open_.erase(open_first, open_end); open != open_.end(); ++open) {
    open->index -= end - first;
  }
  records_.erase(records_.begin() + static_cast<std::ptrdiff_t>(first),
                 records_.begin() + static_cast<std::ptrdiff_t>(end));
  forget_unused_mountings();
}

std::uint32_t TrackedScans::mounting_of(const Pose2& T_base_sensor) {
  constexpr std::size_t kMaxTried = 16;  // Scanners, of which each has one, mostly.
  const std::size_t last_tried = mountings_.size() - std::min(mountings_.size(), kMaxTried);
  for (std::size_t i = mountings_.size(); i-- > last_tried;) {
    if (is_same_but_for_rounding(mountings_[i], T_base_sensor)) {
      return static_cast<std::uint32_t>(i);
    }
  }
  if (mountings_.size() == kMaxMountings) throw ParameterError("T_base_sensor", "never stays");
  mountings_.push_back(T_base_sensor);
  return static_cast<std::uint32_t>(mountings_.size() - 1);
}

std::size_t TrackedScans::open_from(std::size_t index) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(open_, index, {}, &OpenRecord::index) -
                                  open_.begin());
}

/// A scanner that turns on its robot has another mounting for each scan.
void TrackedScans::forget_unused_mountings() {
  const std::vector<Pose2> mountings = std::exchange(mountings_, {});
  for (Record& record : records_) {
    record.mounting = mounting_of(mountings[record.mounting]) & kMaxMountings;
  }
}

void move_to_odom(const Pose2& T_odom_sensor, TrackedScan& scan) {
  turn(scan.open, T_odom_sensor.theta_rad - scan.T_odom_sensor.theta_rad);
  scan.T_odom_sensor = T_odom_sensor;
}

}  // namespace setsquare
