// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/zncc.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace setsquare {

double zncc(std::span<const std::int32_t> reference, std::span<const std::int32_t> current) {
  assert(reference.size() == current.size());
  // Exact integer sums: no two-pass mean, no cancellation.
  std::int64_t sum_r = 0, sum_c = 0, sum_rr = 0, sum_cc = 0, sum_rc = 0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    const std::int64_t r = reference[k];
    const std::int64_t c = current[k];
    sum_r += r;
    sum_c += c;
    sum_rr += r * r;
    sum_cc += c * c;
    sum_rc += r * c;
  }
  const auto n = static_cast<double>(reference.size());
  const auto scaled_covariance = [n](std::int64_t sum_ab, std::int64_t sum_a, std::int64_t sum_b) {
    return n * static_cast<double>(sum_ab) -
           static_cast<double>(sum_a) * static_cast<double>(sum_b);
  };
  const double variance_r = scaled_covariance(sum_rr, sum_r, sum_r);
  const double variance_c = scaled_covariance(sum_cc, sum_c, sum_c);
  if (!(variance_r > 0.0) || !(variance_c > 0.0)) return 0.0;
  const double covariance = scaled_covariance(sum_rc, sum_r, sum_c);
  return std::clamp(covariance / (std::sqrt(variance_r) * std::sqrt(variance_c)), -1.0, 1.0);
}

}  // namespace setsquare
