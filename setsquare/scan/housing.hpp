// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan.cpp, which judges ranges, because logs are asked how many such ranges they hold.
#pragma once

namespace setsquare {

/// Ranges below it would end inside the scanner: they are no measurements. Scanners of Hokuyo write
/// error codes of 1 to 19 mm as ranges (SCIP 2.0).
inline constexpr double kHousingRadius_m = 0.03;

}  // namespace setsquare
