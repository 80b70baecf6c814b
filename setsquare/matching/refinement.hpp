// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "setsquare/surfaces/alignment.hpp"

namespace setsquare {

/// Gauss-Newton steps point to line, both ways, one step a tolerance: wide ones first to catch,
/// narrow ones last to settle. Where the walls leave a direction free the pose stays put along it.
[[nodiscard]] Pose2 refine(const AlignedScan& reference,
                           const AlignedScan& current,
                           const Pose2& T_reference_current,
                           std::span<const double> tolerances_m);

}  // namespace setsquare
