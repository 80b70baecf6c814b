// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace setsquare::live_app {

/// How long after the scan its pose was there: a histogram in bounded memory, whose bins are a
/// twentieth wide.
class Latencies {
 public:
  void add(double latency_s) {
    const double bin = std::log(std::max(latency_s, kFirst_s) / kFirst_s) / std::log(kWidth);
    ++num_[std::min(static_cast<std::size_t>(bin), num_.size() - 1)];
    ++sum_;
    worst_s_ = std::max(worst_s_, latency_s);
  }

  /// So that this share of the poses came within it; 0 where there are none.
  [[nodiscard]] double quantile_s(double share) const {
    std::size_t below = 0;
    for (std::size_t bin = 0; bin < num_.size(); ++bin) {
      below += num_[bin];
      if (sum_ > 0 && static_cast<double>(below) >= share * static_cast<double>(sum_)) {
        return std::min(kFirst_s * std::pow(kWidth, static_cast<double>(bin) + 1.0), worst_s_);
      }
    }
    return worst_s_;
  }
  [[nodiscard]] double worst_s() const { return worst_s_; }
  [[nodiscard]] std::size_t num() const { return sum_; }

  /// "half within 0.9 ms, 99 % within 2.1 ms, the worst 15 ms".
  [[nodiscard]] std::string text() const {
    return fmt::format("half within {:.2g} ms, 99 % within {:.2g} ms, the worst {:.3g} ms",
                       1e3 * quantile_s(0.5),
                       1e3 * quantile_s(0.99),
                       1e3 * worst_s_);
  }

 private:
  static constexpr double kFirst_s = 1e-5;
  static constexpr double kWidth = 1.05;

  std::array<std::size_t, 320> num_{};  ///< To 60 s.
  std::size_t sum_ = 0;
  double worst_s_ = 0.0;
};

}  // namespace setsquare::live_app
