// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Exits with 0 where a scan judges its ranges as it should.
#include "setsquare/scan/scan.hpp"

int main() {
  setsquare::Scan scan;
  scan.bearing_step_rad = 0.01;
  scan.max_range_m = 30.0;
  scan.ranges_m = {1.0, 0.0, 40.0};
  const bool is_right = scan.outcome(0) == setsquare::BeamOutcome::kReturn &&
                        scan.outcome(1) == setsquare::BeamOutcome::kInvalid &&
                        scan.outcome(2) == setsquare::BeamOutcome::kNoReturn;
  return is_right ? 0 : 1;
}
