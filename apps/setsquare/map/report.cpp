// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/report.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

double step_m(const MappedTrack& track, std::size_t i) {
  return (track.scans[i].T_map_base.translation() - track.scans[i - 1].T_map_base.translation())
      .norm();
}

/// Six decimals: what the log's own digits can support.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json json_from(const Stretch& stretch, const MappedTrack& track) {
  const std::size_t last = stretch.first_scan + stretch.num_scans - 1;
  return {{"status", to_string(stretch.status)},
          {"first_scan", stretch.first_scan},
          {"num_scans", stretch.num_scans},
          {"first_stamp", to_string(track.scans[stretch.first_scan].stamp)},
          {"last_stamp", to_string(track.scans[last].stamp)},
          {"path_m", rounded(stretch.path_m)}};
}

Json json_from(const TrackPiece& piece, const MappedTrack& track) {
  return {{"first_scan", piece.first_scan},
          {"num_scans", piece.num_scans},
          {"first_stamp", to_string(track.scans[piece.first_scan].stamp)},
          {"joined", piece.is_joined}};
}

Json json_from(const OpenStretch& stretch, const MappedTrack& track) {
  return {{"first_scan", stretch.first_scan},
          {"num_scans", stretch.num_scans},
          {"first_stamp", to_string(track.scans[stretch.first_scan].stamp)},
          {"way_m", rounded(stretch.way_m)},
          {"open_direction_deg", rounded(deg_from_rad(stretch.direction_rad))},
          {"with_odometry", stretch.has_odometry},
          {"length_sigma_m", rounded(stretch.length_sigma_m)}};
}

Json json_from(const HeadingFrame& frame) {
  return {{"offset_deg", rounded(deg_from_rad(frame.offset_rad))},
          {"sigma_deg", rounded(deg_from_rad(frame.sigma_rad))},
          {"support", rounded(frame.support)}};
}

Json json_from(const ClosureCounts& counts) {
  return {{"compared", counts.num_compared},
          {"accepted", counts.num_accepted},
          {"one_axis", counts.num_one_axis},
          {"outvoted", counts.num_outvoted}};
}

/// An array of what json_from() makes of each.
template <typename Values, typename... Context>
Json array_from(const Values& values, const Context&... context) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(json_from(value, context...));
  return array;
}

Json counts(const MappedTrack& track) {
  std::array<std::size_t, 4> count{};
  for (const MappedScan& scan : track.scans) ++count[static_cast<std::size_t>(scan.status)];
  Json json = {{"scans", track.scans.size()}, {"keyframes", track.keyframes.size()}};
  for (const TrackStatus status : {TrackStatus::kTracked,
                                   TrackStatus::kDegenerate,
                                   TrackStatus::kRecovered,
                                   TrackStatus::kLost}) {
    json[to_string(status)] = count[static_cast<std::size_t>(status)];
  }
  return json;
}

Json parameters(const MapOptions& options) {
  if (options.preset == Preset::kPaper) {
    const PaperMapperParams params;
    return {{"keyframe_distance_m", params.keyframe_distance_m},
            {"keyframe_turn_deg", rounded(deg_from_rad(params.keyframe_turn_rad))},
            {"max_rejected", params.max_rejected},
            {"min_zncc_product", params.matcher.min_zncc_product},
            {"max_shift_m", params.matcher.max_shift_m},
            {"max_rotation_deg", deg_from_rad(params.matcher.max_rotation_rad)}};
  }
  const MapperParams params;
  const ScanTrackerParams& tracker = params.tracker;
  return {{"num_keyframes", tracker.num_keyframes},
          {"keyframe_distance_m", tracker.keyframe_distance_m},
          {"keyframe_turn_deg", rounded(deg_from_rad(tracker.keyframe_turn_rad))},
          {"max_range_m", tracker.surfaces.max_range_m},
          {"min_effective_points", tracker.refinement.min_effective_points},
          {"lost_below_score", tracker.lost_below_score},
          {"building_sigma_deg", rounded(deg_from_rad(params.heading.building_sigma_rad))},
          {"tracked_rotation_sigma_deg", rounded(deg_from_rad(params.motion.step_sigma_rad))},
          {"station_spacing", params.closing.station_spacing},
          {"min_closure_score", params.closing.verdict.min_score},
          {"min_closure_margin", params.closing.verdict.min_margin},
          {"window_per_metre", params.closing.candidates.window_per_metre},
          {"max_squared_error", params.robust.max_squared_error},
          {"registration_rounds", params.registration.num_rounds}};
}

/// Nothing given is null.
Json json_if(const std::optional<double>& value, double unit) {
  return value ? Json(rounded(unit * *value)) : Json();
}

/// The options of the command that decide what the map is; --preset and --frame stand beside.
Json json_of_options(const MapOptions& options) {
  const double degrees = deg_from_rad(1.0);
  return {{"odometry", options.uses_odometry},
          {"sensor", options.log.sensor.empty() ? Json() : Json(options.log.sensor)},
          {"field_of_view_deg", json_if(options.log.field_of_view_rad, degrees)},
          {"angular_step_deg", json_if(options.log.bearing_step_rad, degrees)},
          {"max_range_m", json_if(options.log.max_range_m, 1.0)}};
}

}  // namespace

const char* to_string(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return "tracked";
    case TrackStatus::kDegenerate:
      return "degenerate";
    case TrackStatus::kRecovered:
      return "recovered";
    case TrackStatus::kLost:
      return "lost";
  }
  return "unknown";
}

std::vector<Stretch> stretches(const MappedTrack& track) {
  std::vector<Stretch> found;
  for (std::size_t i = 0; i < track.scans.size(); ++i) {
    const TrackStatus status = track.scans[i].status;
    if (status == TrackStatus::kTracked) continue;
    const bool continues = i > 0 && track.scans[i - 1].status == status;
    if (!continues) {
      found.push_back({.status = status, .first_scan = i, .num_scans = 0, .path_m = 0.0});
    }
    ++found.back().num_scans;
    if (i > 0) found.back().path_m += step_m(track, i);
  }
  return found;
}

Trajectory trajectory_from(const MappedTrack& track, bool is_of_sensor) {
  Trajectory trajectory;
  trajectory.reserve(track.scans.size());
  for (const MappedScan& scan : track.scans) {
    trajectory.push_back({scan.stamp, is_of_sensor ? scan.T_map_sensor : scan.T_map_base});
  }
  return trajectory;
}

double path_length_m(const MappedTrack& track) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < track.scans.size(); ++i) length_m += step_m(track, i);
  return length_m;
}

ClosureCounts count_closures(const MappedTrack& track) {
  constexpr double kOutvotedBelow = 0.5;
  ClosureCounts counts{.num_compared = track.closures.size()};
  for (const MappedClosure& mapped : track.closures) {
    const LoopClosure& closure = mapped.closure;
    if (!closure.is_accepted) continue;
    ++counts.num_accepted;
    counts.num_one_axis += closure.axes != ClosureAxes::kXY;
    counts.num_outvoted += closure.weight < kOutvotedBelow;
  }
  return counts;
}

std::string run_json(const MapOptions& options, const MapRun& run) {
  const MappedTrack& track = run.track;
  const bool is_paper = options.preset == Preset::kPaper;
  const Json json = {{"version", SETSQUARE_VERSION},
                     {"log", options.log_path},
                     {"format", run.format},
                     {"sensor", run.sensor},
                     {"preset", is_paper ? "paper" : "default"},
                     {"frame", options.is_of_sensor ? "sensor" : "base"},
                     {"options", json_of_options(options)},
                     {"scans_with_odometry", run.num_with_odometry},
                     {"damaged_records", run.problems.num_damaged},
                     {"num", counts(track)},
                     {"path_m", rounded(path_length_m(track))},
                     {"closures", json_from(count_closures(track))},
                     {"building_frames", array_from(track.headings.frames)},
                     {"pieces", array_from(track.pieces, track)},
                     {"open_stretches", array_from(run.open_stretches, track)},
                     {"stretches", array_from(stretches(track), track)},
                     {"parameters", parameters(options)}};
  // A path need not be UTF-8: what is not is replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace setsquare::app
