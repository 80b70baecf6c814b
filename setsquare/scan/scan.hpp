// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// What one beam measured.
enum class BeamOutcome {
  kReturn,    ///< The beam hit something at its range.
  kNoReturn,  ///< The beam met nothing within reach: free space, as far as the sensor sees.
  kInvalid,   ///< NaN, zero, negative or too near: the beam has no information.
};

/// One sweep of the sensor, polar, in the sensor frame (x forward, y left).
struct Scan {
  Timestamp stamp;                 ///< Sensor time of the first beam.
  double first_bearing_rad = 0.0;  ///< Bearing of beam 0.
  double bearing_step_rad =
      0.0;  ///< From a beam to the next; negative where the sensor turns clockwise.
  double min_range_m = 0.0;  ///< Ranges below it are no measurements.
  double max_range_m =
      std::numeric_limits<double>::infinity();  ///< Ranges at or above it are no-returns.
  std::vector<double> ranges_m;  ///< One per beam, as the sensor gave them, codes and NaN included.
  Pose2 T_base_sensor;           ///< The sensor's mounting on the robot.
  double time_increment_s = 0.0;  ///< From a beam to the next; 0 where the log does not say.
  double scan_time_s = 0.0;       ///< From a sweep to the next; 0 where the log does not say.
  std::uint32_t scanner = 0;      ///< Which of the robot's scanners: another number for each.

  /// Beams of the sweep, whatever they measured.
  [[nodiscard]] std::size_t num_beams() const { return ranges_m.size(); }
  /// Of one beam, in the sensor frame: 0 ahead, counterclockwise.
  [[nodiscard]] double bearing_rad(std::size_t beam) const {
    return first_bearing_rad + static_cast<double>(beam) * bearing_step_rad;
  }
  /// The angle between the outermost beams, not negative.
  [[nodiscard]] double field_of_view_rad() const;
  /// The one place that judges a range: NaN, infinities, zero, codes above the sensor's reach.
  [[nodiscard]] BeamOutcome outcome(std::size_t beam) const;
  /// Throws ParameterError where the scan's geometry is invalid (a bearing that is not finite, a
  /// zero step between several beams, a sweep of more than one turn, an empty interval of ranges).
  void validate() const;
};

}  // namespace setsquare
