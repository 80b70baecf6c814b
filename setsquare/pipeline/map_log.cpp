// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/map_log.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/log_chain.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/paper_mapper.hpp"
#include "setsquare/pipeline/chosen_scans.hpp"
#include "setsquare/pipeline/log_intake.hpp"
#include "setsquare/pipeline/run_record.hpp"

namespace setsquare {
namespace {

/// Reads the log to its end and feeds its scans and turn rates to a mapper: `add` takes a record.
template <typename Add>
void feed(LogReader& reader, const MapLogWatcher& watcher, MappedLog& mapped, Add add) {
  LogIntake intake(mapped.options);
  while (const LogRecord* record = reader.next()) {
    if (intake.takes(*record, reader)) add(*record);
    if (watcher.on_progress) watcher.on_progress(reader.fraction_read());
  }
  intake.tell(reader, mapped);
}

void map_by_paper(LogReader& reader, const MapLogWatcher& watcher, MappedLog& mapped) {
  PaperMapper mapper;
  feed(reader, watcher, mapped, [&](const LogRecord& record) {
    if (record.kind == RecordKind::kScan) mapper.add(record.scan);
  });
  if (watcher.on_stage) watcher.on_stage("finishing");
  mapped.map = mapper.finish();
}

void map_by_default(LogReader& reader, const MapLogWatcher& watcher, MappedLog& mapped) {
  const MapLogOptions& options = mapped.options;
  const MapperParams params = mapper_params_of(options);
  Mapper mapper = options.known_map ? Mapper(*options.known_map, params) : Mapper(params);
  feed(reader, watcher, mapped, [&](const LogRecord& record) {
    if (record.kind == RecordKind::kTurnRate) {
      mapper.add_turn_rate(record.stamp, record.turn_rad_per_s.value_or(0.0));
      return;
    }
    mapper.add(record.scan, options.uses_odometry ? record.T_odom_base : std::nullopt);
  });
  if (watcher.on_stage) watcher.on_stage("finishing");
  mapped.map = mapper.finish();
}

}  // namespace

void require_something_mapped(const MappedLog& mapped) {
  const MapSummary summary = summary_of(mapped.map);
  const Map* const known = mapped.options.known_map.get();
  const auto num_logged = [](const MapSummary& of) {
    return of.num_scans + of.num_forgotten_poses;
  };
  const bool has_grown = known == nullptr || num_logged(summary) > num_logged(summary_of(*known));
  if (summary.num_lost < summary.num_scans && has_grown) return;
  std::string reason =
      !has_grown ? "none of its scans could be mapped: too few returns within range"
      : summary.num_scans == 0
          ? "none of its scans is of the sensor named first, by which the others are judged"
          : fmt::format("none of its {} scans could be mapped: too few returns within range",
                        summary.num_scans);
  for (const LogFinding& finding : mapped.findings) reason += "; " + text_of(finding);
  throw FileError(mapped.name, reason);
}

std::string name_of_logs(const std::vector<std::string>& paths) {
  return paths.size() == 1 ? paths.front()
                           : fmt::format("{} and {} more", paths.front(), paths.size() - 1);
}

std::string title_of_log(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

MappedLog map_logs(const std::vector<std::string>& paths,
                   const MapLogOptions& options,
                   const MapLogWatcher& watcher) {
  LogOptions log_options = options.log;
  log_options.scans_only = false;  // The odometry is surveyed, turn rates are used.
  const auto reader = open_logs(paths, log_options);
  return map_log(*reader, name_of_logs(paths), options, watcher);
}

MappedLog map_log(LogReader& reader,
                  const std::string& name,
                  const MapLogOptions& options,
                  const MapLogWatcher& watcher) {
  if (options.preset == Preset::kPaper && names_several(options.log.sensor)) {
    throw ParameterError("sensor", "the preset \"paper\" maps one scanner");
  }
  if (options.preset == Preset::kPaper && options.known_map) {
    throw ParameterError("continue", "the preset \"paper\" cannot go on with a map");
  }
  MappedLog mapped;
  mapped.name = name;
  mapped.options = options;
  if (watcher.on_stage) watcher.on_stage("tracking and closing");
  if (options.preset == Preset::kPaper) {
    map_by_paper(reader, watcher, mapped);
  } else {
    map_by_default(reader, watcher, mapped);
  }
  require_something_mapped(mapped);
  return mapped;
}

MapRecord map_record_of(const MappedLog& mapped, PoseOf pose_of) {
  return {.title = title_of_log(mapped.name), .pose_of = pose_of, .run = record_of(mapped)};
}

SaveMapOptions save_options_of(const MappedLog& mapped, PoseOf pose_of) {
  SaveMapOptions options = save_options_of(map_record_of(mapped, pose_of));
  options.num_threads = static_cast<int>(mapped.options.num_threads);
  return options;
}

}  // namespace setsquare
