// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace setsquare::app {

/// A line on standard error that shows how far a run is; only on a terminal, and gone at the end.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Counts one more item and, ten times per second, draws the line. `fraction` is 0 to 1, nothing
  /// where the end is unknown.
  void advance(std::optional<double> fraction);

 private:
  void draw(std::optional<double> fraction);

  std::string label_;
  bool is_terminal_ = false;
  bool is_drawn_ = false;
  std::size_t num_items_ = 0;
  std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace setsquare::app
