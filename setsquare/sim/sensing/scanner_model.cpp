// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/scanner_model.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr double kRoundingSlack_rad = 1e-6;

/// The angle swept between the outermost beams.
double sweep_rad(const ScannerModel& model) {
  return model.bearing_step_rad * static_cast<double>(model.num_beams - 1);
}

bool is_full_turn(const ScannerModel& model) {
  return sweep_rad(model) + model.bearing_step_rad >= kTwoPi - kRoundingSlack_rad;
}

/// The mirror turns as fast as before.
void set_beams(ScannerModel& model, std::size_t num_beams, double step_rad, double first_rad) {
  const double new_sweep_rad = step_rad * static_cast<double>(num_beams - 1);
  model.sweep_s *= new_sweep_rad / sweep_rad(model);
  model.num_beams = num_beams;
  model.bearing_step_rad = step_rad;
  model.first_bearing_rad = first_rad;
}

}  // namespace

double range_noise_m(const ScannerModel& scanner, double range_m) {
  constexpr double kFar_m = 10.0;
  const double cap_m = range_m < kFar_m ? scanner.near_noise_m : scanner.far_noise_m;
  return std::min(scanner.noise_share * range_m, cap_m);
}

ScannerModel utm_30lx() {
  return {.name = "UTM-30LX",
          .num_beams = 1081,
          .first_bearing_rad = rad_from_deg(-135.0),
          .bearing_step_rad = rad_from_deg(0.25),
          .min_range_m = 0.1,
          .max_range_m = 30.0,
          // Repeatability of the data sheet: sigma below 10 mm up to 10 m, below 30 mm beyond.
          .noise_share = 0.01,
          .near_noise_m = 0.010,
          .far_noise_m = 0.030,
          .resolution_m = 0.001,
          // Not in the data sheet. A little wider than the step: the spots of neighbouring beams
          // overlap, so nothing slips through between two beams.
          .divergence_rad = rad_from_deg(0.35),
          .dropout_share = 0.002,
          .sweep_s = 0.025 * 270.0 / 360.0};
}

ScannerModel low_cost_360() {
  constexpr std::size_t kNumBeams = 360;
  return {.name = "low-cost-360",
          .num_beams = kNumBeams,
          .first_bearing_rad = -kPi,
          .bearing_step_rad = kTwoPi / kNumBeams,
          .min_range_m = 0.15,
          .max_range_m = 8.0,
          .noise_share = 0.01,
          .near_noise_m = 0.015,
          .far_noise_m = 0.040,
          .resolution_m = 0.001,
          .divergence_rad = rad_from_deg(0.5),
          .dropout_share = 0.01,
          .sweep_s = 0.1 * (kNumBeams - 1) / kNumBeams,
          .beam_count_jitter = 0.02};
}

ScannerModel scanner_named(std::string_view name) {
  if (name == "utm-30lx") return utm_30lx();
  if (name == "low-cost-360") return low_cost_360();
  throw ParameterError("scanner", "must be \"utm-30lx\" or \"low-cost-360\"");
}

ScannerModel with_field_of_view(ScannerModel model, double field_of_view_rad) {
  if (!(field_of_view_rad > 0.0) || field_of_view_rad > kTwoPi + kRoundingSlack_rad) {
    throw ParameterError("field_of_view_rad", "must be positive and at most a full turn");
  }
  const double step_rad = model.bearing_step_rad;
  if (field_of_view_rad + 0.5 * step_rad >= kTwoPi) {
    const auto num_beams = static_cast<std::size_t>(std::lround(kTwoPi / step_rad));
    set_beams(model, num_beams, kTwoPi / static_cast<double>(num_beams), -kPi);
    return model;
  }
  const auto num_steps = static_cast<std::size_t>(std::lround(field_of_view_rad / step_rad));
  if (num_steps == 0) throw ParameterError("field_of_view_rad", "is less than a step");
  set_beams(model, num_steps + 1, step_rad, -0.5 * step_rad * static_cast<double>(num_steps));
  return model;
}

ScannerModel with_num_beams(ScannerModel model, std::size_t num_beams) {
  if (num_beams < 2) throw ParameterError("num_beams", "must be at least 2");
  const double step_rad = is_full_turn(model)
                              ? kTwoPi / static_cast<double>(num_beams)
                              : sweep_rad(model) / static_cast<double>(num_beams - 1);
  set_beams(model, num_beams, step_rad, model.first_bearing_rad);
  return model;
}

}  // namespace setsquare
