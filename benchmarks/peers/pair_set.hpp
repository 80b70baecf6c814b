// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::peers {

/// Two scans of a log and the truth about them: the pose of the robot (base) at the current scan
/// in the robot's frame at the reference scan.
struct ScanPair {
  Scan reference;
  Scan current;
  Pose2 T_reference_current;
};

/// The pairs that a file of relations names, in its order, with their scans from the log. Throws
/// what the readers throw, and Error where a stamp is not in the log.
[[nodiscard]] std::vector<ScanPair> read_pair_set(const std::string& log_path,
                                                  const std::string& relations_path);

}  // namespace setsquare::peers
