// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "setsquare/io/logs/log_survey.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/pipeline/chosen_scans.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare {

/// What comes in for a map, record by record: which of it is mapped, whose it is, and what is wrong
/// with it. The same for a log that is read to its end and for a robot that drives.
class LogIntake {
 public:
  explicit LogIntake(const MapLogOptions& options) : chosen_(options.log.sensor) {}

  /// Surveys the reader's next record. Whether the mapper gets it: a scan of a chosen scanner, or a
  /// turn rate.
  [[nodiscard]] bool takes(const LogRecord& record, const LogReader& reader);

  /// Writes what was found so far: sensors, problems, findings.
  void tell(const LogReader& reader, MappedLog& mapped) const;

 private:
  LogSurvey survey_;
  ChosenScans chosen_;
  std::map<std::uint32_t, std::string> scanner_names_;  ///< By Scan::scanner.
};

/// By which options decide it; the default preset's.
[[nodiscard]] MapperParams mapper_params_of(const MapLogOptions& options);

}  // namespace setsquare
