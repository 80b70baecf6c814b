// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "setsquare/core/angle.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Whether a return stands alone in front of what both its neighbours see, too narrow to be a
/// thing: nearer than both by 0.3 m and a fifth, and on 5 cm at most (the width that the beams
/// leave it). Sunlight, dust and drops make such returns, and mixed pixels do.
[[nodiscard]] bool is_isolated_return(const Scan& scan, std::size_t beam);

/// How many of a scan's returns stand alone.
[[nodiscard]] std::size_t num_isolated_returns(const Scan& scan);

/// Beams closer together than this meet the leg of a chair twice wherever a return of it would
/// count as isolated: those of a finer scanner are not things.
inline constexpr double kFineStep_rad = rad_from_deg(0.4);

/// The scan of a fine scanner with its isolated returns made invalid, where there are many (1 % of
/// the beams, and eight); nothing where the scan may stay as it is. A return that nothing stands
/// beside is no wall, and that others see through it contradicts nothing. Coarser scanners see legs
/// of chairs so, and are left alone.
[[nodiscard]] std::optional<Scan> without_isolated_returns(const Scan& scan);

}  // namespace setsquare
