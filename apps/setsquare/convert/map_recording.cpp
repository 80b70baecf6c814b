// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/convert/map_recording.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/setsquare/progress_bar.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/map/recording.hpp"

namespace setsquare::app {
namespace {

/// Poses of the sensor (--frame sensor) do not say where the robot was.
void require_poses_of_robot(const std::filesystem::path& run_path) {
  std::ifstream file(run_path);
  if (!file) throw FileError(run_path.string(), "cannot be read: not the folder of a map?");
  const auto run = nlohmann::json::parse(file, nullptr, false);
  if (run.is_object() && run.value("frame", "base") == "sensor") {
    throw FormatError(
        run_path.string(), "", "the map was made with --frame sensor; map again without");
  }
}

}  // namespace

RecordedMap record_map(const std::string& folder, LogReader& reader, McapWriter::Sink sink) {
  const std::filesystem::path results(folder);
  require_poses_of_robot(results / "run.json");
  MapRecording recording(std::move(sink),
                         read_trajectory_tum((results / "trajectory.tum").string()),
                         read_closures_tsv((results / "closures.tsv").string()));
  RecordedMap recorded;
  ProgressBar progress("recording the map");
  while (const LogRecord* record = reader.next()) {
    progress.advance(reader.fraction_read());
    if (record->kind != RecordKind::kScan) continue;
    ++(recording.add(record->sensor, record->scan) ? recorded.num_scans
                                                   : recorded.num_without_pose);
  }
  recording.finish();
  if (recorded.num_scans == 0) {
    throw FormatError(
        folder, "", "no scan of the log has a pose there: it is the map of another log");
  }
  return recorded;
}

}  // namespace setsquare::app
