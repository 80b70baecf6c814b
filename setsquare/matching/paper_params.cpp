// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/paper_params.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {

void PaperParams::validate() const {
  if (!(min_spacing_m > 0.0) || !std::isfinite(min_spacing_m)) {
    throw ParameterError("min_spacing_m", "must be positive");
  }
  direction().validate();
  shifts().validate(bins());
  if (!(max_rotation_rad >= 0.25 * kPi && max_rotation_rad <= kPi)) {
    throw ParameterError("max_rotation_rad", "must lie between an eighth and half of a turn");
  }
  if (!(min_zncc_product >= 0.0 && min_zncc_product < 1.0)) {
    throw ParameterError("min_zncc_product", "must lie in [0, 1)");
  }
  if (min_num_points < 1) throw ParameterError("min_num_points", "must be positive");
}

}  // namespace setsquare
