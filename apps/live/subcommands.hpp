// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace setsquare::live_app {

void add_live(CLI::App& application);
void add_replay(CLI::App& application);

}  // namespace setsquare::live_app
