// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace setsquare::testing {

/// The path of a real log or relations file, such as "intel/intel.clf", in the folder that
/// SETSQUARE_DATA_DIR names (default: ../shared/data next to the project); nothing where it is
/// absent: such a test calls GTEST_SKIP.
[[nodiscard]] std::optional<std::filesystem::path> data_file(const std::string& name);

}  // namespace setsquare::testing
