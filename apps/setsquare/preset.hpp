// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

#include "setsquare/pipeline/preset.hpp"

namespace setsquare::app {

/// Adds --preset default|paper. `preset` must outlive the application.
void add_preset_option(CLI::App& subcommand, Preset& preset);

/// Adds --frame base|sensor. `is_of_sensor` must outlive the application.
void add_frame_option(CLI::App& subcommand, bool& is_of_sensor);

}  // namespace setsquare::app
