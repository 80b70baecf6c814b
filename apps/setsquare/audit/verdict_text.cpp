// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/audit/verdict_text.hpp"

#include <fmt/core.h>

#include "setsquare/map/map_verdict.hpp"

namespace setsquare::app {

std::string verdict_text(const Map& map) {
  if (!map.audit) return {};
  std::string text = "map: " + map_verdict(map) + "\n";
  for (std::size_t i = 0; i < map.doubts.size(); ++i) {
    const MapDoubt& doubt = map.doubts[i];
    text += fmt::format("  {}. at ({:.1f}, {:.1f}) m, {}: {}\n",
                        i + 1,
                        doubt.place_m.x(),
                        doubt.place_m.y(),
                        to_string(doubt.kind),
                        doubt.reason);
  }
  return text;
}

}  // namespace setsquare::app
