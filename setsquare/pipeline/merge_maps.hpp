// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Maps from files into one, in one call: what the command and the Python package do.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "setsquare/io/map_file/map_file.hpp"

namespace setsquare {

/// Merges maps (merge()) that were made under these names, and records that. Throws ParameterError
/// where a map cannot be gone on with; FileError, with its name and the reason, where one shares no
/// place with the others.
[[nodiscard]] SavedMap merge_maps(std::span<const SavedMap> maps,
                                  const std::vector<std::string>& names,
                                  std::size_t num_threads = 1);

/// The same of map files, or of the folders that `setsquare map` wrote. Throws as load_map_file(),
/// too.
[[nodiscard]] SavedMap merge_map_files(const std::vector<std::string>& paths,
                                       std::size_t num_threads = 1);

}  // namespace setsquare
