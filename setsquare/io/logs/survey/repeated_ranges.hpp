// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A range that comes back again and again, the same to the last digit.
struct RepeatedRange {
  double range_m = 0.0;
  double share = 0.0;         ///< Of the returns.
  double share_beyond = 0.0;  ///< Of the returns that are longer.
};

/// Finds a code among the returns: walls are measured now a little shorter, now a little longer,
/// while a code ("nothing seen") is always the same number.
///
/// Every value votes in the slot of its hash (Boyer and Moore's majority vote, one per slot): a
/// value that comes often outvotes the few others of its slot, and its votes are about its count.
/// Every fourth scan is looked at.
class RepeatedRanges {
 public:
  RepeatedRanges();

  void add(const Scan& scan);

  /// The value with most votes, where it is at least 1 of 200 returns and comes more often than all
  /// others within 25 cm of it together.
  [[nodiscard]] std::optional<RepeatedRange> most_striking() const;

 private:
  struct Slot {
    double range_m = 0.0;
    std::uint64_t votes = 0;
  };

  void vote(double range_m);
  [[nodiscard]] std::uint64_t num_around(double range_m) const;

  std::uint64_t num_scans_ = 0;
  std::uint64_t num_returns_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::uint64_t> num_per_bin_;  ///< Returns by range, 5 cm each.
};

}  // namespace setsquare
