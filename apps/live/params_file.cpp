// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/params_file.hpp"

#include <yaml-cpp/yaml.h>

#include "setsquare/core/error.hpp"

namespace setsquare::live_app {
namespace {

constexpr const char* kParameters = "ros__parameters";

bool is_ours(const std::string& node) {
  const std::string name = node.substr(node.rfind('/') + 1);
  return name == "setsquare" || name == "slam_toolbox" || name == "**";
}

void add_params(const YAML::Node& parameters, NodeParams& params) {
  for (const auto& entry : parameters) {
    std::vector<std::string>& values = params[entry.first.as<std::string>()];
    values.clear();
    if (entry.second.IsScalar()) values.push_back(entry.second.Scalar());
    if (!entry.second.IsSequence()) continue;
    for (const YAML::Node& value : entry.second) values.push_back(value.Scalar());
  }
}

/// Nodes may stand within namespaces: a map that has no parameters is one.
void add_nodes(const YAML::Node& nodes, int depth, NodeParams& params) {
  constexpr int kDeepest = 8;
  if (!nodes.IsMap() || depth > kDeepest) return;
  for (const auto& entry : nodes) {
    if (!entry.second.IsMap()) continue;
    const YAML::Node parameters = entry.second[kParameters];
    if (!parameters.IsDefined()) {
      add_nodes(entry.second, depth + 1, params);
    } else if (is_ours(entry.first.as<std::string>()) && parameters.IsMap()) {
      add_params(parameters, params);
    }
  }
}

}  // namespace

NodeParams read_params_file(const std::string& path) {
  NodeParams params;
  try {
    const YAML::Node file = YAML::LoadFile(path);
    add_nodes(file, 0, params);
  } catch (const YAML::BadFile&) {
    throw FileError(path, "cannot be read");
  } catch (const YAML::Exception& error) {
    throw FormatError(path, "line " + std::to_string(error.mark.line + 1), error.msg);
  }
  if (params.empty()) {
    throw FormatError(path, "", "no ros__parameters of a node setsquare, slam_toolbox or /**");
  }
  return params;
}

}  // namespace setsquare::live_app
