// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/run.hpp"

#include <fmt/format.h>

#include <optional>

#include "apps/setsquare/progress_bar.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare::app {
namespace {

/// Feeds the log to a mapper: `add` takes a record.
template <typename Add>
void feed(LogReader& reader, Add add) {
  ProgressBar progress("mapping");
  while (const LogRecord* record = reader.next()) {
    add(*record);
    progress.advance(reader.fraction_read());
  }
}

}  // namespace

std::string MapOptions::log_name() const {
  const std::size_t num_more = log_paths.size() - 1;
  return num_more == 0 ? log_paths.front() : fmt::format("{} and {} more", log_paths.front(), num_more);
}

MapRun run_map(LogReader& reader, const MapOptions& options, StageClock& clock) {
  MapRun run;
  clock.begin("tracking and closing");
  if (options.preset == Preset::kPaper) {
    PaperMapper mapper;
    feed(reader, [&](const LogRecord& record) { mapper.add(record.scan); });
    clock.begin("finishing");
    run.map = mapper.finish();
  } else {
    MapperParams params;
    params.num_threads = options.num_threads;
    Mapper mapper(params);
    feed(reader, [&](const LogRecord& record) {
      mapper.add(record.scan, options.uses_odometry ? record.T_odom_base : std::nullopt);
    });
    clock.begin("finishing");
    run.map = mapper.finish();
  }
  run.format = reader.format();
  run.sensor = options.log.sensor.empty() ? reader.front_sensor() : options.log.sensor;
  run.problems = reader.problems();
  return run;
}

}  // namespace setsquare::app
