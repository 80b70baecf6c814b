// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::app {

/// A scan that the user asked for.
struct SelectedScan {
  Scan scan;
  std::size_t index = 0;  ///< Among the log's scans, from 0.
};

/// Reads the wanted scans of a log, in the order of `wanted`, in one pass that ends with the last
/// one found. Each is an index (0 = first scan) or, when written with a decimal point, a stamp; the
/// first scan with that stamp is meant, to the microsecond. What was damaged up to there is
/// reported on standard error. Throws FileError or FormatError (the log), Error naming the log and
/// the index or stamp that is not in it or is no number, and the damage where there is some.
[[nodiscard]] std::vector<SelectedScan> select_scans(const std::string& log_path,
                                                     std::span<const std::string> wanted,
                                                     const LogOptions& options = {});

}  // namespace setsquare::app
