// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/ros/cdr_writer.hpp"
#include "setsquare/io/ros/messages.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A map and its making as one MCAP file, which Foxglove and Lichtblick play: each laser's scans on
/// its topic, the robot on /tf (map -> base_link) with the lasers on /tf_static, and, about a
/// hundred times over the run, the map so far on /map (nav_msgs/OccupancyGrid), the way so far on
/// /path (nav_msgs/Path) and the closures so far on /closures (visualization_msgs/MarkerArray).
///
/// Poses are those of the finished map: it grows, but does not bend.
class MapRecording {
 public:
  /// `trajectory`: the robot's poses in the map, any order of stamps. `closures`: as the map judged
  /// them; refused ones are left out.
  MapRecording(McapWriter::Sink sink, Trajectory trajectory, std::vector<LoopClosure> closures);

  /// Adds a scan, in the log's order; one whose stamp has no pose is left out, and false returned.
  bool add(const std::string& laser_topic, const Scan& scan);

  /// Writes the last map and the file's end.
  void finish();

 private:
  struct LaserTopic {
    McapWriter::Channel channel = 0;
    std::string frame;
    bool is_placed = false;
  };
  struct InsertedScan {
    Scan scan;
    Pose2 T_map_sensor;
  };

  [[nodiscard]] const Pose2* pose_at(Timestamp stamp) const;
  LaserTopic& laser_topic(const std::string& topic);
  void keep_for_map(const Scan& scan, const Pose2& T_map_base);
  void write_picture(Timestamp stamp);
  void write_map(Timestamp stamp);
  void write_closures(Timestamp stamp);

  McapWriter file_;
  ros::CdrWriter cdr_;
  Trajectory trajectory_;  ///< By stamp.
  std::vector<LoopClosure> closures_;
  std::map<std::string, LaserTopic> lasers_;
  McapWriter::Channel transforms_;
  McapWriter::Channel static_transforms_;
  McapWriter::Channel map_;
  McapWriter::Channel path_channel_;
  McapWriter::Channel closure_channel_;
  ros::LaserScan message_;
  ros::Path path_;
  std::vector<InsertedScan> inserted_;
  double picture_period_s_ = 0.0;
  Timestamp next_picture_;
  Timestamp last_stamp_;
};

}  // namespace setsquare
