// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::experiments {

/// Relative pose of current in reference by another's method; nothing where it fails.
using PeerMatcher = std::function<std::optional<Pose2>(const Scan& reference, const Scan& current)>;

/// MRPT's ICP as the paper ran it: Levenberg-Marquardt, default parameters, zero guess. Loads
/// libsetsquare_mrpt_icp.so from beside the running command, or from where it is installed; an
/// empty function where it was not built or MRPT is not installed. It stays loaded.
[[nodiscard]] PeerMatcher load_mrpt_icp();

}  // namespace setsquare::experiments
