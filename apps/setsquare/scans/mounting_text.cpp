// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/mounting_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"

namespace setsquare::app {

Pose2 mounting_from_text(const std::string& option, const std::string& text) {
  constexpr double kFarthest_m = 100.0;
  std::string blanks = text;
  std::replace(blanks.begin(), blanks.end(), ',', ' ');
  TextScanner scanner(blanks);
  const auto x_m = scanner.finite_number();
  const auto y_m = x_m ? scanner.finite_number() : std::nullopt;
  const auto turn_deg = y_m ? scanner.finite_number() : std::nullopt;
  const bool is_whole = turn_deg && scanner.is_at_end();
  if (!is_whole || std::hypot(*x_m, *y_m) > kFarthest_m) {
    throw Error(fmt::format(
        "{}: \"{}\" is not \"x,y,theta\" in m and degrees, within 100 m", option, text));
  }
  return {*x_m, *y_m, wrap_to_pi(rad_from_deg(*turn_deg))};
}

std::pair<std::string, Pose2> named_mounting_from_text(const std::string& option,
                                                       const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) {
    throw Error(fmt::format("{}: \"{}\" is not \"NAME=x,y,theta\"", option, text));
  }
  return {text.substr(0, equals), mounting_from_text(option, text.substr(equals + 1))};
}

}  // namespace setsquare::app
