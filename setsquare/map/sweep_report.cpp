// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/sweep_report.hpp"

namespace setsquare {

const char* to_string(SweepVerdict verdict) {
  switch (verdict) {
    case SweepVerdict::kUnknown:
      return "unknown";
    case SweepVerdict::kStated:
      return "stated";
    case SweepVerdict::kFound:
      return "found";
    case SweepVerdict::kAtOnce:
      return "at once";
  }
  return "";
}

}  // namespace setsquare
