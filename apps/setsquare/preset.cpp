// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/preset.hpp"

#include "apps/setsquare/command_line/options.hpp"

namespace setsquare::app {

void add_preset_option(CLI::App& subcommand, Preset& preset) {
  add_choice<Preset, Preset>(subcommand,
                             "--preset",
                             preset,
                             {{"default", Preset::kDefault}, {"paper", Preset::kPaper}},
                             "This library's method, or that of Bando et al. 2014 as printed",
                             "default");
}

void add_frame_option(CLI::App& subcommand, bool& is_of_sensor) {
  add_choice<bool, bool>(subcommand,
                         "--frame",
                         is_of_sensor,
                         {{"base", false}, {"sensor", true}},
                         "Poses of the robot (base) or of the laser (sensor)",
                         "base");
}

}  // namespace setsquare::app
