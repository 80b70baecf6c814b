// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "setsquare/io/logs/survey/range_codes.hpp"

namespace setsquare {

/// Ranges that no scanner of buildings measures, told apart: codes (a few values again and again)
/// and measurements in another unit (ever other values).
class FarRanges {
 public:
  /// Beyond it a range is far.
  static constexpr double kFarthest_m = 100.0;

  /// Takes the far ones; infinity and NaN are none.
  void add(double range_m) {
    if (range_m > kFarthest_m) add_far(range_m);
  }

  [[nodiscard]] std::uint64_t num_measured() const { return num_measured_; }
  [[nodiscard]] double shortest_measured() const { return shortest_; }
  [[nodiscard]] double longest_measured() const { return longest_; }
  /// The power of two below the median of the measured ones; 0 where there are none.
  [[nodiscard]] double octave_of_median() const;

 private:
  void add_far(double range_m);

  RangeCodes codes_;
  std::uint64_t num_measured_ = 0;
  double shortest_ = std::numeric_limits<double>::infinity();
  double longest_ = 0.0;
  std::array<std::uint64_t, 32> num_per_octave_{};
};

}  // namespace setsquare
