// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "setsquare/core/pose2.hpp"

namespace setsquare::app {

/// A scanner's mounting from "x,y,theta_deg", in m and degrees. Throws Error that names the option
/// where it is not that, or more than 100 m from the robot.
[[nodiscard]] Pose2 mounting_from_text(const std::string& option, const std::string& text);

/// "NAME=x,y,theta_deg" likewise; the name may hold an "=" itself.
[[nodiscard]] std::pair<std::string, Pose2> named_mounting_from_text(const std::string& option,
                                                                     const std::string& text);

}  // namespace setsquare::app
