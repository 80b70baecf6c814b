// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::peers {

enum class MrptIcpAlgorithm {
  kClassic,             ///< MRPT's default.
  kLevenbergMarquardt,  ///< The one that the paper compares itself with.
};

/// The pose of current's sensor in reference's by MRPT's CICP with its default parameters and an
/// initial guess of zero, both point maps built from the ranges on the way.
[[nodiscard]] Pose2 match_by_mrpt_icp(const Scan& reference,
                                      const Scan& current,
                                      MrptIcpAlgorithm algorithm);

}  // namespace setsquare::peers
