// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What is in a log and what is wrong with it, gathered record by record in bounded memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/survey/far_ranges.hpp"
#include "setsquare/io/logs/survey/motion_survey.hpp"
#include "setsquare/io/logs/survey/repeated_ranges.hpp"
#include "setsquare/scan/robot_parts.hpp"

namespace setsquare {

/// Smallest and largest of the values seen.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return low > high; }
};

/// The stamps of one sensor, in file order.
struct StampSurvey {
  std::uint64_t num_stamps = 0;
  Timestamp first;
  Timestamp previous;
  Timestamp earliest;
  Timestamp latest;
  std::uint64_t num_backward = 0;  ///< Stamps before their predecessor's.
  double largest_backward_s = 0.0;
  std::uint64_t num_repeated = 0;  ///< Stamps equal to their predecessor's.
  double longest_gap_s = 0.0;      ///< Longest time from one to the next.
  /// Times from one to the next by their length: the power of two below it, in ns.
  std::array<std::uint64_t, 64> num_per_octave{};

  void add(Timestamp stamp);
  /// The power of two (of ns) below the median time from one to the next; 0 for fewer than two.
  [[nodiscard]] double octave_of_period_s() const;
  [[nodiscard]] double duration_s() const { return seconds_between(earliest, latest); }
};

/// The scans of one laser.
struct SensorSurvey {
  static constexpr std::size_t kMaxCodes = 64;

  StampSurvey stamps;
  Interval num_beams;
  Interval first_bearing_rad;
  Interval bearing_step_rad;
  Interval field_of_view_rad;
  Interval return_range_m;
  double max_range_m = 0.0;  ///< From which ranges are no-returns, in the last scan.
  Pose2 T_base_sensor;
  std::uint64_t num_returns = 0;
  std::uint64_t num_no_returns = 0;
  std::uint64_t num_invalid = 0;
  std::uint64_t num_unchanged = 0;  ///< Scans whose ranges equal their predecessor's, all of them.
  std::map<double, std::uint64_t> codes;  ///< No-return ranges and how often, the first kMaxCodes.
  std::uint64_t num_in_housing = 0;       ///< Ranges above 0 and below kHousingRadius_m.
  std::uint64_t num_isolated = 0;         ///< Returns that stand alone (is_isolated_return).
  RobotParts robot_parts;
  FarRanges far;
  RepeatedRanges repeated;
  MotionSurvey motion;                ///< Of the scans that came with odometry.
  bool has_assumed_bearings = false;  ///< The log states no angles of the beams.

  void add(const Scan& scan);
  [[nodiscard]] std::uint64_t num_ranges() const {
    return num_returns + num_no_returns + num_invalid;
  }

 private:
  void add_ranges(const Scan& scan);
  void count_code(double range_m, std::uint64_t count);

  std::vector<double> previous_ranges_m_;
};

/// Poses by odometry, in file order.
struct OdometrySurvey {
  std::uint64_t num_poses = 0;
  double path_m = 0.0;
  double turn_rad = 0.0;        ///< Sum of the turns' magnitudes.
  double moving_s = 0.0;        ///< Time of the steps of a millimetre or more.
  std::uint64_t num_still = 0;  ///< Poses exactly equal to their predecessor's.
  /// Steps of more than 0.5 m or 30 degrees, faster than 5 m/s or 600 degrees per second.
  std::uint64_t num_jumps = 0;
  Timestamp first_jump;
  /// Steps of more than 2 mm forwards while the wheels report backwards, or the reverse.
  std::uint64_t num_sign_contradictions = 0;
  Timestamp first_contradiction;

  void add(const LogRecord& record);

 private:
  struct Previous {
    Timestamp stamp;
    Pose2 T_odom_base;
    std::optional<double> forward_m_per_s;
  };
  std::optional<Previous> previous_;
};

/// The whole log.
struct LogSurvey {
  std::map<std::string, SensorSurvey> sensors;          ///< By the laser's name.
  std::map<std::string, OdometrySurvey> scan_odometry;  ///< Odometry poses that came with scans.
  OdometrySurvey wheel_odometry;                        ///< Separate odometry records.
  std::uint64_t num_true_poses = 0;

  void add(const LogRecord& record);
};

}  // namespace setsquare
