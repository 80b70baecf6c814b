// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "apps/setsquare/info/report.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/faults/findings_json.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_from(const Interval& interval, double unit = 1.0) {
  if (interval.empty()) return nullptr;
  return {{"min", unit * interval.low}, {"max", unit * interval.high}};
}

Json json_from(const StampSurvey& stamps) {
  return {{"first", to_string(stamps.first)},
          {"last", to_string(stamps.previous)},
          {"duration_s", stamps.duration_s()},
          {"longest_gap_s", stamps.longest_gap_s},
          {"num_backward", stamps.num_backward},
          {"largest_backward_s", stamps.largest_backward_s},
          {"num_repeated", stamps.num_repeated}};
}

Json json_from(const SensorSurvey& sensor) {
  const double degrees = deg_from_rad(1.0);
  Json codes = Json::array();
  for (const auto& [range_m, count] : sensor.codes) {
    codes.push_back({{"range_m", range_m}, {"count", count}});
  }
  return {{"num_scans", sensor.stamps.num_stamps},
          {"stamps", json_from(sensor.stamps)},
          {"num_beams", json_from(sensor.num_beams)},
          {"first_bearing_deg", json_from(sensor.first_bearing_rad, degrees)},
          {"bearing_step_deg", json_from(sensor.bearing_step_rad, degrees)},
          {"field_of_view_deg", json_from(sensor.field_of_view_rad, degrees)},
          {"mounting",
           {{"x_m", sensor.T_base_sensor.x_m},
            {"y_m", sensor.T_base_sensor.y_m},
            {"heading_deg", deg_from_rad(sensor.T_base_sensor.theta_rad)}}},
          {"max_range_m", sensor.max_range_m},
          {"return_range_m", json_from(sensor.return_range_m)},
          {"num_returns", sensor.num_returns},
          {"num_no_returns", sensor.num_no_returns},
          {"num_invalid", sensor.num_invalid},
          {"num_unchanged_scans", sensor.num_unchanged},
          {"no_return_codes", codes}};
}

Json json_from(const OdometrySurvey& odometry) {
  return {{"num_poses", odometry.num_poses},
          {"path_m", odometry.path_m},
          {"turn_deg", deg_from_rad(odometry.turn_rad)},
          {"num_still", odometry.num_still},
          {"num_jumps", odometry.num_jumps},
          {"num_sign_contradictions", odometry.num_sign_contradictions}};
}

Json json_from(const LogProblems& problems) {
  Json first = Json::array();
  for (const LogProblem& problem : problems.first) {
    first.push_back({{"location", problem.location}, {"reason", problem.reason}});
  }
  return {{"num_damaged", problems.num_damaged}, {"first", first}, {"remarks", problems.remarks}};
}

Json json_from(const RecordingOverview& recording) {
  if (recording.empty()) return nullptr;
  const double degrees = deg_from_rad(1.0);
  Json topics = Json::array();
  for (const RecordingTopic& topic : recording.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"num_messages", topic.num_messages},
                      {"is_read", topic.is_read}});
  }
  Json frames = Json::array();
  for (const RecordingFrame& frame : recording.frames) {
    frames.push_back({{"name", frame.name},
                      {"parent", frame.parent},
                      {"is_static", frame.is_static},
                      {"x_m", frame.x_m},
                      {"y_m", frame.y_m},
                      {"z_m", frame.z_m},
                      {"roll_deg", degrees * frame.roll_rad},
                      {"pitch_deg", degrees * frame.pitch_rad},
                      {"yaw_deg", degrees * frame.yaw_rad}});
  }
  return {{"first", to_string(recording.first)},
          {"last", to_string(recording.last)},
          {"topics", topics},
          {"frames", frames},
          {"odometry", recording.odometry},
          {"base_frame", recording.base_frame}};
}

}  // namespace

void print_info_json(const InfoReport& report, std::ostream& out) {
  Json lasers = Json::object();
  for (const auto& [name, sensor] : report.survey.sensors) lasers[name] = json_from(sensor);
  Json scan_odometry = Json::object();
  for (const auto& [name, odometry] : report.survey.scan_odometry) {
    if (odometry.num_poses > 0) scan_odometry[name] = json_from(odometry);
  }
  const Json json = {{"path", report.path},
                     {"format", report.format},
                     {"front_sensor", report.front_sensor},
                     {"recording", json_from(report.recording)},
                     {"lasers", lasers},
                     {"scan_odometry", scan_odometry},
                     {"odometry_records", json_from(report.survey.wheel_odometry)},
                     {"num_true_poses", report.survey.num_true_poses},
                     {"problems", json_from(report.problems)},
                     {"findings", Json::parse(findings_json(report.findings))}};
  // A path need not be UTF-8.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

}  // namespace setsquare::app
