// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/logs/bag/message_trust.hpp"
#include "setsquare/io/logs/bag/odometry.hpp"
#include "setsquare/io/logs/bag/placed_scans.hpp"
#include "setsquare/io/logs/bag/robot_frames.hpp"
#include "setsquare/io/logs/bag/topic_reader.hpp"
#include "setsquare/io/logs/record_stream.hpp"
#include "setsquare/io/ros/point_slice.hpp"

namespace setsquare {

/// The records of a recording of ROS messages: its scans, each with its laser's mounting (by tf)
/// and with the odometry at its stamp (interpolated), the odometry, turn rates and reference poses.
///
/// Messages that are damaged, that cannot be true or that do not go on from what others said before
/// (MessageCourse) are left out and counted; where scans were placed for a while the mounting stays
/// (RobotFrames).
///
/// A laser is named by its topic. Records come in file order; a scan waits until what it needs has
/// come: the transform to its frame for up to kMaxWaitForFrame_s of the recording, a pose of the
/// odometry behind its stamp for up to kMaxWaitForOdometry_s. A laser whose frame no transform
/// places is taken to be where the robot's frame is, and a remark says so.
class BagLog final : public RecordStream {
 public:
  static constexpr double kMaxWaitForFrame_s = 5.0;
  static constexpr double kMaxWaitForOdometry_s = 1.0;
  /// Odometry that was silent for so long is not waited for.
  static constexpr double kSilentOdometry_s = 3.0;
  static constexpr std::size_t kMaxPending = 2048;

  BagLog(std::unique_ptr<MessageSource> source, const LogOptions& options);

  bool read(LogRecord& record) override;
  double mounting_rounding() const override { return 0.0; }
  std::string format() const override { return source_->format(); }
  std::optional<double> fraction_read() const override { return source_->fraction_read(); }
  RecordingOverview overview() const override;

 private:
  /// A record that is not yet handed on.
  struct Pending {
    LogRecord record;
    ros::LaserScan scan;  ///< kScan: as it was sent.
    Timestamp arrival;    ///< Log time.
    Timestamp* newest_of_topic = nullptr;
    std::int64_t clock_offset_ns = 0;  ///< Log time minus stamp.
    bool is_of_cloud = false;          ///< kScan: record.scan is made, of a point cloud.
  };

  void take(const Message& message);
  void dispatch(ros::LaserScan& scan, const Message& message, TopicRole role);
  void dispatch(ros::MultiEchoLaserScan& scan, const Message& message, TopicRole role);
  void dispatch(ros::PointCloud2& cloud, const Message& message, TopicRole role);
  void dispatch(const ros::Odometry& odometry, const Message& message, TopicRole role);
  void dispatch(const ros::PoseStamped& pose, const Message& message, TopicRole role);
  void dispatch(const ros::Imu& imu, const Message& message, TopicRole role);
  void dispatch(const ros::TfMessage& transforms, const Message& message, TopicRole role);
  void add_transform(const ros::TransformStamped& transform,
                     const Message& message,
                     TopicRole role);
  /// Whether the transform is to be believed; else it is counted.
  [[nodiscard]] bool is_believed(const ros::TransformStamped& transform, const Message& message);
  /// As is_believed(), of a scan or a cloud.
  [[nodiscard]] bool is_believed(Timestamp stamp,
                                 const std::string& frame_id,
                                 const Message& message);
  void add_odometry(const std::string& topic,
                    const Message& message,
                    Timestamp stamp,
                    const Pose2& T_odom_base,
                    std::string_view base_frame);
  Pending& add_pending(RecordKind kind, const Message& message, Timestamp stamp);

  [[nodiscard]] bool is_ready(const Pending& pending) const;
  [[nodiscard]] bool is_beginning() const;
  [[nodiscard]] bool is_mounting_settled(const Pending& pending) const;
  [[nodiscard]] bool is_odometry_settled(const Pending& pending) const;
  [[nodiscard]] bool complete(Pending& pending);
  [[nodiscard]] ros::TransformLookup mounting_of(const std::string& frame, Timestamp stamp) const;
  [[nodiscard]] Timestamp in_odometry_clock(const Pending& pending) const;

  [[nodiscard]] RecordingFrame frame_of(const ros::TransformTree::Link& link) const;
  [[nodiscard]] const std::string& topic_name(const Message& message) const;
  [[nodiscard]] Timestamp stamp_of(Timestamp header, const Message& message);
  /// `place`: what of the message it concerns; may be empty.
  void add_damage(const Message& message, std::string_view reason, const std::string& place = {});
  void add_damage(const std::string& topic,
                  std::uint64_t position,
                  std::string_view reason,
                  const std::string& place = {});
  void remark_once(const std::string& remark);
  void remark_on_place(const std::string& topic, const std::string& reason);
  /// Behind the last record, also of those that had to wait.
  void remark_at_end();
  /// How many scans had to do without.
  void remark_on_odometry();

  std::unique_ptr<MessageSource> source_;
  LogOptions options_;
  std::map<std::size_t, TopicReader> readers_;  ///< By the topic's index.
  RobotFrames frames_;
  MessageTrust trust_;
  BagOdometry odometry_;
  /// Log time minus stamp of each topic's last message: in a recording that was made faster than
  /// the robot drove, it changes.
  std::map<std::string, std::int64_t> odometry_clock_offset_ns_;
  std::map<std::string, Timestamp> odometry_arrivals_;  ///< Log time of the last, by topic.
  std::map<std::string, Timestamp> newest_stamps_;      ///< By topic.
  std::deque<Pending> pending_;
  std::vector<Pending> spare_;                       ///< Whose memory is used again.
  std::map<std::string, ros::PointSlicer> slicers_;  ///< By the topic of clouds.
  std::map<std::string, PlacedScans> placed_;        ///< By the laser's topic.
  std::set<std::string> unplaced_frames_;            ///< Of lasers that no transform places.
  std::map<std::string, std::uint64_t> num_without_stamp_;
  std::uint64_t num_scans_ = 0;
  std::uint64_t num_without_odometry_ = 0;
  std::set<std::string> remarks_made_;
  std::optional<Timestamp> first_log_time_;
  Timestamp last_log_time_;
  bool has_scan_topic_ = false;
  bool is_at_end_ = false;
  bool is_end_told_ = false;
};

}  // namespace setsquare
