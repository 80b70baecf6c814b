// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace setsquare::app {

/// Names of the files that a run reads, as they were given; "-" is standard input.
using InputPaths = std::vector<std::string>;

/// No run writes onto its input. Throws FileError where `target` is the same file as one of the
/// inputs, by whatever name, through whatever link.
void refuse_input(const std::filesystem::path& target, const InputPaths& inputs);

}  // namespace setsquare::app
