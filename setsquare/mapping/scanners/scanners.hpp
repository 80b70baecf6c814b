// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "setsquare/map/mapped_scanner.hpp"
#include "setsquare/mapping/scanners/mounting_trial.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// The robot's scanners: which of them a map is made of. The first one is; each further one when
/// its mounting has been confirmed (MountingTrial). One that is refused changes nothing: the map is
/// the same as without its scans.
class Scanners {
 public:
  explicit Scanners(const MountingTrialParams& params) : params_(params) {}

  /// Whether a scan is to be mapped; counts it. One that is not may be tried: it is placed by the
  /// tracker, which goes on as if it had not come.
  [[nodiscard]] bool admit(const Scan& scan,
                           const std::optional<Pose2>& T_wheels_base,
                           ScanTracker& tracker);

  /// What is known of each, in the order in which they came.
  [[nodiscard]] std::vector<MappedScanner> results() const;

 private:
  struct Scanner {
    MountingTrial trial;
    bool is_reference = false;
    std::size_t num_scans = 0;
    std::size_t num_mapped = 0;
  };

  Scanner& scanner_of(const Scan& scan);
  void try_scan(const Scan& scan,
                const std::optional<Pose2>& T_wheels_base,
                ScanTracker& tracker,
                MountingTrial& trial) const;

  MountingTrialParams params_;
  std::map<std::uint32_t, Scanner> scanners_;
  std::vector<std::uint32_t> order_;
};

}  // namespace setsquare
