// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace setsquare {

/// How a scanner measures. Bearings in its own frame.
struct ScannerModel {
  std::string name;
  std::size_t num_beams = 0;
  double first_bearing_rad = 0.0;
  double bearing_step_rad = 0.0;
  double min_range_m = 0.0;
  double max_range_m = 0.0;
  double noise_share = 0.0;        ///< Standard deviation as a share of the range, up to a cap:
  double near_noise_m = 0.0;       ///< the cap below 10 m,
  double far_noise_m = 0.0;        ///< and beyond.
  double resolution_m = 0.0;       ///< Ranges are rounded to multiples of it.
  double divergence_rad = 0.0;     ///< Full width of the beam: where it meets an edge, ranges mix.
  double dropout_share = 0.0;      ///< Beams that return nothing, whatever is there.
  double sweep_s = 0.0;            ///< From the first beam to the last.
  double beam_count_jitter = 0.0;  ///< The number of beams varies from scan to scan by this share.
};

/// Standard deviation of a range's noise, in m.
[[nodiscard]] double range_noise_m(const ScannerModel& scanner, double range_m);

/// Hokuyo UTM-30LX as its data sheet says: 270 deg, 0.25 deg, 30 m, 40 Hz. Divergence and
/// drop-outs, of which the data sheet says nothing, are ours.
[[nodiscard]] ScannerModel utm_30lx();
/// A cheap rotating scanner: about 360 beams around, 8 m, 10 Hz, changing beam count.
[[nodiscard]] ScannerModel low_cost_360();

/// One of them by its name: "utm-30lx" or "low-cost-360". Throws ParameterError.
[[nodiscard]] ScannerModel scanner_named(std::string_view name);
/// The same scanner with another field of view about the front and the same step; 2 pi at most.
/// Throws ParameterError where that is not positive, too wide, or less than a step.
[[nodiscard]] ScannerModel with_field_of_view(ScannerModel model, double field_of_view_rad);
/// The same field of view with fewer beams, evenly over it.
/// Throws ParameterError for less than 2.
[[nodiscard]] ScannerModel with_num_beams(ScannerModel model, std::size_t num_beams);

}  // namespace setsquare
