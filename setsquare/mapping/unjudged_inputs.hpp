// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper, its only caller: what is kept, and until when, is a question of its own.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "setsquare/map/odometry_report.hpp"
#include "setsquare/mapping/sweep_search.hpp"

namespace setsquare {

/// Keeps what comes until the odometry has been judged (OdometryTrial). Where it is found to be
/// none, or another's, what came before was mapped by it wrongly and is to be mapped again.
class UnjudgedInputs {
 public:
  void add(const MapperScan& scan) {
    if (inputs_.empty() && !scan.T_wheels_base) close();  // there is none to be judged
    if (is_open_) inputs_.emplace_back(scan);
    if (inputs_.size() > kMaxNum) close();
  }
  void add(const MapperTurnRate& rate) {
    if (is_open_ && !inputs_.empty()) inputs_.emplace_back(rate);
  }

  /// All that came so far, once: where the odometry was found to be wrong. Else empty.
  [[nodiscard]] std::vector<MapperInput> take_to_map_again(OdometryVerdict verdict) {
    if (!is_open_ || verdict == OdometryVerdict::kOpen) return {};
    std::vector<MapperInput> inputs = std::exchange(inputs_, {});
    close();
    if (verdict == OdometryVerdict::kBelieved) inputs.clear();
    return inputs;
  }

  /// No more is kept.
  void close() {
    is_open_ = false;
    inputs_ = {};
  }

 private:
  static constexpr std::size_t kMaxNum = 3000;

  bool is_open_ = true;
  std::vector<MapperInput> inputs_;
};

}  // namespace setsquare
