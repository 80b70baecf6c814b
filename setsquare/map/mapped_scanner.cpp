// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/mapped_scanner.hpp"

namespace setsquare {

const char* to_string(MountingVerdict verdict) {
  switch (verdict) {
    case MountingVerdict::kReference:
      return "reference";
    case MountingVerdict::kOpen:
      return "open";
    case MountingVerdict::kConfirmed:
      return "confirmed";
    case MountingVerdict::kRefuted:
      return "refuted";
    case MountingVerdict::kUnfit:
      return "unfit";
  }
  return "";
}

}  // namespace setsquare
