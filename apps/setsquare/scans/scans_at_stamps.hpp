// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::app {

/// The scans with the given stamps, by wanted stamp: equal to within 20 us, for relations round
/// theirs; the nearest of several, of equally near ones the first. One pass over the log, progress
/// on a terminal. Throws Error naming the first stamp that the log does not have.
[[nodiscard]] std::map<Timestamp, Scan> scans_at_stamps(const std::string& log_path,
                                                        const LogOptions& options,
                                                        const std::vector<Timestamp>& stamps);

}  // namespace setsquare::app
