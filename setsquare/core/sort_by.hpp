// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace setsquare {

/// The positions of the keys, that of the least first; equal ones stay in their order.
[[nodiscard]] std::vector<std::size_t> order_of(std::span<const double> keys);

/// Sorts by a number of each value, the least first; equal ones stay in their order. `key` is a
/// member or a function of a value; an integer is below 2^53. Not std::stable_sort: that is
/// compiled for each kind of value anew, for one or two seconds where values own memory.
template <typename Value, typename Key>
void sort_by(std::vector<Value>& values, Key&& key) {
  std::vector<double> keys;
  keys.reserve(values.size());
  for (const Value& value : values) {
    keys.push_back(static_cast<double>(std::invoke(key, value)));
  }
  std::vector<Value> sorted;
  sorted.reserve(values.size());
  for (const std::size_t i : order_of(keys)) sorted.push_back(std::move(values[i]));
  values = std::move(sorted);
}

/// sort_by() with the greatest first.
template <typename Value, typename Key>
void sort_by_greatest(std::vector<Value>& values, Key&& key) {
  sort_by(values,
          [&](const Value& value) { return -static_cast<double>(std::invoke(key, value)); });
}

}  // namespace setsquare
