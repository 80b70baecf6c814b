// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace setsquare {

/// Keeps the `count` proposals of the highest correlation, in no order, and returns the correlation
/// that a further one must reach: 0 while there are no more than that.
template <typename Proposal>
int keep_best(std::size_t count, std::vector<Proposal>& proposals) {
  if (proposals.size() <= count) return 0;
  const auto last = proposals.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(proposals.begin(), last, proposals.end(), [](const auto& a, const auto& b) {
    return a.correlation > b.correlation;
  });
  proposals.resize(count);
  return proposals.back().correlation;
}

}  // namespace setsquare
