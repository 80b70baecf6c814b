// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/run.hpp"

#include <fmt/format.h>

#include <optional>

#include "apps/setsquare/map/sensors.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "setsquare/io/logs/faults/find_faults.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare::app {
namespace {

/// Surveys the log and feeds its scans and turn rates to a mapper: `add` takes a record.
template <typename Add>
void feed(LogReader& reader, const MapOptions& options, MapRun& run, LogSurvey& survey, Add add) {
  ProgressBar progress("mapping");
  ChosenScans chosen(options.log.sensor);
  while (const LogRecord* record = reader.next()) {
    survey.add(*record);
    if (record->kind == RecordKind::kTurnRate) {
      add(*record);
    } else if (record->kind == RecordKind::kScan && chosen.takes(*record, reader.front_sensor())) {
      run.scanner_names.try_emplace(record->scan.scanner, record->sensor);
      add(*record);
    }
    progress.advance(reader.fraction_read());
  }
  run.problems = reader.problems();
  for (const auto& [name, other] : chosen.repeated()) {
    run.problems.remarks.push_back("sensor " + name + " repeats the sweeps of " + other +
                                   ": left out");
  }
}

}  // namespace

std::string MapOptions::log_name() const {
  const std::size_t num_more = log_paths.size() - 1;
  return num_more == 0 ? log_paths.front()
                       : fmt::format("{} and {} more", log_paths.front(), num_more);
}

MapRun run_map(LogReader& reader, const MapOptions& options, StageClock& clock) {
  MapRun run;
  LogSurvey survey;
  clock.begin("tracking and closing");
  if (options.preset == Preset::kPaper) {
    PaperMapper mapper;
    feed(reader, options, run, survey, [&](const LogRecord& record) {
      if (record.kind == RecordKind::kScan) mapper.add(record.scan);
    });
    clock.begin("finishing");
    run.map = mapper.finish();
  } else {
    MapperParams params;
    params.num_threads = options.num_threads;
    params.audit.is_on = options.is_audited;
    params.tracker.deskew.trial.is_on = !options.log.sweep_time_s;  // What the user says holds.
    Mapper mapper(params);
    feed(reader, options, run, survey, [&](const LogRecord& record) {
      if (record.kind == RecordKind::kTurnRate) {
        mapper.add_turn_rate(record.stamp, record.turn_rad_per_s.value_or(0.0));
        return;
      }
      mapper.add(record.scan, options.uses_odometry ? record.T_odom_base : std::nullopt);
    });
    clock.begin("finishing");
    run.map = mapper.finish();
  }
  run.format = reader.format();
  run.sensor = options.log.sensor.empty() ? reader.front_sensor() : options.log.sensor;
  run.findings = find_faults(survey, run.problems);
  return run;
}

}  // namespace setsquare::app
