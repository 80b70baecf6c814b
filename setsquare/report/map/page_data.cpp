// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/page_data.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "setsquare/drawing/png.hpp"
#include "setsquare/report/map/page_image.hpp"
#include "setsquare/report/map/raster.hpp"

namespace setsquare {
namespace {

using Json = nlohmann::ordered_json;

// What a step of each column means; web/unpack.js has the same numbers.
constexpr double kMillimetre = 1e-3;
constexpr double kCentimetre = 1e-2;
constexpr double kTenthOfMilliradian = 1e-4;
constexpr double kThousandth = 1e-3;
constexpr std::int64_t kMillisecondNs = 1'000'000;

/// A column of whole numbers, one per row.
template <typename Rows, typename NumberOf>
std::string column(const Rows& rows, const NumberOf& number_of) {
  std::vector<std::int64_t> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(number_of(row));
  return packed(values);
}

/// Adds x, y, h of every row's pose.
template <typename Rows, typename PoseOf>
void add_poses(Json& json, const Rows& rows, const PoseOf& pose_of) {
  json["x"] =
      column(rows, [&](const auto& row) { return quantised(pose_of(row).x_m, kMillimetre); });
  json["y"] =
      column(rows, [&](const auto& row) { return quantised(pose_of(row).y_m, kMillimetre); });
  json["h"] = column(rows, [&](const auto& row) {
    return quantised(pose_of(row).theta_rad, kTenthOfMilliradian);
  });
}

/// The earliest stamp, from which the page counts its milliseconds.
Timestamp first_stamp(const MapReport& report) {
  Timestamp first{std::numeric_limits<std::int64_t>::max()};
  for (const ReportPose& pose : report.poses) first = std::min(first, pose.stamp);
  for (const ReportScan& scan : report.scans) first = std::min(first, scan.stamp);
  for (const ReportHeading& heading : report.headings) first = std::min(first, heading.stamp);
  return first.ns == std::numeric_limits<std::int64_t>::max() ? Timestamp{} : first;
}

template <typename Rows>
std::string times(const Rows& rows, Timestamp start) {
  return column(rows, [&](const auto& row) { return (row.stamp.ns - start.ns) / kMillisecondNs; });
}

Json json_from_grid(const OccupancyGrid& grid) {
  const auto map = map_report_image(grid);
  if (!map) return nullptr;
  const Pose2 upright = {0.0, 0.0, -grid.T_map_grid().theta_rad};
  const Eigen::Vector2d corner = upright * grid.T_map_grid().translation();
  const CellBox walls = box_of_walls(grid);
  const double resolution_m = grid.resolution_m();
  return {{"png", base64(png_from_image(map->image))},
          {"pixel", map->pixel_m},
          {"left", corner.x() + map->left_m},
          {"bottom", corner.y() + map->bottom_m},
          {"walls",
           {corner.x() + walls.begin.column * resolution_m,
            corner.y() + walls.begin.row * resolution_m,
            corner.x() + walls.end.column * resolution_m,
            corner.y() + walls.end.row * resolution_m}}};
}

Json json_from_poses(const std::vector<ReportPose>& poses, Timestamp start) {
  Json json = {{"t", times(poses, start)}};
  add_poses(json, poses, [](const ReportPose& pose) { return pose.T_map_base; });
  json["condition"] =
      column(poses, [](const ReportPose& pose) { return static_cast<int>(pose.condition); });
  json["sigma"] = column(poses, [](const ReportPose& pose) {
    return std::isfinite(pose.sigma_m) ? quantised(pose.sigma_m, kMillimetre) : -1;
  });
  return json;
}

/// The scans that closures name, in their order, and where each of all scans went among them.
struct ShownScans {
  std::vector<const ReportScan*> scans;
  std::vector<std::int64_t> place;
};

ShownScans shown_scans(const MapReport& report) {
  ShownScans shown;
  shown.place.assign(report.scans.size(), -1);
  for (const ReportClosure& closure : report.closures) {
    assert(closure.scan_i < report.scans.size() && closure.scan_j < report.scans.size());
    shown.place[closure.scan_i] = shown.place[closure.scan_j] = 0;
  }
  for (std::size_t i = 0; i < report.scans.size(); ++i) {
    if (shown.place[i] < 0) continue;
    shown.place[i] = static_cast<std::int64_t>(shown.scans.size());
    shown.scans.push_back(&report.scans[i]);
  }
  return shown;
}

Json json_from_scans(const std::vector<const ReportScan*>& scans, Timestamp start) {
  Json json;
  json["t"] = column(
      scans, [&](const ReportScan* scan) { return (scan->stamp.ns - start.ns) / kMillisecondNs; });
  add_poses(json, scans, [](const ReportScan* scan) { return scan->T_map_base; });
  json["points"] = column(
      scans, [](const ReportScan* scan) { return static_cast<std::int64_t>(scan->points.size()); });
  std::vector<std::int64_t> x_cm;
  std::vector<std::int64_t> y_cm;
  for (const ReportScan* scan : scans) {
    for (const double x_m : scan->points.x_m) x_cm.push_back(quantised(x_m, kCentimetre));
    for (const double y_m : scan->points.y_m) y_cm.push_back(quantised(y_m, kCentimetre));
  }
  json["px"] = packed(x_cm);
  json["py"] = packed(y_cm);
  return json;
}

Json json_from_closures(const MapReport& report, const std::vector<std::int64_t>& place) {
  const std::vector<ReportClosure>& rows = report.closures;
  std::vector<std::string> reasons;  // Each once: there are few.
  for (const ReportClosure& row : rows) reasons.push_back(row.closure.reason);
  std::sort(reasons.begin(), reasons.end());
  reasons.erase(std::unique(reasons.begin(), reasons.end()), reasons.end());

  Json json;
  json["i"] = column(rows, [&](const ReportClosure& row) { return place[row.scan_i]; });
  json["j"] = column(rows, [&](const ReportClosure& row) { return place[row.scan_j]; });
  add_poses(json, rows, [](const ReportClosure& row) { return row.closure.T_i_j; });
  json["axes"] =
      column(rows, [](const ReportClosure& row) { return static_cast<int>(row.closure.axes); });
  json["accepted"] =
      column(rows, [](const ReportClosure& row) { return row.closure.is_accepted ? 1 : 0; });
  json["weight"] = column(
      rows, [](const ReportClosure& row) { return quantised(row.closure.weight, kThousandth); });
  json["reason"] = column(rows, [&](const ReportClosure& row) {
    return std::lower_bound(reasons.begin(), reasons.end(), row.closure.reason) - reasons.begin();
  });
  json["reasons"] = reasons;
  return json;
}

Json json_from_headings(const MapReport& report, Timestamp start) {
  const std::vector<ReportHeading>& rows = report.headings;
  const auto angle = [&](const auto& angle_of) {
    return column(rows, [&](const ReportHeading& row) {
      return quantised(angle_of(row), kTenthOfMilliradian);
    });
  };
  Json json = {{"t", times(rows, start)}};
  json["measured"] = angle([](const ReportHeading& row) { return row.measured_rad.value_or(0.0); });
  json["frame"] =
      column(rows, [](const ReportHeading& row) { return row.measured_rad ? row.frame : -1; });
  json["weight"] =
      column(rows, [](const ReportHeading& row) { return quantised(row.weight, kThousandth); });
  json["fused"] = angle([](const ReportHeading& row) { return row.fused_rad; });
  json["tracked"] = angle([](const ReportHeading& row) { return row.tracked_rad; });
  json["frames"] = Json::array();
  for (const double heading_rad : report.frame_headings_rad) {
    json["frames"].push_back(std::isfinite(heading_rad) ? heading_rad : 0.0);
  }
  return json;
}

Json json_from_figures(const std::vector<ReportFigure>& figures) {
  Json json = Json::array();
  for (const ReportFigure& figure : figures) {
    json.push_back({{"group", figure.group},
                    {"name", figure.name},
                    {"value", figure.value},
                    {"unit", figure.unit},
                    {"explanation", figure.explanation}});
  }
  return json;
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3) {
    const std::size_t num_bytes = std::min<std::size_t>(3, bytes.size() - first);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_there = i < num_bytes;
      group = group << 8 | (is_there ? static_cast<unsigned char>(bytes[first + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= num_bytes ? kLetters[group >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

std::int64_t quantised(double value, double step) {
  constexpr double kLargest = 1125899906842624.0;  // 2^50
  const double steps = value / step;
  if (std::isnan(steps)) return 0;
  return std::llround(std::clamp(steps, -kLargest, kLargest));
}

std::string packed(std::span<const std::int64_t> values) {
  std::string bytes;
  bytes.reserve(2 * values.size());
  std::int64_t previous = 0;
  for (const std::int64_t value : values) {
    const std::int64_t step = value - previous;
    const auto doubled = static_cast<std::uint64_t>(step) << 1;
    std::uint64_t folded = step < 0 ? ~doubled : doubled;
    for (; folded >= 128; folded >>= 7) bytes += static_cast<char>((folded & 127) | 128);
    bytes += static_cast<char>(folded);
    previous = value;
  }
  return base64(bytes);
}

std::string map_report_json(const MapReport& report) {
  const Timestamp start = first_stamp(report);
  const ShownScans shown = shown_scans(report);
  Json json = {{"title", report.title}, {"start", to_string(start)}};
  json["grid_heading"] = report.grid != nullptr ? report.grid->T_map_grid().theta_rad : 0.0;
  json["map"] = report.grid != nullptr ? json_from_grid(*report.grid) : Json(nullptr);
  json["poses"] = json_from_poses(report.poses, start);
  json["scans"] = json_from_scans(shown.scans, start);
  json["closures"] = json_from_closures(report, shown.place);
  json["headings"] = json_from_headings(report, start);
  json["figures"] = json_from_figures(report.figures);

  std::string safe;
  for (const char letter : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (letter == '<') {
      safe += "\\u003c";
    } else {
      safe += letter;
    }
  }
  return safe;
}

}  // namespace setsquare
