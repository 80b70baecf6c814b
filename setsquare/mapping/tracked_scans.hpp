// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/map/track_status.hpp"

namespace setsquare {

/// What a scan's walls left open, and by how much the motion to it may be off there. Zeros of most
/// scans.
struct OpenMotion {
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< Unit vector in the odom frame.
  double sigma_m = 0.0;                                 ///< Along it: MotionUncertainty::add().
  bool is_turn_open = false;    ///< TrackedPose::turn_bound_share is less than 1.
  double turn_sigma_rad = 0.0;  ///< MotionUncertainty::open_turn_sigma_rad().
  Eigen::Vector2d turn_motion_m = Eigen::Vector2d::Zero();  ///< TrackedPose::turn_motion_m.
};

/// What the mapper needs of a scan that was tracked.
struct TrackedScan {
  Timestamp stamp;
  TrackStatus status = TrackStatus::kTracked;
  bool has_odometry = false;   ///< As the two that follow, of TrackedPose.
  bool is_restart = false;     ///< Tracking was lost for so long that it began anew here.
  bool is_same_again = false;  ///< It repeats the scan before, and no odometry came.
  float score = 1.0F;
  Pose2 T_odom_sensor;
  Pose2 T_base_sensor;
  OpenMotion open;
};

/// The scans of a log, in their order, in little memory: a robot that patrols adds ten a second all
/// day. 40 bytes for most; what few scans have, and what many share, stands apart.
class TrackedScans {
 public:
  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] TrackedScan operator[](std::size_t index) const;

  [[nodiscard]] Timestamp stamp(std::size_t index) const { return records_[index].stamp; }
  [[nodiscard]] const Pose2& T_odom_sensor(std::size_t index) const {
    return records_[index].T_odom_sensor;
  }
  [[nodiscard]] bool is_same_again(std::size_t index) const {
    return records_[index].is_same_again != 0;
  }

  /// Mountings that differ by no more than rounding are one. Throws ParameterError where scans have
  /// more than 16 million of them.
  void add(const TrackedScan& scan);
  /// The scan in another odom frame.
  void move_to_odom(std::size_t index, const Pose2& T_odom_sensor);
  /// Leaves the first ones.
  void resize(std::size_t num);
  /// Those from `first` on and before `end` are no longer there: later ones move up.
  void erase(std::size_t first, std::size_t end);

 private:
  struct Record {
    Timestamp stamp;
    Pose2 T_odom_sensor;
    float score;
    std::uint32_t mounting : 24;  ///< Index of mountings_.
    std::uint32_t status : 4;     ///< A TrackStatus.
    std::uint32_t has_odometry : 1;
    std::uint32_t is_restart : 1;
    std::uint32_t is_same_again : 1;
    std::uint32_t is_open : 1;  ///< One of open_ is its.
  };
  struct OpenRecord {
    std::size_t index = 0;  ///< Of the scan.
    OpenMotion open;
  };

  /// Throws ParameterError where there are too many.
  [[nodiscard]] std::uint32_t mounting_of(const Pose2& T_base_sensor);
  /// The first of open_ that is not of an earlier scan.
  [[nodiscard]] std::size_t open_from(std::size_t index) const;
  void forget_unused_mountings();

  std::vector<Record> records_;
  std::vector<Pose2> mountings_;  ///< T_base_sensor.
  std::vector<OpenRecord> open_;  ///< In the order of the scans.
};

/// A scan in another odom frame.
void move_to_odom(const Pose2& T_odom_sensor, TrackedScan& scan);

}  // namespace setsquare
