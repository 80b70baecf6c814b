// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/nice_number.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace setsquare {
namespace {

constexpr double kRoundingSlack = 1e-9;

}  // namespace

double nice_number_below(double value) {
  assert(value > 0.0 && std::isfinite(value));
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / power + kRoundingSlack;
  return power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

std::vector<double> nice_ticks(double low, double high, int max_count) {
  assert(low < high && max_count >= 2);
  double step = nice_number_below((high - low) / max_count);
  const auto first = [&] { return std::ceil(low / step - kRoundingSlack); };
  const auto last = [&] { return std::floor(high / step + kRoundingSlack); };
  while (last() - first() + 1.0 > max_count) step = nice_number_below(step * 2.5);
  std::vector<double> ticks;
  for (double k = first(); k <= last(); k += 1.0) ticks.push_back(k * step);
  return ticks;
}

int decimals_for_step(double step) {
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + kRoundingSlack)), 0, 9);
}

}  // namespace setsquare
