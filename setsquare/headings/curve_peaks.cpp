// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/curve_peaks.hpp"

#include <algorithm>
#include <numeric>

#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

bool is_local_maximum(std::span<const double> curve, std::size_t k) {
  const std::size_t size = curve.size();
  return curve[k] > 0.0 && curve[k] >= curve[(k + 1) % size] &&
         curve[k] >= curve[(k + size - 1) % size];
}

CurvePeak peak_at(std::span<const double> curve, std::size_t k, double mean) {
  const std::size_t size = curve.size();
  const double before = curve[(k + size - 1) % size];
  const double after = curve[(k + 1) % size];
  const double bend = before - 2.0 * curve[k] + after;
  double position = static_cast<double>(k) + (bend < 0.0 ? 0.5 * (before - after) / bend : 0.0);
  if (position < 0.0) position += static_cast<double>(size);
  if (position >= static_cast<double>(size)) position -= static_cast<double>(size);
  return {position, curve[k], curve[k] / mean};
}

}  // namespace

std::vector<CurvePeak> highest_peaks(std::span<const double> curve,
                                     std::size_t max_num_peaks,
                                     std::size_t min_separation) {
  const std::size_t size = curve.size();
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < size; ++k) {
    if (is_local_maximum(curve, k)) order.push_back(k);
  }
  sort_by_greatest(order, [&curve](std::size_t k) { return curve[k]; });
  const double sum = std::accumulate(curve.begin(), curve.end(), 0.0);
  std::vector<std::size_t> chosen;
  std::vector<CurvePeak> peaks;
  for (const std::size_t k : order) {
    if (peaks.size() == max_num_peaks) break;
    const bool is_apart = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      const std::size_t distance = k > other ? k - other : other - k;
      return std::min(distance, size - distance) >= min_separation;
    });
    if (!is_apart) continue;
    chosen.push_back(k);
    peaks.push_back(peak_at(curve, k, sum / static_cast<double>(size)));
  }
  return peaks;
}

}  // namespace setsquare
