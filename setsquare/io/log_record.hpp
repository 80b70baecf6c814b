// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

enum class RecordKind {
  kScan,      ///< One sweep of one laser.
  kOdometry,  ///< A robot pose by odometry alone, without a scan.
  kTruePose,  ///< The robot's true pose, as a simulator writes it.
};

/// One record of a log, whatever the log's format. Fields that a kind does not use are empty.
struct LogRecord {
  RecordKind kind = RecordKind::kScan;
  std::string sensor;  ///< Name in the log: "FLASER", "ROBOTLASER1", a sensor label, "ODOM".
  Timestamp stamp;     ///< Sensor time; equals scan.stamp for a scan.
  Scan scan;           ///< kScan: ranges in m, mounting included.
  std::optional<Pose2> T_odom_base;       ///< The robot's odometry pose, where the record has one.
  std::optional<Pose2> T_map_base;        ///< kTruePose: the robot's true pose.
  std::optional<double> forward_m_per_s;  ///< kOdometry: speed that the wheels report.
  std::optional<double> turn_rad_per_s;   ///< kOdometry: rate of turn that the wheels report.
  std::uint64_t position = 0;  ///< Line number from 1 in a text log, byte offset in a binary one.
};

}  // namespace setsquare
