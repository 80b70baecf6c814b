// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/audit_json.hpp"

#include "setsquare/core/rounded.hpp"

namespace setsquare {

nlohmann::ordered_json json_from_audit(const Map& map) {
  if (!map.audit) return nullptr;
  return {{"pairs", map.audit->num_pairs},
          {"matched", map.audit->num_matched},
          {"agreeing", map.audit->num_agreeing},
          {"contradicting", map.audit->num_contradicting},
          {"seconded", map.audit->num_seconded}};
}

nlohmann::ordered_json json_from_doubts(const Map& map) {
  auto array = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < map.doubts.size(); ++i) {
    const MapDoubt& doubt = map.doubts[i];
    array.push_back({{"number", i + 1},
                     {"kind", to_string(doubt.kind)},
                     {"x_m", rounded(doubt.place_m.x())},
                     {"y_m", rounded(doubt.place_m.y())},
                     {"first_scan", doubt.first_scan},
                     {"num_scans", doubt.num_scans},
                     {"first_stamp", to_string(doubt.first_stamp)},
                     {"last_stamp", to_string(doubt.last_stamp)},
                     {"reason", doubt.reason}});
  }
  return array;
}

}  // namespace setsquare
