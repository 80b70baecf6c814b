// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/prepared_keyframes.hpp"

namespace setsquare {

const PreparedScan& PreparedKeyframes::scan(std::size_t age) {
  Entry& asked = entries_[entries_.size() - 1 - age];
  if (!asked.scan) asked.scan = prepare(asked.keyframe->surfaces);
  return *asked.scan;
}

}  // namespace setsquare
