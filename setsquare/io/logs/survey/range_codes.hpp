// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace setsquare {

/// Tells the codes among ranges that a scanner cannot measure from measurements: a scanner has a
/// handful of codes for "nothing seen" and for errors, while measurements are ever other values.
class RangeCodes {
 public:
  static constexpr std::size_t kMaxCodes = 16;

  /// Whether a range is one of the first kMaxCodes different values that came.
  bool is_code(double range_m) {
    if (std::ranges::find(codes_, range_m) != codes_.end()) return true;
    if (codes_.size() >= kMaxCodes) return false;
    codes_.push_back(range_m);
    return true;
  }

 private:
  std::vector<double> codes_;
};

}  // namespace setsquare
