// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Finds the gaps of a log: the robot may be anywhere after one, unless it sees what it saw
/// before. Stamps that run backwards, as those of real logs do, make no gap: a pause counts from
/// the later one of the two stamps before. So a single stamp that jumps back does no harm when time
/// goes on, and a clock that was set back for good is followed from its second stamp on. Pauses are
/// those of all scanners together; what a scanner sees is compared with its own last scan.
class ScanGap {
 public:
  explicit ScanGap(const ScanGapParams& params) : params_(params) {}

  /// Whether there is a gap before this scan.
  [[nodiscard]] bool add(const Scan& scan);

 private:
  [[nodiscard]] bool is_same_view(const Scan& a, const Scan& b) const;

  ScanGapParams params_;
  std::map<std::uint32_t, Scan> last_;  ///< By scanner.
  std::optional<Timestamp> last_stamp_;
  Timestamp latest_;       ///< The later stamp of the last two scans.
  double period_s_ = 0.0;  ///< The usual pause; 0 until there was one.
};

}  // namespace setsquare
