// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper_params.hpp"

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

void MapperParams::validate() const {
  tracker.validate();
  mounting.validate();
  direction.validate();
  motion.validate();
  heading.validate();
  turns.validate();
  closing.validate();
  robust.validate();
  joining.validate();
  registration.validate();
  anywhere.validate();
  audit.validate();
  if (!(confident_margin > 1.0)) throw ParameterError("confident_margin", "must be above 1");
  require_not_negative(closing_growth, "closing_growth");
  require_at_least_one(min_closing_growth, "min_closing_growth");
}

}  // namespace setsquare
