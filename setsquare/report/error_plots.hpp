// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Pictures for papers of how far a trajectory is from the true one, as SVG.
#pragma once

#include <span>
#include <string>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {

/// Errors one by one in the order of time; all three are as long.
struct PlottedErrors {
  std::span<const Timestamp> stamps;
  std::span<const double> translation_m;
  std::span<const double> rotation_rad;
};

/// Both errors over the time since the first one, one diagram above the other.
[[nodiscard]] std::string error_plot_svg(const PlottedErrors& errors);

/// A trajectory laid onto its reference, at one scale; each has a pose at least.
[[nodiscard]] std::string trajectory_plot_svg(const Trajectory& aligned,
                                              const Trajectory& reference);

}  // namespace setsquare
