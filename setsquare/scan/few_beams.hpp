// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan, which knows no walls: what is found of a log, and what its matches may say.
#pragma once

#include <cstddef>

namespace setsquare {

/// Scans of fewer beams see no walls: the wall of a room needs a handful of beams for its line, and
/// a room has four.
inline constexpr std::size_t kFewestBeams = 32;

}  // namespace setsquare
