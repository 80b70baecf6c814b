// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/run_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/rounded.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/report/map/audit_json.hpp"

namespace setsquare {
namespace {

using Json = nlohmann::ordered_json;

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
          {"duration_s", rounded(stretch.duration_s)},
          {"open_direction_deg", rounded(deg_from_rad(stretch.direction_rad))},
          {"with_odometry", stretch.has_odometry},
          {"length_sigma_m", rounded(stretch.length_sigma_m)},
          {"open", stretch.is_turn ? "turn" : "along"},
          {"heading_sigma_deg",
           stretch.is_turn ? Json(rounded(deg_from_rad(stretch.heading_sigma_rad))) : Json()}};
}

Json json_from(const BuildingFrame& frame) {
  return {{"offset_deg", rounded(deg_from_rad(frame.offset_rad))},
          {"sigma_deg", rounded(deg_from_rad(frame.sigma_rad))},
          {"support", rounded(frame.support)}};
}

Json json_from(const Pose2& mounting) {
  return {{"x_m", rounded(mounting.x_m)},
          {"y_m", rounded(mounting.y_m)},
          {"theta_deg", rounded(deg_from_rad(mounting.theta_rad))}};
}

Json json_from(const MappedScanner& scanner, const RunRecord& run) {
  const auto name = run.scanner_names.find(scanner.scanner);
  Json json = {{"sensor", name == run.scanner_names.end() ? "" : name->second},
               {"mounting", json_from(scanner.T_base_sensor)},
               {"verdict", to_string(scanner.verdict)},
               {"scans", scanner.num_scans},
               {"mapped", scanner.num_mapped}};
  if (scanner.num_sightings == 0) return json;
  json["sightings"] = scanner.num_sightings;
  json["mounting_seen"] = json_from(scanner.T_base_seen);
  json["sigma_deg"] = rounded(deg_from_rad(scanner.sigma_rad));
  if (std::isfinite(scanner.sigma_m)) json["sigma_m"] = rounded(scanner.sigma_m);
  return json;
}

Json json_from(const GyroReport& gyro) {
  if (gyro.num_samples == 0) return {};
  return {{"verdict", to_string(gyro.verdict)},
          {"samples", gyro.num_samples},
          {"turns", gyro.num_turns},
          {"scale", rounded(gyro.scale)},
          {"scans_late_s", rounded(gyro.scans_late_s)},
          {"bias_deg_per_s", rounded(deg_from_rad(gyro.bias_rad_per_s))}};
}

Json json_from(const OdometryComparison& comparison) {
  return {{"compared", comparison.num_compared},
          {"scale", rounded(comparison.scale)},
          {"deviation", rounded(comparison.deviation)}};
}

/// Nothing where the log has none.
Json json_from(const OdometryReport& odometry, std::size_t num_with_odometry) {
  if (num_with_odometry == 0 && odometry.num_ignored == 0) return {};
  return {{"verdict", to_string(odometry.verdict)},
          {"way", json_from(odometry.way)},
          {"turn", json_from(odometry.turn)},
          {"ignored", odometry.num_ignored},
          {"jumps", odometry.num_jumps},
          {"carried", odometry.num_carried}};
}

/// Nothing where no scanner is known to sweep.
Json json_from(const SweepReport& sweep) {
  if (sweep.verdict == SweepVerdict::kUnknown && sweep.stated_s == 0.0) return {};
  return {{"verdict", to_string(sweep.verdict)},
          {"sweep_s", rounded(sweep.sweep_s)},
          {"stated_s", rounded(sweep.stated_s)},
          {"turns", sweep.num_turns}};
}

Json json_from(const MapSession& session, const Map& map) {
  const std::size_t last = session.first_scan + session.num_scans - 1;
  return {{"first_scan", session.first_scan},
          {"num_scans", session.num_scans},
          {"first_stamp", to_string(map.scans[session.first_scan].stamp)},
          {"last_stamp", to_string(map.scans[last].stamp)},
          {"recency", session.recency},
          {"joined", is_joined(map, session)},
          {"pairs_compared", session.search.num_pairs},
          {"pairs_matched", session.search.num_matched},
          {"places_agreeing", session.search.num_agreeing}};
}

Json json_from(const ChangedPlace& place) {
  return {{"what", place.is_gone ? "gone" : "new"},
          {"x_m", rounded(place.place_m.x())},
          {"y_m", rounded(place.place_m.y())},
          {"cells", place.num_cells}};
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
          {"forgotten_keyframes", summary.num_forgotten},
          {"forgotten_poses", summary.num_forgotten_poses},
          {to_string(TrackStatus::kTracked), summary.num_tracked},
          {to_string(TrackStatus::kDegenerate), summary.num_degenerate},
          {to_string(TrackStatus::kRecovered), summary.num_recovered},
          {to_string(TrackStatus::kLost), summary.num_lost}};
}

/// Throws ParameterError where the text is no JSON object.
Json object_from(const std::string& text, const char* name) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw ParameterError(name, "must be a JSON object");
  return json;
}

/// Throws ParameterError where the text is no JSON array.
Json array_from_text(const std::string& text, const char* name) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) throw ParameterError(name, "must be a JSON array");
  return json;
}

}  // namespace

std::string run_json(const Map& map,
                     const RunRecord& run,
                     PoseOf pose_of,
                     std::span<const ChangedPlace> changes) {
  const MapSummary summary = summary_of(map);
  const Json json = {{"version", run.version},
                     {"log", run.log},
                     {"format", run.format},
                     {"sensor", run.sensor},
                     {"scanners", array_from(map.scanners, run)},
                     {"gyro", json_from(map.gyro)},
                     {"odometry", json_from(map.odometry, map.num_with_odometry)},
                     {"sweep", json_from(map.sweep)},
                     {"preset", run.preset},
                     {"frame", pose_of == PoseOf::kSensor ? "sensor" : "base"},
                     {"options", object_from(run.options_json, "options_json")},
                     {"scans_with_odometry", map.num_with_odometry},
                     {"damaged_records", run.num_damaged_records},
                     {"findings", array_from_text(run.findings_json, "findings_json")},
                     {"num", scan_counts(summary)},
                     {"path_m", rounded(summary.path_m)},
                     {"closures", closure_counts(summary)},
                     {"audit", json_from_audit(map)},
                     {"doubts", json_from_doubts(map)},
                     {"building_frames", array_from(map.frames)},
                     {"sessions", array_from(map.sessions, map)},
                     {"changed_places", array_from(changes)},
                     {"pieces", array_from(map.pieces, map)},
                     {"open_stretches", array_from(map.open_stretches, map)},
                     {"stretches", array_from(status_stretches(map), map)},
                     {"parameters", object_from(run.parameters_json, "parameters_json")}};
  // A path need not be UTF-8: what is not is replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace setsquare
