// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/scanners/scanners.hpp"

namespace setsquare {

Scanners::Scanner& Scanners::scanner_of(const Scan& scan) {
  const auto known = scanners_.find(scan.scanner);
  if (known != scanners_.end()) return known->second;
  order_.push_back(scan.scanner);
  Scanner scanner{.trial = MountingTrial(params_, scan.T_base_sensor),
                  .is_reference = scanners_.empty()};
  return scanners_.emplace(scan.scanner, std::move(scanner)).first->second;
}

bool Scanners::admit(const Scan& scan,
                     const std::optional<Pose2>& T_wheels_base,
                     ScanTracker& tracker) {
  Scanner& scanner = scanner_of(scan);
  ++scanner.num_scans;
  if (scanner.is_reference || scanner.trial.result().verdict == MountingVerdict::kConfirmed) {
    ++scanner.num_mapped;
    return true;
  }
  try_scan(scan, T_wheels_base, tracker, scanner.trial);
  return false;
}

void Scanners::try_scan(const Scan& scan,
                        const std::optional<Pose2>& T_wheels_base,
                        ScanTracker& tracker,
                        MountingTrial& trial) const {
  const TrackedPose expected = tracker.expected(scan, T_wheels_base);
  if (!trial.wants(expected.T_odom_body)) return;
  trial.add(expected.T_odom_body, expected.T_odom_sensor, tracker.sight(scan, T_wheels_base));
}

std::vector<MappedScanner> Scanners::results() const {
  std::vector<MappedScanner> results;
  for (const std::uint32_t number : order_) {
    const Scanner& scanner = scanners_.at(number);
    results.push_back(scanner.trial.result());
    MappedScanner& result = results.back();
    if (scanner.is_reference) result.verdict = MountingVerdict::kReference;
    result.scanner = number;
    result.num_scans = scanner.num_scans;
    result.num_mapped = scanner.num_mapped;
  }
  return results;
}

}  // namespace setsquare
