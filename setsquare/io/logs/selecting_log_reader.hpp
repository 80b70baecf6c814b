// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// What every format has in common: reads the log's head (its first scans) to choose the front
/// laser and to settle each laser's mounting, then hands the records on.
class SelectingLogReader final : public LogReader {
 public:
  static constexpr std::size_t kUsualHeadScans = 64;

  /// `num_head_scans`: read before the first record is handed on. One where nothing can wait.
  SelectingLogReader(std::unique_ptr<RecordStream> stream,
                     std::string name,
                     const LogOptions& options,
                     std::size_t num_head_scans = kUsualHeadScans);

  const LogRecord* next() override;
  const LogProblems& problems() const override { return stream_->problems(); }
  std::string front_sensor() const override { return front_sensor_; }
  std::string format() const override { return stream_->format(); }
  std::optional<double> fraction_read() const override { return stream_->fraction_read(); }
  RecordingOverview overview() const override { return stream_->overview(); }

 private:
  struct Mounting {
    Pose2 T_base_sensor;
    double rounding = 0.0;
    bool is_varying = false;
    std::optional<Pose2> T_odom_base = {};  ///< Of the first scan that came with odometry.
    Pose2 T_odom_sensor = {};               ///< Of the same scan.
    bool is_judged = false;                 ///< The robot has moved since, and the laser with it.
    bool is_of_constant_pose = false;       ///< The robot has, and the laser's pose is the same.
  };

  void read_head();
  void settle_mountings(const std::map<std::string, std::vector<Pose2>>& measured,
                        const std::map<std::string, double>& rounding);
  [[nodiscard]] bool is_wanted(const LogRecord& record) const;
  void apply_mounting(LogRecord& record);
  void number_scanner(LogRecord& record);
  void remark_varying(Mounting& mounting, const LogRecord& record);
  /// Whether the laser's pose is what it was at the first scan.
  [[nodiscard]] static bool is_laser_standing(const Mounting& mounting, const LogRecord& record);
  /// Remembers the first poses of the laser and finds out that the laser's pose stays the same
  /// while the robot moves.
  void watch_laser_pose(Mounting& mounting, const LogRecord& record);
  /// Refuses a mounting that is on no robot.
  void check_distance(const std::string& sensor, Mounting& mounting);
  [[nodiscard]] const LogRecord* finish();

  std::unique_ptr<RecordStream> stream_;
  std::string name_;
  std::set<std::string> wanted_;  ///< Sensors by name; none: the front one, or all.
  LogOptions options_;
  std::size_t num_head_scans_;
  bool is_head_read_ = false;
  bool is_end_reported_ = false;
  std::deque<LogRecord> head_;
  LogRecord current_;
  std::map<std::string, Mounting> mountings_;
  std::string front_sensor_;
  std::map<std::string, std::uint32_t> numbers_;  ///< Of sensors, as they come.
  std::uint64_t num_scans_handed_on_ = 0;
};

}  // namespace setsquare
