// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/scanner_model.hpp"

#include <gmock/gmock.h>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::scanner_model_test {

double last_bearing_deg(const ScannerModel& model) {
  return deg_from_rad(model.first_bearing_rad +
                      model.bearing_step_rad * static_cast<double>(model.num_beams - 1));
}

TEST(ScannerModelTest, Utm30lxIsThatOfTheDataSheet) {
  const ScannerModel model = utm_30lx();
  EXPECT_EQ(model.num_beams, 1081u);
  EXPECT_NEAR(last_bearing_deg(model), 135.0, 1e-9);
  EXPECT_DOUBLE_EQ(range_noise_m(model, 0.5), 0.005);
  EXPECT_DOUBLE_EQ(range_noise_m(model, 9.9), 0.010);
  EXPECT_DOUBLE_EQ(range_noise_m(model, 25.0), 0.030);
  EXPECT_LT(deg_from_rad(model.divergence_rad), 1.0);
  EXPECT_NEAR(model.sweep_s, 0.01875, 1e-12);
}

TEST(ScannerModelTest, FieldOfViewKeepsTheStepAndTheMirrorsSpeed) {
  const ScannerModel half = with_field_of_view(utm_30lx(), kPi);
  EXPECT_EQ(half.num_beams, 721u);
  EXPECT_NEAR(deg_from_rad(half.first_bearing_rad), -90.0, 1e-9);
  EXPECT_NEAR(last_bearing_deg(half), 90.0, 1e-9);
  EXPECT_NEAR(half.sweep_s, 0.0125, 1e-12);

  const ScannerModel all_around = with_field_of_view(utm_30lx(), kTwoPi);
  EXPECT_EQ(all_around.num_beams, 1440u) << "no bearing twice";
  EXPECT_NEAR(deg_from_rad(all_around.first_bearing_rad), -180.0, 1e-9);
  EXPECT_NEAR(last_bearing_deg(all_around), 179.75, 1e-9);
  EXPECT_NEAR(all_around.sweep_s, 0.025 * 1439 / 1440, 1e-12);

  const ScannerModel back = with_field_of_view(all_around, rad_from_deg(270.0));
  EXPECT_EQ(back.num_beams, utm_30lx().num_beams);
  EXPECT_NEAR(back.sweep_s, utm_30lx().sweep_s, 1e-12);
}

TEST(ScannerModelTest, FewerBeamsSpreadOverTheSameField) {
  for (const std::size_t num_beams : {11u, 54u, 541u}) {
    const ScannerModel thinned = with_num_beams(utm_30lx(), num_beams);
    EXPECT_EQ(thinned.num_beams, num_beams);
    EXPECT_NEAR(deg_from_rad(thinned.first_bearing_rad), -135.0, 1e-9);
    EXPECT_NEAR(last_bearing_deg(thinned), 135.0, 1e-9);
    EXPECT_NEAR(thinned.sweep_s, utm_30lx().sweep_s, 1e-12);
  }
  const ScannerModel cheap = with_num_beams(low_cost_360(), 36);
  EXPECT_NEAR(deg_from_rad(cheap.bearing_step_rad), 10.0, 1e-9);
  EXPECT_NEAR(last_bearing_deg(cheap), 170.0, 1e-9);
}

TEST(ScannerModelTest, RefusesWhatIsNoScanner) {
  EXPECT_THROW(static_cast<void>(with_num_beams(utm_30lx(), 1)), ParameterError);
  EXPECT_THROW(static_cast<void>(with_field_of_view(utm_30lx(), 0.0)), ParameterError);
  EXPECT_THROW(static_cast<void>(with_field_of_view(utm_30lx(), 0.001)), ParameterError);
  EXPECT_THROW(static_cast<void>(with_field_of_view(utm_30lx(), 7.0)), ParameterError);
}

}  // namespace setsquare::scanner_model_test
