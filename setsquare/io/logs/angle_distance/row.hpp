// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace setsquare {

/// The numbers of one line of angles and distances, as hobby scanners print them.
struct AngleDistanceRow {
  std::vector<double> numbers;     ///< In the line's own units.
  bool starts_revolution = false;  ///< The line begins with "S", the mark of RPLIDAR's own program.
};

/// Reads a line of numbers between blanks, commas or semicolons. Names with a colon are passed over
/// ("theta: 12.5 Dist: 01234.00 Q: 47"). False where the line has anything else, or no two numbers.
[[nodiscard]] bool read_angle_distance_row(std::string_view line, AngleDistanceRow& row);

/// Whether one of the first lines of a text is such a row; what a program prints before is skipped.
[[nodiscard]] bool has_angle_distance_rows(std::string_view beginning);

}  // namespace setsquare
