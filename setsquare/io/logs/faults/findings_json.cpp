// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/faults/findings_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace setsquare {

std::string findings_json(const std::vector<LogFinding>& findings) {
  using Json = nlohmann::ordered_json;
  Json array = Json::array();
  for (const LogFinding& finding : findings) {
    array.push_back(
        {{"kind", to_string(finding.kind)},
         {"sentence", finding.sentence},
         {"share", finding.share ? Json(std::round(*finding.share * 1e6) / 1e6) : Json()},
         {"option", finding.option.empty() ? Json() : Json(finding.option)}});
  }
  // A laser's name need not be UTF-8: what is not is replaced.
  return array.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace setsquare
