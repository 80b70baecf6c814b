// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from live_mapper, its only caller: frames against each other, without threads.
#pragma once

#include <cstddef>
#include <optional>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Where tracking's frame lies in the map, and where the odometry's does.
///
/// Tracking's frame is new each time all is tracked again: a run of it has a number. The map tells
/// of one run where it lies (correct); until it has told of a new one the robot goes on from where
/// it was.
class MapFrame {
 public:
  struct Placed {
    Pose2 T_map_base;
    Pose2 T_odom_base;
    Pose2 T_map_odom;
  };

  /// A scan's pose by tracking; `T_wheels_base` where the robot has odometry.
  [[nodiscard]] Placed place(const Pose2& T_track_base,
                             std::size_t run,
                             const std::optional<Pose2>& T_wheels_base) {
    if (run != run_ && has_last_) {
      T_map_track_ = T_map_last_ * T_track_base.inverse();
      T_odom_track_ = T_odom_last_ * T_track_base.inverse();
    }
    run_ = run;
    if (correction_ && correction_run_ == run) T_map_track_ = *correction_;
    Placed placed;
    placed.T_map_base = T_map_track_ * T_track_base;
    placed.T_odom_base = T_wheels_base ? *T_wheels_base : T_odom_track_ * T_track_base;
    placed.T_map_odom = placed.T_map_base * placed.T_odom_base.inverse();
    T_map_last_ = placed.T_map_base;
    T_odom_last_ = T_odom_track_ * T_track_base;
    has_last_ = true;
    return placed;
  }

  /// What the map says of a run.
  void correct(const Pose2& T_map_track, std::size_t run) {
    correction_ = T_map_track;
    correction_run_ = run;
  }

 private:
  std::size_t run_ = 0;
  Pose2 T_map_track_;
  Pose2 T_odom_track_;  ///< Of the frame in which nothing jumps, where there are no wheels.
  std::optional<Pose2> correction_;
  std::size_t correction_run_ = 0;
  bool has_last_ = false;
  Pose2 T_map_last_;
  Pose2 T_odom_last_;
};

}  // namespace setsquare
