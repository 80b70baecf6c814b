// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace setsquare {

/// What may be wrong with a log.
enum class FindingKind {
  kRangeUnit,            ///< Ranges in millimetres or centimetres.
  kErrorCodes,           ///< Ranges of a few millimetres.
  kRepeatedRange,        ///< One range again and again: a code among the returns.
  kIsolatedReturns,      ///< Many returns that nothing stands beside.
  kRobotParts,           ///< The scanner sees its own robot.
  kNoReturns,            ///< Not one return.
  kFewBeams,             ///< Too few beams to see walls.
  kBeamsChange,          ///< Their number changes from scan to scan.
  kFirstBearingChanges,  ///< The first beam's direction does.
  kFieldOfView,          ///< The assumed angles do not fit the odometry.
  kMirrored,             ///< The scans turn against the odometry.
  kScansRepeated,        ///< Scans equal to the one before.
  kScansStand,           ///< The scans stay the same while the odometry moves.
  kStampUnit,            ///< Stamps in milliseconds or finer.
  kStampsBackward,       ///< Stamps before their predecessor's.
  kStampsRepeated,       ///< Stamps equal to their predecessor's.
  kOdometryConstant,     ///< Poses that rarely or never change while the scans move.
  kOdometryJumps,        ///< Faster than any robot.
  kOdometrySpeed,        ///< Poses that move against the reported speed.
  kRemark,               ///< What the reader remarked on the whole log.
  kDamagedRecords,       ///< Records that could not be read.
};

/// "range_unit" for kRangeUnit: the name in JSON.
[[nodiscard]] const char* to_string(FindingKind kind);

/// One thing that is wrong with a log, and what to do.
struct LogFinding {
  FindingKind kind = FindingKind::kRemark;  ///< What it is about.
  std::string sentence;                     ///< What was seen; names the laser.
  /// Of the scans, ranges or poses that it concerns, 0 to 1; nothing where it has none.
  std::optional<double> share = {};
  std::string option = {};  ///< Of the command, which mends it; empty where none does.
};

/// The sentence, and the option behind it: "...: in millimetres? Try --range-scale 0.001".
[[nodiscard]] std::string text_of(const LogFinding& finding);

}  // namespace setsquare
