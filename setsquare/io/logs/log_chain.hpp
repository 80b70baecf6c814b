// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// Several logs of one run as one: the records of the first, then those of the second, and so on.
/// Each is opened when its turn comes, so that many need no more memory than one. A scanner has the
/// same number (Scan::scanner) in all of them: its name tells which it is.
///
/// Throws ParameterError where no log is named, and what open_log throws for the first one; a later
/// one that cannot be read is named in problems(), and the run goes on behind it.
[[nodiscard]] std::unique_ptr<LogReader> open_logs(const std::vector<std::string>& paths,
                                                   const LogOptions& options = {});

}  // namespace setsquare
