// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/info/map.hpp"

#include <fmt/core.h>

#include <array>
#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/setsquare/audit/verdict_text.hpp"
#include "setsquare/core/rounded.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/map/map_verdict.hpp"

namespace setsquare::app {
namespace {

/// Of the robot's poses that are placed, in m along the map's axes; zero where there is none.
Eigen::Vector2d extent_of_track(const Map& map) {
  Eigen::AlignedBox2d box;
  for (const StampedPose& stamped : trajectory_of(map)) box.extend(stamped.pose.translation());
  return box.isEmpty() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(box.sizes());
}

void print_map_json(const SavedMap& saved, std::uintmax_t num_bytes, std::ostream& out) {
  const MapSummary summary = summary_of(saved.map);
  const Eigen::Vector2d extent_m = extent_of_track(saved.map);
  const nlohmann::ordered_json json = {
      {"kind", "map"},
      {"version", saved.record.run.version},
      {"log", saved.record.run.log},
      {"bytes", num_bytes},
      {"verdict", map_verdict(saved.map)},
      {"doubts", saved.map.doubts.size()},
      {"scans", summary.num_scans},
      {"keyframes", summary.num_keyframes},
      {"kept_scans", saved.map.kept_scans.size()},
      {"closures", summary.num_accepted_closures},
      {"path_m", rounded(summary.path_m)},
      {"track_extent_m", {rounded(extent_m.x()), rounded(extent_m.y())}}};
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

void print_map_text(const SavedMap& saved, std::uintmax_t num_bytes, std::ostream& out) {
  const Map& map = saved.map;
  const RunRecord& run = saved.record.run;
  const MapSummary summary = summary_of(map);
  const Eigen::Vector2d extent_m = extent_of_track(map);
  out << fmt::format("  made of    {}, by Setsquare {}\n",
                     run.log.empty() ? "scans" : run.log,
                     run.version.empty() ? "of unknown version" : run.version);
  out << fmt::format("  scans      {}", summary.num_scans);
  if (!map.scans.empty()) {
    out << fmt::format(
        ", stamps {} to {}", to_string(map.scans.front().stamp), to_string(map.scans.back().stamp));
  }
  out << fmt::format(
      "\n  keyframes  {}, {} scans kept\n", summary.num_keyframes, map.kept_scans.size());
  out << fmt::format("  closures   {} of {} compared\n",
                     summary.num_accepted_closures,
                     summary.num_compared_closures);
  out << fmt::format(
      "  track      {:.0f} m, in {:.1f} by {:.1f} m\n", summary.path_m, extent_m.x(), extent_m.y());
  out << fmt::format("  file       {:.2f} MB\n", static_cast<double>(num_bytes) * 1e-6);
  out << verdict_text(map);
}

}  // namespace

bool is_map(const std::string& path) {
  const std::string map_file = map_file_at(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(map_file, ignored)) return false;
  std::array<char, 8> beginning{};
  std::ifstream file(map_file, std::ios::binary);
  file.read(beginning.data(), beginning.size());
  return is_map_file({beginning.data(), static_cast<std::size_t>(file.gcount())});
}

void print_map_info(const std::string& path, bool is_json, std::ostream& out) {
  const std::string map_file = map_file_at(path);
  const SavedMap saved = load_map_file(map_file);
  const std::uintmax_t num_bytes = std::filesystem::file_size(map_file);
  if (is_json) {
    print_map_json(saved, num_bytes, out);
  } else {
    out << map_file << ": a map of Setsquare\n";
    print_map_text(saved, num_bytes, out);
  }
}

}  // namespace setsquare::app
