// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// Appends the line that names the columns of append_csv_scan().
void append_csv_header(std::string& table);

/// Appends a scan as one line of a table that CsvLog reads back exactly: stamp, sensor, geometry,
/// odometry (empty where there is none), mounting, ranges; every number with the fewest digits that
/// read back to it. Speeds, true poses and odometry without a scan have no place in a table. Throws
/// ParameterError where the record is no scan, the scan is not valid or has no beam, or the
/// sensor's name has a line break.
void append_csv_scan(std::string& table, const LogRecord& record);

}  // namespace setsquare
