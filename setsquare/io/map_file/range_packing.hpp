// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/io/bytes/byte_cursor.hpp"
#include "setsquare/io/bytes/byte_writer.hpp"

namespace setsquare::map_file {

/// Appends the ranges of a scan in the first of these forms that gives the same bits again:
///
/// 1. 16-bit whole numbers of 0.1 m, 1 cm, 1 mm or 0.1 mm: logs written as decimals;
/// 2. float: the messages of ROS;
/// 3. as the first with 32 bits;
/// 4. double.
///
/// Of whole numbers the two largest numbers stand for infinity and NaN.
void append_packed_ranges(ByteWriter& bytes, const std::vector<double>& ranges_m);

/// Reads them; false where the bytes are no ranges.
[[nodiscard]] bool read_packed_ranges(ByteCursor& bytes, std::vector<double>& ranges_m);

}  // namespace setsquare::map_file
