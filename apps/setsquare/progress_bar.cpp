// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace setsquare::app {

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      last_drawn_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
  if (is_drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressBar::advance(std::optional<double> fraction) {
  ++num_items_;
  if (!is_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_drawn_ < std::chrono::milliseconds(100)) return;
  last_drawn_ = now;
  draw(fraction);
}

void ProgressBar::draw(std::optional<double> fraction) {
  std::cerr << "\r\x1b[K" << label_ << " ";
  if (fraction) {
    constexpr std::size_t kWidth = 30;
    const double share = std::clamp(*fraction, 0.0, 1.0);
    const auto num_full = static_cast<std::size_t>(share * static_cast<double>(kWidth));
    std::cerr << "[" << std::string(num_full, '#') << std::string(kWidth - num_full, '.') << "] "
              << std::lround(100.0 * share) << " % ";
  }
  std::cerr << "(" << num_items_ << ")" << std::flush;
  is_drawn_ = true;
}

}  // namespace setsquare::app
