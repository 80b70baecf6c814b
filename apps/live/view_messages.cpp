// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/view_messages.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/live/closure_lines.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/report/map/page_data.hpp"
#include "setsquare/report/map/page_image.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare::live_app {
namespace {

using ViewJson = nlohmann::json;

/// To the millimetre: more is of no use on a screen.
double for_screen(double value) { return std::round(1000.0 * value) / 1000.0; }

std::string text_of_json(const ViewJson& json) {
  return json.dump(-1, ' ', false, ViewJson::error_handler_t::replace);
}

/// So many that few are left out.
std::size_t stride_of(std::size_t num, std::size_t most) { return (num + most - 1) / most; }

}  // namespace

std::string view_map(const LiveMap& map) {
  constexpr int kLongestSide_px = 2000;
  const std::optional<MapReportImage> image = map_report_image(map.grid, kLongestSide_px);
  if (!image) return {};
  const Pose2& T = map.grid.T_map_grid();
  ViewJson json = {{"type", "map"},
                   {"number", map.number},
                   {"grid", {T.x_m, T.y_m, T.theta_rad}},
                   {"left", image->left_m},
                   {"bottom", image->bottom_m},
                   {"pixel", image->pixel_m},
                   {"width", image->image.width_px()},
                   {"height", image->image.height_px()},
                   {"png", base64(png_from_image(image->image))},
                   {"closures", ViewJson::array()},
                   {"doubts", ViewJson::array()}};
  for (const ClosureLine& line : lines_of_closures(map.map)) {
    json["closures"].push_back({for_screen(line.from_m.x()),
                                for_screen(line.from_m.y()),
                                for_screen(line.to_m.x()),
                                for_screen(line.to_m.y()),
                                line.is_believed});
  }
  for (const MapDoubt& doubt : map.map.doubts) {
    json["doubts"].push_back({{"kind", to_string(doubt.kind)},
                              {"x", doubt.place_m.x()},
                              {"y", doubt.place_m.y()},
                              {"reason", doubt.reason}});
  }
  return text_of_json(json);
}

std::string view_way(const Trajectory& way) {
  constexpr std::size_t kMost = 5000;
  const std::size_t stride = stride_of(way.size(), kMost);
  ViewJson points = ViewJson::array();
  for (std::size_t i = 0; i < way.size(); i += stride) {
    points.push_back(for_screen(way[i].pose.x_m));
    points.push_back(for_screen(way[i].pose.y_m));
  }
  return text_of_json({{"type", "way"}, {"points", std::move(points)}});
}

std::string view_pose(const LivePose& pose, const Scan& scan) {
  constexpr std::size_t kMost = 720;
  const PointSet points = points_from_scan(scan);
  const std::size_t stride = stride_of(points.size(), kMost);
  ViewJson seen = ViewJson::array();
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Eigen::Vector2d p_base =
        scan.T_base_sensor * Eigen::Vector2d(points.x_m[i], points.y_m[i]);
    seen.push_back(for_screen(p_base.x()));
    seen.push_back(for_screen(p_base.y()));
  }
  const double sigma_m = std::sqrt(std::max(0.0, pose.covariance.topLeftCorner<2, 2>().trace()));
  return text_of_json({{"type", "pose"},
                       {"placed", pose.is_placed},
                       {"x", pose.T_map_base.x_m},
                       {"y", pose.T_map_base.y_m},
                       {"heading", pose.T_map_base.theta_rad},
                       {"sigma", sigma_m},
                       {"status", to_string(pose.status)},
                       {"scan", std::move(seen)}});
}

std::string view_report(const LiveSession& session, bool can_save) {
  const LiveReport report = session.report();
  ViewJson values = ViewJson::array();
  for (const auto& [name, value] : report.values) values.push_back({name, value});
  ViewJson places = ViewJson::array();
  for (const LikelyPlace& place : report.places) {
    const Pose2& T = place.T_map_base;
    places.push_back({for_screen(T.x_m), for_screen(T.y_m), T.theta_rad, place.probability});
  }
  return text_of_json({{"type", "report"},
                       {"doing", report.doing},
                       {"warnings", report.warnings},
                       {"values", std::move(values)},
                       {"places", std::move(places)},
                       {"paused", session.is_paused()},
                       {"canSave", can_save},
                       {"canSetPose", report.task == "localisation"}});
}

std::string view_answer(bool is_done, const std::string& text) {
  return text_of_json({{"type", "answer"}, {"ok", is_done}, {"text", text}});
}

}  // namespace setsquare::live_app
