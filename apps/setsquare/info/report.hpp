// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "setsquare/io/logs/faults/finding.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/log_survey.hpp"

namespace setsquare::app {

/// All that `setsquare info` reports.
struct InfoReport {
  std::string path;
  std::string format;
  std::string front_sensor;
  LogSurvey survey;
  LogProblems problems;
  RecordingOverview recording;  ///< Empty unless the log is one of messages.
  std::vector<LogFinding> findings;
};

void print_info(const InfoReport& report, std::ostream& out);
void print_info_json(const InfoReport& report, std::ostream& out);

}  // namespace setsquare::app
