// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace setsquare {

/// How long the robot's scanner takes from its first beam to its last, and who says so.
enum class SweepVerdict {
  kUnknown,  ///< Nobody: its scans are taken as measured at once.
  kStated,   ///< The log.
  kFound,    ///< The walls, seen while the robot turned; the log states nothing or something else.
  kAtOnce,   ///< The walls show no skew: the beams are measured at once.
};

/// "unknown", "stated", "found", "at once".
[[nodiscard]] const char* to_string(SweepVerdict verdict);

/// What became of the skew of a log's scans.
struct SweepReport {
  SweepVerdict verdict = SweepVerdict::kUnknown;  ///< At the end of the log.
  double sweep_s = 0.0;       ///< Negative where the last beam of a scan is measured first.
  double stated_s = 0.0;      ///< What the log states; 0 where it states nothing.
  std::size_t num_turns = 0;  ///< Scans during turns by which it was found.
};

}  // namespace setsquare
