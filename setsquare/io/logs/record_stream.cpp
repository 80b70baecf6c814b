// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/record_stream.hpp"

#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {

bool has_valid_geometry(const Scan& scan) {
  try {
    scan.validate();
    return true;
  } catch (const ParameterError&) {
    return false;
  }
}

void start_record(LogRecord& record, std::string_view sensor) {
  std::vector<double> ranges_m = std::move(record.scan.ranges_m);
  ranges_m.clear();
  record = LogRecord{};
  record.sensor = sensor;
  record.scan.ranges_m = std::move(ranges_m);
}

}  // namespace setsquare
