// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// How far a step from scan to scan goes, or may go.
struct StepReach {
  double distance_m = 0.0;  ///< As the crow flies.
  double turn_rad = 0.0;    ///< Not negative.
};

}  // namespace setsquare
