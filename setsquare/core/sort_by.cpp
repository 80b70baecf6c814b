// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/sort_by.hpp"

#include <algorithm>
#include <numeric>

namespace setsquare {

std::vector<std::size_t> order_of(std::span<const double> keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [keys](std::size_t a, std::size_t b) {
    return keys[a] < keys[b];
  });
  return order;
}

}  // namespace setsquare
