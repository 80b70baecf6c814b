// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/run_record.hpp"

#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/rounded.hpp"
#include "setsquare/io/logs/faults/findings_json.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/paper_mapper.hpp"

namespace setsquare {
namespace {

using Json = nlohmann::ordered_json;

/// Texts of the user need not be UTF-8: what is not is replaced.
std::string text_from(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json parameters(const MapLogOptions& options) {
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

/// As --slice takes it: "ring=3", "0.1:0.4"; null where the default holds.
Json json_of(const CloudSlice& slice) {
  if (slice.ring) return fmt::format("ring={}", *slice.ring);
  if (slice.low_m && slice.high_m) return fmt::format("{:g}:{:g}", *slice.low_m, *slice.high_m);
  return {};
}

/// By the scanners' names: x, y in m, and degrees.
Json json_of(const std::map<std::string, Pose2>& mountings) {
  Json object = Json::object();
  for (const auto& [name, pose] : mountings) {
    object[name] = {pose.x_m, pose.y_m, rounded(deg_from_rad(pose.theta_rad))};
  }
  return object;
}

/// The options that decide what the map is; the preset and whose poses are saved are recorded
/// apart.
Json json_of_options(const MapLogOptions& options) {
  const double degrees = deg_from_rad(1.0);
  return {{"odometry", options.uses_odometry},
          {"continue", options.known_map ? Json(options.known_map_name) : Json()},
          {"audit", options.is_audited},
          {"sensor", options.log.sensor.empty() ? Json() : Json(options.log.sensor)},
          {"field_of_view_deg", json_if(options.log.field_of_view_rad, degrees)},
          {"angular_step_deg", json_if(options.log.bearing_step_rad, degrees)},
          {"max_range_m", json_if(options.log.max_range_m, 1.0)},
          {"odometry_topic",
           options.log.odometry_topic.empty() ? Json() : Json(options.log.odometry_topic)},
          {"from_s", json_if(options.log.window.from_s, 1.0)},
          {"to_s", json_if(options.log.window.to_s, 1.0)},
          {"max_rate_hz", json_if(options.log.window.max_rate_hz, 1.0)},
          {"range_scale", options.log.range_scale},
          {"ignored_ranges_m", options.log.ignored_ranges_m},
          {"mirror_scans", options.log.mirrors_scans},
          {"sweep_time_s", json_if(options.log.sweep_time_s, 1.0)},
          {"mountings", json_of(options.log.mountings)},
          {"slice", json_of(options.log.slice)},
          {"echo", options.log.takes_strongest_echo ? "strongest" : "first"},
          {"stamp_decimals", static_cast<int>(options.log.stamp_unit)}};
}

}  // namespace

RunRecord record_of(const MappedLog& mapped) {
  return {.log = mapped.name,
          .format = mapped.format,
          .sensor = mapped.sensor,
          .scanner_names = mapped.scanner_names,
          .preset = mapped.options.preset == Preset::kPaper ? "paper" : "default",
          .options_json = text_from(json_of_options(mapped.options)),
          .parameters_json = text_from(parameters(mapped.options)),
          .findings_json = findings_json(mapped.findings),
          .num_damaged_records = mapped.problems.num_damaged};
}

}  // namespace setsquare
