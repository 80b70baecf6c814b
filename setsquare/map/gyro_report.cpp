// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/gyro_report.hpp"

namespace setsquare {

const char* to_string(GyroVerdict verdict) {
  switch (verdict) {
    case GyroVerdict::kOpen:
      return "open";
    case GyroVerdict::kBelieved:
      return "believed";
    case GyroVerdict::kMirrored:
      return "mirrored";
    case GyroVerdict::kDegrees:
      return "degrees";
    case GyroVerdict::kOffTime:
      return "off time";
    case GyroVerdict::kUnlike:
      return "unlike";
  }
  return "";
}

}  // namespace setsquare
