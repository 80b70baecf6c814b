// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// Errors one by one, in the order of time: for plots, tables and bounds.
struct ErrorSeries {
  std::vector<Timestamp> stamps;      ///< Of each; where it spans two moments, of the first.
  std::vector<double> translation_m;  ///< Not negative.
  std::vector<double> rotation_rad;   ///< Not negative.
};

}  // namespace setsquare
