// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What most fields of parameters must be. `name`: the field's, with its owner's where another
// struct has a field of that name. Each refuses what is not finite.
#pragma once

#include <cmath>
#include <string>

#include "setsquare/core/error.hpp"

namespace setsquare {

inline void require_finite(double value, const std::string& name) {
  if (!std::isfinite(value)) throw ParameterError(name, "must be a number");
}

inline void require_positive(double value, const std::string& name) {
  if (!(value > 0.0 && std::isfinite(value))) throw ParameterError(name, "must be positive");
}

inline void require_not_negative(double value, const std::string& name) {
  if (!(value >= 0.0 && std::isfinite(value))) throw ParameterError(name, "must not be negative");
}

/// Of a count, signed or not.
template <typename Count>
void require_at_least_one(Count value, const std::string& name) {
  if (value < Count{1}) throw ParameterError(name, "must be at least 1");
}

}  // namespace setsquare
