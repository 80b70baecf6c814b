// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/audit/earlier_map.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

TrackStatus status_from(const std::string& text) {
  for (const TrackStatus status :
       {TrackStatus::kDegenerate, TrackStatus::kRecovered, TrackStatus::kLost}) {
    if (text == to_string(status)) return status;
  }
  return TrackStatus::kTracked;
}

/// The scans that an entry of run.json is about, within the trajectory.
std::pair<std::size_t, std::size_t> scans_of(const Json& entry, std::size_t num_scans) {
  const auto first = std::min(entry.value("first_scan", std::size_t{0}), num_scans);
  return {first, std::min(entry.value("num_scans", std::size_t{0}), num_scans - first)};
}

/// What run.json tells of the track. Throws Json::exception where it is of another form.
void add_track(const Json& run, EarlierMap& map) {
  const std::size_t num_scans = map.trajectory.size();
  map.scans.resize(num_scans);
  for (const Json& entry : run.at("stretches")) {
    const auto [first, num] = scans_of(entry, num_scans);
    const TrackStatus status = status_from(entry.at("status").get<std::string>());
    for (std::size_t i = first; i < first + num; ++i) map.scans[i].status = status;
  }
  for (const Json& entry : run.at("pieces")) {
    const auto [first, num] = scans_of(entry, num_scans);
    map.pieces.push_back({first, num, entry.at("joined").get<bool>()});
    for (std::size_t i = first; i < first + num; ++i) {
      map.scans[i].is_placed = map.pieces.back().is_joined;
    }
  }
  for (const Json& entry : run.at("open_stretches")) {
    const auto [first, num] = scans_of(entry, num_scans);
    const Json& sigma_m = entry.at("length_sigma_m");
    map.open_stretches.push_back({.first_scan = first,
                                  .num_scans = num,
                                  .way_m = entry.at("way_m").get<double>(),
                                  .has_odometry = entry.value("with_odometry", false),
                                  .length_sigma_m = sigma_m.is_number()
                                                        ? sigma_m.get<double>()
                                                        : std::numeric_limits<double>::infinity()});
  }
}

void add_run(const std::filesystem::path& path, EarlierMap& map) {
  std::ifstream file(path);
  if (!file) throw FileError(path.string(), "cannot be read: not the folder of a map?");
  const Json run = Json::parse(file, nullptr, false);
  try {
    map.is_of_sensor = run.at("frame").get<std::string>() == "sensor";
    const auto num_scans = run.at("num").at("scans").get<std::size_t>();
    if (num_scans == map.trajectory.size()) add_track(run, map);
  } catch (const Json::exception&) {
    throw FormatError(path.string(), "", "is not what `setsquare map` writes");
  }
}

}  // namespace

EarlierMap read_earlier_map(const std::string& path, bool is_of_sensor) {
  EarlierMap map;
  map.is_of_sensor = is_of_sensor;
  const bool is_folder = std::filesystem::is_directory(path);
  const std::filesystem::path folder(path);
  map.trajectory_path = is_folder ? (folder / "trajectory.tum").string() : path;
  map.trajectory = read_trajectory_tum(map.trajectory_path);
  if (map.trajectory.empty()) throw FormatError(map.trajectory_path, "", "holds no pose");
  map.scans.resize(map.trajectory.size());
  if (is_folder) add_run(folder / "run.json", map);
  return map;
}

PosesOfScans::PosesOfScans(const Trajectory& trajectory, double max_time_difference_s)
    : trajectory_(trajectory),
      max_time_difference_s_(max_time_difference_s),
      by_stamp_(trajectory.size()),
      is_taken_(trajectory.size(), false) {
  std::iota(by_stamp_.begin(), by_stamp_.end(), std::size_t{0});
  std::ranges::stable_sort(by_stamp_, {}, [&](std::size_t i) { return trajectory_[i].stamp; });
}

std::size_t PosesOfScans::next(Timestamp stamp) {
  const auto off_s = [&](std::size_t i) {
    return std::abs(seconds_between(trajectory_[i].stamp, stamp));
  };
  const auto stamp_of = [&](std::size_t i) { return trajectory_[i].stamp; };
  std::size_t best = trajectory_.size();
  const auto consider = [&](std::size_t i) {
    if (is_taken_[i] || off_s(i) > max_time_difference_s_) return;
    if (best == trajectory_.size() || off_s(i) < off_s(best)) best = i;
  };
  const auto after = std::ranges::lower_bound(by_stamp_, stamp, {}, stamp_of);
  for (auto i = after; i != by_stamp_.end() && off_s(*i) <= max_time_difference_s_; ++i) {
    consider(*i);
    if (best != trajectory_.size()) break;
  }
  for (auto i = after; i != by_stamp_.begin() && off_s(*(i - 1)) <= max_time_difference_s_; --i) {
    consider(*(i - 1));
    if (best == *(i - 1)) break;
  }
  if (best < trajectory_.size()) is_taken_[best] = true;
  return best;
}

}  // namespace setsquare::app
