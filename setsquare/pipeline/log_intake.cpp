// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/log_intake.hpp"

#include "setsquare/io/logs/faults/find_faults.hpp"

namespace setsquare {

bool LogIntake::takes(const LogRecord& record, const LogReader& reader) {
  survey_.add(record);
  if (record.kind == RecordKind::kTurnRate) return true;
  if (record.kind != RecordKind::kScan || !chosen_.takes(record, reader.front_sensor())) {
    return false;
  }
  scanner_names_.try_emplace(record.scan.scanner, record.sensor);
  return true;
}

void LogIntake::tell(const LogReader& reader, MappedLog& mapped) const {
  mapped.format = reader.format();
  mapped.sensor =
      mapped.options.log.sensor.empty() ? reader.front_sensor() : mapped.options.log.sensor;
  mapped.scanner_names = scanner_names_;
  mapped.problems = reader.problems();
  for (const auto& [name, other] : chosen_.repeated()) {
    mapped.problems.remarks.push_back("sensor " + name + " repeats the sweeps of " + other +
                                      ": left out");
  }
  for (const std::string& name : chosen_.absent()) {
    mapped.problems.remarks.push_back("no scan of sensor " + name);
  }
  mapped.findings = find_faults(survey_, mapped.problems);
}

MapperParams mapper_params_of(const MapLogOptions& options) {
  MapperParams params;
  params.num_threads = options.num_threads;
  params.audit.is_on = options.is_audited;
  params.tracker.deskew.trial.is_on = !options.log.sweep_time_s;  // What the user says holds.
  return params;
}

}  // namespace setsquare
