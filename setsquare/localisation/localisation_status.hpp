// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// What is known of the place of a scan in a map.
enum class LocalisationStatus {
  kLocalised,  ///< One place is right, as good as certainly.
  kAmbiguous,  ///< It is in the map, but several places may be right.
  kLost,       ///< No place is known, or the scan may come from outside the map.
};

/// "localised", "ambiguous" or "lost".
[[nodiscard]] const char* to_string(LocalisationStatus status);

}  // namespace setsquare
