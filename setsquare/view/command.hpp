// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "setsquare/core/pose2.hpp"

namespace setsquare::view {

/// What a page asks for.
struct Command {
  enum class Kind { kSave, kPause, kSetPose };

  Kind kind = Kind::kSave;
  bool is_on = false;  ///< Of kPause.
  Pose2 T_map_base;    ///< Of kSetPose: finite, within 1e6 m and rad.
};

/// {"do": "save"}, {"do": "pause", "on": true}, {"do": "set_pose", "x": 1, "y": 2, "heading": 3}.
/// Nothing where the text is none of these.
[[nodiscard]] std::optional<Command> parse_command(const std::string& text);

}  // namespace setsquare::view
