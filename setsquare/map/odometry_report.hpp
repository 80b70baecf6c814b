// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace setsquare {

/// Whether a log's odometry moves as the scans show that the robot does.
enum class OdometryVerdict {
  kOpen,      ///< The scans have not shown enough motion to tell.
  kBelieved,  ///< It does.
  kScaled,    ///< Its metres or its turns are others: they are mended.
  kStill,     ///< It stands still while the robot moves: ignored.
  kMirrored,  ///< It turns the other way: ignored.
  kUnlike,    ///< It does something else: ignored.
};

/// "open", "believed", "scaled", "still", "mirrored", "unlike".
[[nodiscard]] const char* to_string(OdometryVerdict verdict);

/// How one kind of the odometry's motion, ways or turns, compares with the scans'.
struct OdometryComparison {
  std::size_t num_compared = 0;  ///< Stretches of the track, all in all.
  double scale = 1.0;            ///< The scans' motion over the odometry's, at the end.
  double deviation = 0.0;        ///< From that, as a share of the motion: a standard deviation.
};

/// What became of a log's odometry.
struct OdometryReport {
  OdometryVerdict verdict = OdometryVerdict::kOpen;  ///< At the end.
  OdometryComparison way;                            ///< Of the distances driven.
  OdometryComparison turn;                           ///< Of the angles turned.
  std::size_t num_ignored = 0;  ///< Scans whose odometry was no odometry, and was not used.
  std::size_t num_jumps = 0;    ///< Of these, after a step that no robot makes.
  /// Times that what the scans see changed while the wheels stood still: the robot was carried.
  std::size_t num_carried = 0;
};

}  // namespace setsquare
