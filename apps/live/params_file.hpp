// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace setsquare::live_app {

/// Parameters of a node by name; each is a list, which mostly has one value.
using NodeParams = std::map<std::string, std::vector<std::string>>;

/// Reads a parameter file of ROS 2: those of the nodes "setsquare", "slam_toolbox" and "/**", with
/// or without a namespace. Later nodes of the file win. Throws FileError, FormatError.
[[nodiscard]] NodeParams read_params_file(const std::string& path);

}  // namespace setsquare::live_app
