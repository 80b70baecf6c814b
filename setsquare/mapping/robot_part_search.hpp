// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper, its only caller: what is kept, and until when, is a question of its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "setsquare/mapping/sweep_search.hpp"
#include "setsquare/scan/robot_parts.hpp"

namespace setsquare {

/// Looks for parts of the robot in the scans of each scanner (RobotParts), and keeps what comes
/// meanwhile: where there are any, it is to be mapped again without them.
class RobotPartSearch {
 public:
  explicit RobotPartSearch(bool is_on) : is_on_(is_on) {}

  /// What came, before it is mapped.
  void add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
    if (!is_on_) return;
    RobotParts& parts = of_scanner_[scan.scanner];
    if (parts.is_open()) {
      parts.add(scan);
      must_map_again_ = must_map_again_ || parts.num_sectors() > 0;
    }
    if (is_complete_) inputs_.emplace_back(MapperScan{scan, T_wheels_base});
    if (inputs_.size() > kMaxNum) drop();
  }
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
    if (is_on_ && is_complete_) inputs_.emplace_back(MapperTurnRate{stamp, turn_rad_per_s});
  }

  /// The scan without the robot's parts; nothing where it sees none.
  [[nodiscard]] std::optional<Scan> cleared(const Scan& scan) const {
    const auto parts = of_scanner_.find(scan.scanner);
    return parts == of_scanner_.end() ? std::nullopt : parts->second.without(scan);
  }

  /// All that came so far, once: when no scanner's are open any more, and parts were found. Else
  /// empty.
  [[nodiscard]] std::vector<MapperInput> take_to_map_again() {
    const bool is_open = std::any_of(of_scanner_.begin(), of_scanner_.end(), [](const auto& parts) {
      return parts.second.is_open();
    });
    if (is_open || !is_complete_ || of_scanner_.empty()) return {};
    std::vector<MapperInput> inputs = std::exchange(inputs_, {});
    drop();
    if (!must_map_again_) inputs.clear();
    return inputs;
  }

 private:
  static constexpr std::size_t kMaxNum = 3000;

  void drop() {
    is_complete_ = false;
    inputs_ = {};
  }

  bool is_on_;
  std::map<std::uint32_t, RobotParts> of_scanner_;
  std::vector<MapperInput> inputs_;
  bool is_complete_ = true;  ///< Whether all that came is kept.
  bool must_map_again_ = false;
};

}  // namespace setsquare
