// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/evidence.hpp"

namespace setsquare::testing {

/// A robot's true headings, and the evidence that a tracker and the walls give of them.
struct SimulatedHeadings {
  std::vector<double> heading_rad;
  std::vector<HeadingEvidence> evidence;
};

struct HeadingSimulation {
  std::size_t num_keyframes = 400;
  double drift_per_step_rad = 0.0;  ///< A steady drift of the tracker ...
  double step_noise_rad = 0.0;      ///< ... and a random one.
  double measurement_noise_rad = 0.0;
  double outlier_share = 0.0;  ///< Measurements anywhere within the quarter turn.
  /// Wings of the building, one after the other and around again, by their walls' offset.
  std::vector<double> wing_offset_rad = {0.0};
  std::size_t keyframes_per_wing = 100;
};

/// Turns of every size, several times around; each measurement is taken modulo a quarter turn.
inline SimulatedHeadings simulate_headings(const HeadingSimulation& simulation,
                                           std::mt19937_64& generator) {
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  SimulatedHeadings simulated;
  double drift_rad = 0.3;  // The tracker starts in its own frame.
  for (std::size_t k = 0; k < simulation.num_keyframes; ++k) {
    const double t = static_cast<double>(k);
    const double heading_rad = 0.04 * t + 1.5 * std::sin(0.05 * t);
    drift_rad += simulation.drift_per_step_rad + simulation.step_noise_rad * normal(generator);
    const std::size_t wing = k / simulation.keyframes_per_wing % simulation.wing_offset_rad.size();
    double measured_rad = heading_rad + simulation.wing_offset_rad[wing] +
                          simulation.measurement_noise_rad * normal(generator);
    if (share(generator) < simulation.outlier_share) measured_rad = 0.5 * kPi * share(generator);
    simulated.heading_rad.push_back(heading_rad);
    simulated.evidence.push_back(
        {.tracked_heading_rad = wrap_to_pi(heading_rad - drift_rad),
         .step_sigma_rad = rad_from_deg(0.1),
         .proposals = {{.heading_rad = wrap_to_period(measured_rad, 0.5 * kPi),
                        .sigma_rad = rad_from_deg(0.1),
                        .confidence = 1.0}}});
  }
  return simulated;
}

}  // namespace setsquare::testing
