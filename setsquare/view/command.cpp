// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/view/command.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace setsquare::view {
namespace {

using Json = nlohmann::json;

std::optional<double> finite_number(const Json& json, const char* name) {
  constexpr double kFarthest = 1e6;
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  if (!(std::abs(value) <= kFarthest)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Command> parse_command(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto what = json.find("do");
  if (what == json.end() || !what->is_string()) return std::nullopt;
  Command command;
  if (*what == "save") return command;
  if (*what == "pause") {
    const auto on = json.find("on");
    if (on == json.end() || !on->is_boolean()) return std::nullopt;
    command.kind = Command::Kind::kPause;
    command.is_on = on->get<bool>();
    return command;
  }
  const auto x_m = finite_number(json, "x");
  const auto y_m = finite_number(json, "y");
  const auto heading_rad = finite_number(json, "heading");
  if (*what != "set_pose" || !x_m || !y_m || !heading_rad) return std::nullopt;
  command.kind = Command::Kind::kSetPose;
  command.T_map_base = {*x_m, *y_m, *heading_rad};
  return command;
}

}  // namespace setsquare::view
