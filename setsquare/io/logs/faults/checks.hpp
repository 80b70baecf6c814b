// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The checks that find_faults makes, one by one: tests call them alone.
#pragma once

#include <optional>
#include <string>

#include "setsquare/io/logs/faults/finding.hpp"
#include "setsquare/io/logs/log_survey.hpp"

namespace setsquare {

/// One laser and the odometry that came with its scans.
struct CheckedLaser {
  const std::string& name;  ///< Begins the sentences.
  const SensorSurvey& sensor;
  const OdometrySurvey& odometry;
};

/// "3.2 %" of a share; two digits at least.
[[nodiscard]] std::string percent(double share);

// Ranges (ranges.cpp).
[[nodiscard]] std::optional<LogFinding> check_range_unit(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_error_codes(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_repeated_range(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_isolated_returns(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_robot_parts(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_returns(const CheckedLaser& laser);

// Beams (beams.cpp).
[[nodiscard]] std::optional<LogFinding> check_number_of_beams(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_beams_change(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_first_bearing(const CheckedLaser& laser);

// Scans against the odometry (motion.cpp).
[[nodiscard]] std::optional<LogFinding> check_field_of_view(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_mirrored(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_scans_repeated(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_scans_stand(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_odometry_constant(const CheckedLaser& laser);

// Stamps (stamps.cpp).
[[nodiscard]] std::optional<LogFinding> check_stamp_unit(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_stamps_backward(const CheckedLaser& laser);
[[nodiscard]] std::optional<LogFinding> check_stamps_repeated(const CheckedLaser& laser);

// Odometry, with scans or alone (odometry.cpp).
[[nodiscard]] std::optional<LogFinding> check_odometry_jumps(const std::string& name,
                                                             const OdometrySurvey& odometry);
[[nodiscard]] std::optional<LogFinding> check_odometry_speed(const std::string& name,
                                                             const OdometrySurvey& odometry);

}  // namespace setsquare
