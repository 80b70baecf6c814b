// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// The content of poses.tsv: every scan of the map in its order, placed or not, with its pose and
/// how much it is to be believed. A header line, then a row per scan, by tabs; docs/formats.md has
/// the columns.
[[nodiscard]] std::string poses_tsv(const Map& map, PoseOf pose_of = PoseOf::kBase);

}  // namespace setsquare
