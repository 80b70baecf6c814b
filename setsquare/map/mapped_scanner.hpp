// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Whether a scanner is where its scans say that it is mounted.
enum class MountingVerdict {
  kReference,  ///< The scanner of the first scan: the others are judged by it.
  kOpen,       ///< Too few of its scans could be compared with what the others saw.
  kConfirmed,  ///< Its scans fit: they are part of the map from then on.
  kRefuted,    ///< They fit where it is turned or displaced.
  kUnfit,      ///< Most of its scans fit nowhere.
};

/// "reference", "open", "confirmed", "refuted", "unfit".
[[nodiscard]] const char* to_string(MountingVerdict verdict);

/// One of the robot's scanners. The scans of one whose mounting is not confirmed are left out of
/// the map; those before it is confirmed, too.
struct MappedScanner {
  std::uint32_t scanner = 0;                              ///< Scan::scanner
  MountingVerdict verdict = MountingVerdict::kReference;  ///< At the end of the log.
  std::size_t num_scans = 0;                              ///< That came.
  std::size_t num_mapped = 0;                             ///< Of these, part of the map.
  std::size_t num_sightings = 0;  ///< Scans by which the mounting was judged.
  Pose2 T_base_sensor;            ///< As its scans say.
  Pose2 T_base_seen;              ///< As the walls show it, by these scans,
  double sigma_rad = 0.0;         ///< with the standard deviation of the heading
  double sigma_m = 0.0;           ///< and of x and y; infinite where the walls left them open.
};

}  // namespace setsquare
