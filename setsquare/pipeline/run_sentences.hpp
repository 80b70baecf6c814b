// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "setsquare/map/gyro_report.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/map/mapped_scanner.hpp"
#include "setsquare/map/odometry_report.hpp"
#include "setsquare/map/sweep_report.hpp"

namespace setsquare {

/// What to tell of the robot's scanners at the end of a run, one sentence each: which are mapped,
/// which are not and why, and the option that would mend it. `names`: of their numbers. Nothing for
/// one scanner alone.
[[nodiscard]] std::vector<std::string> sentences_on(
    const std::vector<MappedScanner>& scanners, const std::map<std::uint32_t, std::string>& names);

/// What became of each session of a map that was continued or merged but the first: joined, or kept
/// apart and why. Nothing for a single one.
[[nodiscard]] std::vector<std::string> sentences_on_sessions(const Map& map);

/// Why a session could not be joined to the map, by how it went when it was looked for.
[[nodiscard]] std::string reason_apart(const SessionSearch& search);

/// What of places that several visits have covered was forgotten, one sentence each: keyframes,
/// poses.
[[nodiscard]] std::vector<std::string> sentences_on_forgotten(const MapSummary& summary);

/// The same of a gyro that the log holds.
[[nodiscard]] std::string sentence_on(const GyroReport& gyro);

/// The same of the odometry.
[[nodiscard]] std::string sentence_on(const OdometryReport& odometry);

/// The same of the scanner's sweep; empty where nothing is known of it.
[[nodiscard]] std::string sentence_on(const SweepReport& sweep);

}  // namespace setsquare
