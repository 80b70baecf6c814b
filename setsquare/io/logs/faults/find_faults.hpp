// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/io/logs/faults/finding.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/log_survey.hpp"

namespace setsquare {

/// What is wrong with a log that was read and surveyed: every check on every laser, on the
/// odometry, then what the reader skipped and remarked. Empty
/// where nothing was found.
[[nodiscard]] std::vector<LogFinding> find_faults(const LogSurvey& survey,
                                                  const LogProblems& problems);

}  // namespace setsquare
