// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace setsquare {

/// Sets of connected nodes: each node alone at first, then joined two by two.
class NodeSets {
 public:
  explicit NodeSets(std::size_t num_nodes) : parent_(num_nodes), num_sets_(num_nodes) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The lowest node of the set that a node is in.
  [[nodiscard]] std::size_t lowest(std::size_t node) {
    while (parent_[node] != node) {
      parent_[node] = parent_[parent_[node]];
      node = parent_[node];
    }
    return node;
  }

  void join(std::size_t a, std::size_t b) {
    a = lowest(a);
    b = lowest(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --num_sets_;
  }

  [[nodiscard]] std::size_t num_sets() const { return num_sets_; }

 private:
  std::vector<std::size_t> parent_;
  std::size_t num_sets_ = 0;
};

}  // namespace setsquare
