// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace setsquare {

/// What came of matching pairs of a map's scans without a guess and comparing the answers with the
/// map.
struct AuditReport {
  std::size_t num_pairs = 0;          ///< That were matched without a guess.
  std::size_t num_matched = 0;        ///< Of these, answered MatchStatus::kMatched.
  std::size_t num_agreeing = 0;       ///< Of these, with the map.
  std::size_t num_contradicting = 0;  ///< The others.
  /// Contradicting pairs that others second and that raise a doubt. One that stands alone is the
  /// matcher's own error, or nobody's.
  std::size_t num_seconded = 0;
};

}  // namespace setsquare
