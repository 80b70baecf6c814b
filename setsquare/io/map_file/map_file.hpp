// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The map file, map.setsquare: a map that lives on disk. docs/formats.md describes the bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "setsquare/map/map.hpp"
#include "setsquare/map/run_record.hpp"

namespace setsquare {

/// What a map file keeps beside the map: with it every other output can be made again.
struct MapRecord {
  std::string title = "map";       ///< Of report.html.
  PoseOf pose_of = PoseOf::kBase;  ///< What trajectory.tum holds.
  RunRecord run = {};              ///< What run.json tells.
};

/// What a map file holds.
struct SavedMap {
  Map map;           ///< As it was saved.
  MapRecord record;  ///< How it was made.
};

/// The name of the map file in the folder that `setsquare map` writes.
inline constexpr const char* kMapFileName = "map.setsquare";

/// The map file that a path names: itself, or that in the folder that `setsquare map` wrote.
[[nodiscard]] std::string map_file_at(const std::string& path);

/// The bytes of a map file. The same map and record give the same bytes.
[[nodiscard]] std::string map_file_bytes(const Map& map, const MapRecord& record = {});

/// Writes a map file, whole or not at all, as save_file() does. Throws FileError.
void save_map_file(const Map& map, const std::string& path, const MapRecord& record = {});

/// Reads a map file: every value bit for bit as it was saved; kept scans that shared their memory
/// share it again. `path`: the file or its folder, see map_file_at(). Throws FileError; FormatError
/// where the file is none, is damaged or cut short, or a newer Setsquare wrote it.
[[nodiscard]] SavedMap load_map_file(const std::string& path);

/// The same from bytes; `name` stands in messages for the file.
[[nodiscard]] SavedMap map_from_bytes(std::string_view bytes, const std::string& name);

/// Whether bytes begin as a map file does; eight are enough.
[[nodiscard]] bool is_map_file(std::string_view beginning);

}  // namespace setsquare
