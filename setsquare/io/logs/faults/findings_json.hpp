// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/io/logs/faults/finding.hpp"

namespace setsquare {

/// The findings as a JSON array of {"kind", "sentence", "share", "option"}, for `info --json` and
/// run.json; the option is null where none mends it.
[[nodiscard]] std::string findings_json(const std::vector<LogFinding>& findings);

/// The findings of such an array; of a kind that is not known: a remark. Empty where it is none.
[[nodiscard]] std::vector<LogFinding> findings_from_json(const std::string& json);

}  // namespace setsquare
