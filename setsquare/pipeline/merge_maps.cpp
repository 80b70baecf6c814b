// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/merge_maps.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/pipeline/map_log.hpp"
#include "setsquare/pipeline/run_sentences.hpp"

namespace setsquare {
namespace {

/// The session of a merged map that one of a map became: its first scan and its last one stay,
/// whatever was forgotten between.
const MapSession* session_in(const Map& merged, const Map& map, const MapSession& session) {
  const auto ends_of = [](const Map& of, const MapSession& its) {
    return its.num_scans == 0 ? std::pair<Timestamp, Timestamp>{}
                              : std::pair{of.scans[its.first_scan].stamp,
                                          of.scans[its.first_scan + its.num_scans - 1].stamp};
  };
  const auto found = std::ranges::find_if(merged.sessions, [&](const MapSession& other) {
    return ends_of(merged, other) == ends_of(map, session);
  });
  return found == merged.sessions.end() ? nullptr : &*found;
}

/// Why a map has no place in the merged one; nothing where a session of it has.
std::optional<std::string> reason_left_out(const Map& merged, const Map& map) {
  SessionSearch most;
  for (const MapSession& session : map.sessions) {
    const MapSession* const there = session_in(merged, map, session);
    if (there == nullptr) continue;
    if (is_joined(merged, *there)) return std::nullopt;
    if (there->search.num_agreeing >= most.num_agreeing) most = there->search;
  }
  return reason_apart(most);
}

}  // namespace

SavedMap merge_maps(std::span<const SavedMap> maps,
                    const std::vector<std::string>& names,
                    std::size_t num_threads) {
  MapperParams params;
  params.num_threads = num_threads;
  std::vector<Map> parts;
  for (const SavedMap& saved : maps) parts.push_back(saved.map);
  SavedMap merged{.map = merge(parts, params), .record = {}};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (const auto reason = reason_left_out(merged.map, parts[i])) {
      throw FileError(names[i], "cannot be merged with " + names[0] + ": " + *reason);
    }
  }
  merged.record.title = title_of_log(name_of_logs(names));
  merged.record.pose_of = maps.front().record.pose_of;
  merged.record.run.log = name_of_logs(names);
  merged.record.run.format = "map.setsquare";
  merged.record.run.sensor = maps.front().record.run.sensor;
  merged.record.run.scanner_names = maps.front().record.run.scanner_names;
  merged.record.run.parameters_json = maps.front().record.run.parameters_json;
  for (const SavedMap& saved : maps) {
    merged.record.run.num_damaged_records += saved.record.run.num_damaged_records;
  }
  return merged;
}

SavedMap merge_map_files(const std::vector<std::string>& paths, std::size_t num_threads) {
  std::vector<SavedMap> maps;
  for (const std::string& path : paths) maps.push_back(load_map_file(path));
  return merge_maps(maps, paths, num_threads);
}

}  // namespace setsquare
