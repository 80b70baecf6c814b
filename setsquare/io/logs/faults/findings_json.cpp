// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/faults/findings_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace setsquare {
namespace {

using Json = nlohmann::ordered_json;  // One kind in the layer: each is compiled anew.

FindingKind kind_from(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(FindingKind::kDamagedRecords); ++i) {
    if (name == to_string(static_cast<FindingKind>(i))) return static_cast<FindingKind>(i);
  }
  return FindingKind::kRemark;
}

}  // namespace

std::string findings_json(const std::vector<LogFinding>& findings) {
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

std::vector<LogFinding> findings_from_json(const std::string& json) {
  std::vector<LogFinding> findings;
  const auto array = Json::parse(json, nullptr, false);
  if (!array.is_array()) return findings;
  const auto text_at = [](const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  for (const auto& object : array) {
    if (!object.is_object()) continue;
    LogFinding finding{.kind = kind_from(text_at(object, "kind")),
                       .sentence = text_at(object, "sentence"),
                       .option = text_at(object, "option")};
    if (const auto share = object.find("share"); share != object.end() && share->is_number()) {
      finding.share = share->get<double>();
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace setsquare
