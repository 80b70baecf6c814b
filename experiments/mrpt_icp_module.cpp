// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// libsetsquare_mrpt_icp.so: MRPT's ICP for `setsquare experiment`, loaded on demand. Linked into
// the command, MRPT's 290 libraries would cost every start 0.2 s.
#include <exception>

#include "benchmarks/peers/mrpt_icp.hpp"

/// The relative pose by MRPT's ICP (Levenberg-Marquardt, default parameters, zero guess) into
/// `T_reference_current`; false where MRPT throws. Both sides are built from one tree.
extern "C" bool setsquare_mrpt_icp(const setsquare::Scan* reference,
                                   const setsquare::Scan* current,
                                   setsquare::Pose2* T_reference_current) {
  try {
    *T_reference_current = setsquare::peers::match_by_mrpt_icp(
        *reference, *current, setsquare::peers::MrptIcpAlgorithm::kLevenbergMarquardt);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}
