// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "setsquare/map/map_summary.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

/// Six decimals: what the log's own digits can support.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json json_from(const StatusStretch& stretch, const Map& map) {
  const std::size_t last = stretch.first_scan + stretch.num_scans - 1;
  return {{"status", to_string(stretch.status)},
          {"first_scan", stretch.first_scan},
          {"num_scans", stretch.num_scans},
          {"first_stamp", to_string(map.scans[stretch.first_scan].stamp)},
          {"last_stamp", to_string(map.scans[last].stamp)},
          {"path_m", rounded(stretch.path_m)}};
}

Json json_from(const TrackPiece& piece, const Map& map) {
  return {{"first_scan", piece.first_scan},
          {"num_scans", piece.num_scans},
          {"first_stamp", to_string(map.scans[piece.first_scan].stamp)},
          {"joined", piece.is_joined}};
}

Json json_from(const OpenStretch& stretch, const Map& map) {
  return {{"first_scan", stretch.first_scan},
          {"num_scans", stretch.num_scans},
          {"first_stamp", to_string(map.scans[stretch.first_scan].stamp)},
          {"way_m", rounded(stretch.way_m)},
          {"open_direction_deg", rounded(deg_from_rad(stretch.direction_rad))},
          {"with_odometry", stretch.has_odometry},
          {"length_sigma_m", rounded(stretch.length_sigma_m)}};
}

Json json_from(const BuildingFrame& frame) {
  return {{"offset_deg", rounded(deg_from_rad(frame.offset_rad))},
          {"sigma_deg", rounded(deg_from_rad(frame.sigma_rad))},
          {"support", rounded(frame.support)}};
}

Json closure_counts(const MapSummary& summary) {
  return {{"compared", summary.num_compared_closures},
          {"accepted", summary.num_accepted_closures},
          {"one_axis", summary.num_one_axis_closures},
          {"outvoted", summary.num_outvoted_closures}};
}

/// An array of what json_from() makes of each.
template <typename Values, typename... Context>
Json array_from(const Values& values, const Context&... context) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(json_from(value, context...));
  return array;
}

Json scan_counts(const MapSummary& summary) {
  return {{"scans", summary.num_scans},
          {"keyframes", summary.num_keyframes},
          {to_string(TrackStatus::kTracked), summary.num_tracked},
          {to_string(TrackStatus::kDegenerate), summary.num_degenerate},
          {to_string(TrackStatus::kRecovered), summary.num_recovered},
          {to_string(TrackStatus::kLost), summary.num_lost}};
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

std::string run_json(const MapOptions& options, const MapRun& run) {
  const Map& map = run.map;
  const MapSummary summary = summary_of(map);
  const bool is_paper = options.preset == Preset::kPaper;
  const Json json = {{"version", SETSQUARE_VERSION},
                     {"log", options.log_path},
                     {"format", run.format},
                     {"sensor", run.sensor},
                     {"preset", is_paper ? "paper" : "default"},
                     {"frame", options.is_of_sensor ? "sensor" : "base"},
                     {"options", json_of_options(options)},
                     {"scans_with_odometry", map.num_with_odometry},
                     {"damaged_records", run.problems.num_damaged},
                     {"num", scan_counts(summary)},
                     {"path_m", rounded(summary.path_m)},
                     {"closures", closure_counts(summary)},
                     {"building_frames", array_from(map.frames)},
                     {"pieces", array_from(map.pieces, map)},
                     {"open_stretches", array_from(map.open_stretches, map)},
                     {"stretches", array_from(status_stretches(map), map)},
                     {"parameters", parameters(options)}};
  // A path need not be UTF-8: what is not is replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace setsquare::app
