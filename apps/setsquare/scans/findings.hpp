// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "setsquare/io/logs/faults/finding.hpp"

namespace setsquare::app {

/// Prints each finding as an indented line, with the option that mends it.
void print_findings(const std::vector<LogFinding>& findings, std::ostream& out);

}  // namespace setsquare::app
