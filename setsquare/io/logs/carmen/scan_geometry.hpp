// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The lowest value that CARMEN logs of SICK scanners use for "nothing seen" (81.83 and 81.91
/// elsewhere).
inline constexpr double kSickLowestCode_m = 50.0;

/// Bearings of a message that carries no angles, from the number of beams (LogOptions).
void set_symmetric_bearings(Scan& scan, const LogOptions& options);

/// Bearings of a message that carries them; a step of 0 is taken from the field of view.
void set_stated_bearings(Scan& scan, double start_rad, double field_of_view_rad, double step_rad);

/// The reach from which ranges are no-returns, in m. SICK's own 81.90 or 81.91 is taken down to
/// 81.83, where its error codes begin; a reach that is not positive stands for "not stated".
[[nodiscard]] double max_range_from_stated(double stated_m);

}  // namespace setsquare
