// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/localisation_status.hpp"

namespace setsquare {

const char* to_string(LocalisationStatus status) {
  switch (status) {
    case LocalisationStatus::kLocalised:
      return "localised";
    case LocalisationStatus::kAmbiguous:
      return "ambiguous";
    case LocalisationStatus::kLost:
      break;
  }
  return "lost";
}

}  // namespace setsquare
