// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/surfaces/surface_points.hpp"

namespace setsquare {
/// Length of wall by the direction that it faces: bins of two degrees of the walls' normals. Walls
/// face the sensor, so opposite walls fall into opposite bins and a half turn shows.
struct AngleHistogram {
  /// Of two degrees each.
  static constexpr int kNumBins = 180;
  /// Direction of a bin's middle, in rad, in [-pi, pi).
  [[nodiscard]] static constexpr double direction_rad(int bin) {
    return (bin + 0.5) * (kTwoPi / kNumBins) - kPi;
  }
  /// The bin of a wall's unit normal; not for the zero of a point without a line.
  [[nodiscard]] static int bin_of(float normal_x, float normal_y);

  std::array<float, kNumBins> length_m{};  ///< Smoothed over a few bins.
};

/// The histogram of a scan's walls; points without a line do not count.
[[nodiscard]] AngleHistogram angle_histogram(const SurfacePoints& points);

/// A rotation that lays the current scan's walls on the reference's.
struct RotationProposal {
  double rotation_rad = 0.0;  ///< Of T_reference_current, in [-pi, pi).
  double correlation = 0.0;   ///< Normalised: 1 for equal histograms.
};

/// The highest separated peaks of the histograms' circular correlation, best first: the rotations
/// under which the walls of the two scans face the same ways (as in Hough scan matching, where the
/// spectra of the two scans are correlated).
[[nodiscard]] std::vector<RotationProposal> propose_rotations(const AngleHistogram& reference,
                                                              const AngleHistogram& current,
                                                              std::size_t max_proposals);

/// Weights of the points, in m, in which rare directions count for more: a wall's length divided by
/// the square root of the share of all walls that run its way; the sum stays. Along a corridor the
/// few door frames across it decide, not the metres of wall that fit anywhere (compare normal-space
/// sampling, Rusinkiewicz and Levoy 2001). Points without a line keep their weight.
[[nodiscard]] std::vector<float> direction_balanced_weights(const SurfacePoints& points,
                                                            const AngleHistogram& histogram);

}  // namespace setsquare
