// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, which owns it: matching without a guess is a separate step.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/keyframe.hpp"

namespace setsquare {

/// The keyframes of a submap as the guess-free matcher needs them, each prepared when it is first
/// asked for: most submaps are never matched.
class PreparedKeyframes {
 public:
  void add(KeyframePtr keyframe) { entries_.push_back({std::move(keyframe), std::nullopt}); }
  void drop_first() { entries_.erase(entries_.begin()); }
  void clear() { entries_.clear(); }

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  /// `age`: 0 for the latest keyframe.
  [[nodiscard]] const Keyframe& keyframe(std::size_t age) const { return *entry(age).keyframe; }
  [[nodiscard]] const PreparedScan& scan(std::size_t age);

 private:
  struct Entry {
    KeyframePtr keyframe;
    std::optional<PreparedScan> scan;
  };

  [[nodiscard]] const Entry& entry(std::size_t age) const {
    return entries_[entries_.size() - 1 - age];
  }

  std::vector<Entry> entries_;  ///< The latest at the back.
};

}  // namespace setsquare
