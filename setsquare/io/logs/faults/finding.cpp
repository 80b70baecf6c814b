// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/faults/finding.hpp"

namespace setsquare {

const char* to_string(FindingKind kind) {
  switch (kind) {
    case FindingKind::kRangeUnit:
      return "range_unit";
    case FindingKind::kErrorCodes:
      return "error_codes";
    case FindingKind::kRepeatedRange:
      return "repeated_range";
    case FindingKind::kIsolatedReturns:
      return "isolated_returns";
    case FindingKind::kRobotParts:
      return "robot_parts";
    case FindingKind::kNoReturns:
      return "no_returns";
    case FindingKind::kFewBeams:
      return "few_beams";
    case FindingKind::kBeamsChange:
      return "beams_change";
    case FindingKind::kFirstBearingChanges:
      return "first_bearing_changes";
    case FindingKind::kFieldOfView:
      return "field_of_view";
    case FindingKind::kMirrored:
      return "mirrored";
    case FindingKind::kScansRepeated:
      return "scans_repeated";
    case FindingKind::kScansStand:
      return "scans_stand";
    case FindingKind::kStampUnit:
      return "stamp_unit";
    case FindingKind::kStampsBackward:
      return "stamps_backward";
    case FindingKind::kStampsRepeated:
      return "stamps_repeated";
    case FindingKind::kOdometryConstant:
      return "odometry_constant";
    case FindingKind::kOdometryJumps:
      return "odometry_jumps";
    case FindingKind::kOdometrySpeed:
      return "odometry_speed";
    case FindingKind::kRemark:
      return "remark";
    case FindingKind::kDamagedRecords:
      return "damaged_records";
  }
  return "unknown";
}

std::string text_of(const LogFinding& finding) {
  if (finding.option.empty()) return finding.sentence;
  const bool is_question = finding.sentence.ends_with('?');
  return finding.sentence + (is_question ? " Try " : "; try ") + finding.option;
}

}  // namespace setsquare
