// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/odometry_report.hpp"

namespace setsquare {

const char* to_string(OdometryVerdict verdict) {
  switch (verdict) {
    case OdometryVerdict::kOpen:
      return "open";
    case OdometryVerdict::kBelieved:
      return "believed";
    case OdometryVerdict::kScaled:
      return "scaled";
    case OdometryVerdict::kStill:
      return "still";
    case OdometryVerdict::kMirrored:
      return "mirrored";
    case OdometryVerdict::kUnlike:
      return "unlike";
  }
  return "";
}

}  // namespace setsquare
