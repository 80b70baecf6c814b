// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Maps in which every field has a value of its own, and all fields of a map as text: what a map
// file is compared with.
#pragma once

#include <cstdint>
#include <string>

#include "setsquare/io/map_file/map_file.hpp"

namespace setsquare::testing {

/// A valid map of so many scans, a few of everything in it, all values drawn. The same seed gives
/// the same map on every machine and ever after: files of the formats are made of it.
[[nodiscard]] SavedMap made_map(std::uint64_t seed, std::size_t num_scans);

/// Every field by its name, numbers bit for bit. Two maps are the same where the texts are.
[[nodiscard]] std::string text_of(const SavedMap& saved);

}  // namespace setsquare::testing
