// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/localize_log.hpp"

#include <filesystem>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/pipeline/chosen_scans.hpp"

namespace setsquare {

MapToLocaliseIn map_to_localise_in(OccupancyGrid grid) {
  auto known = std::make_shared<const KnownMap>(grid);
  return {std::move(grid), std::move(known)};
}

MapToLocaliseIn read_map_to_localise_in(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  if (is_folder ? fs::exists(map_file_at(path), error)
                : fs::path(path).extension() == ".setsquare") {
    const Map map = load_map_file(path).map;
    OccupancyGrid grid = occupancy_grid(map);
    auto known = std::make_shared<const KnownMap>(grid, map);
    return {std::move(grid), std::move(known)};
  }
  return map_to_localise_in(
      read_map_pgm_yaml(is_folder ? (fs::path(path) / "map.yaml").string() : path));
}

void count(const LocalisedPose& pose, LocalisationCounts& counts) {
  const std::size_t num_before = counts.num_scans();
  counts.num_confirmed += pose.is_confirmed;
  switch (pose.status) {
    case LocalisationStatus::kLocalised:
      ++counts.num_localised;
      if (!counts.first_localised) counts.first_localised = num_before;
      break;
    case LocalisationStatus::kAmbiguous:
      ++counts.num_ambiguous;
      break;
    case LocalisationStatus::kLost:
      ++counts.num_lost;
      break;
  }
}

LocalisationCounts counts_of(const LocalizedLog& log) {
  LocalisationCounts counts = log.left_out;
  for (const LocalisedPose& pose : log.poses) count(pose, counts);
  return counts;
}

Trajectory trajectory_of(const LocalizedLog& log, PoseOf pose_of) {
  Trajectory trajectory;
  for (const LocalisedPose& pose : log.poses) {
    if (pose.status != LocalisationStatus::kLocalised) continue;
    trajectory.push_back(
        {pose.stamp, pose_of == PoseOf::kSensor ? pose.T_map_sensor : pose.T_map_base});
  }
  return trajectory;
}

void require_something_to_find(const KnownMap& map) {
  if (!map.is_empty()) return;
  throw ParameterError("map", "has no walls or no free space: nothing can be found in it");
}

void tell_log(const LogReader& reader, const LocalizeLogOptions& options, LocalizedLog& log) {
  log.problems = reader.problems();
  log.format = reader.format();
  log.sensor = options.log.sensor.empty() ? reader.front_sensor() : options.log.sensor;
}

LocalizedLog localize_log(LogReader& reader,
                          const std::string& name,
                          std::shared_ptr<const KnownMap> map,
                          const LocalizeLogOptions& options,
                          const MapLogWatcher& watcher) {
  if (names_several(options.log.sensor)) {
    throw ParameterError("sensor", "scans of one scanner are localised");
  }
  if (map != nullptr) require_something_to_find(*map);
  LocalizedLog log;
  log.name = name;
  Localizer localizer(std::move(map), options.localisation);
  if (options.T_map_base_start) localizer.set_pose(*options.T_map_base_start);
  if (watcher.on_stage) watcher.on_stage("localising");
  ChosenScans chosen(options.log.sensor);
  std::optional<std::uint32_t> scanner;
  while (const LogRecord* record = reader.next()) {
    if (watcher.on_progress) watcher.on_progress(reader.fraction_read());
    if (record->kind != RecordKind::kScan || !chosen.takes(*record, reader.front_sensor()))
      continue;
    if (!scanner) scanner = record->scan.scanner;
    if (record->scan.scanner != *scanner) continue;
    log.poses.push_back(
        localizer.add(record->scan, options.uses_odometry ? record->T_odom_base : std::nullopt));
  }
  tell_log(reader, options, log);
  if (log.poses.empty()) throw FileError(name, "has no scan to localise");
  return log;
}

}  // namespace setsquare
