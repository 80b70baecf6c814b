// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// A table of loop closures: a header line, then one closure per line, tab-separated:
///   stamp_i stamp_j x_m y_m theta_rad axes accepted weight reason
/// Stamps have six decimals, as in trajectories; x_m, y_m and theta_rad are T_i_j; axes is one of
/// xy, x, y; accepted is 0 or 1; numbers have as few digits as read back to the same double.
/// Control characters of a reason (a tab, a line's end) are written as blanks.
[[nodiscard]] std::string tsv_from_closures(std::span<const LoopClosure> closures);

/// Reads such a table, plain or gzip; a table without closures is valid. Empty lines are skipped.
/// Throws FileError; FormatError with the line where the header or a row is not as above, a number
/// is not finite or a weight is outside [0, 1].
[[nodiscard]] std::vector<LoopClosure> read_closures_tsv(const std::string& path);
[[nodiscard]] std::vector<LoopClosure> read_closures_tsv(std::unique_ptr<ByteSource> source,
                                                         const std::string& name);

}  // namespace setsquare
