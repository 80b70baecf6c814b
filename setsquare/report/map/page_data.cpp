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
#include <unordered_map>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/map/map_verdict.hpp"
#include "setsquare/report/map/page_image.hpp"
#include "setsquare/report/map/raster.hpp"
#include "setsquare/report/page_template.hpp"
#include "setsquare/scan/scan_to_points.hpp"

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
Timestamp first_stamp(const Map& map) {
  if (map.scans.empty()) return {};
  return std::ranges::min(map.scans, {}, &MappedScan::stamp).stamp;
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

/// The page's code of a scan that is not placed, behind those of TrackStatus.
constexpr std::int64_t kNotPlaced = 4;

std::int64_t condition_of(const MappedScan& scan) {
  return scan.is_placed ? static_cast<std::int64_t>(scan.status) : kNotPlaced;
}

Json json_from_poses(const std::vector<MappedScan>& scans, Timestamp start) {
  Json json = {{"t", times(scans, start)}};
  add_poses(json, scans, [](const MappedScan& scan) { return scan.T_map_base; });
  json["condition"] = column(scans, condition_of);
  json["sigma"] = column(scans, [](const MappedScan& scan) {
    return std::isfinite(scan.position_sigma_m) ? quantised(scan.position_sigma_m, kMillimetre)
                                                : -1;
  });
  return json;
}

/// The scans to which no step leads: the track is not drawn to them.
Json begins_of(const Map& map) {
  Json begins = Json::array();
  for (std::size_t i = 1; i < map.scans.size(); ++i) {
    if (begins_anew(map, i)) begins.push_back(i);
  }
  return begins;
}

/// The scans that closures are of, each once, in the order in which they are first named.
class ShownScans {
 public:
  explicit ShownScans(const std::vector<MappedClosure>& closures) {
    for (const MappedClosure& closure : closures) {
      show(closure.scan_i);
      show(closure.scan_j);
    }
  }

  /// Indices of Map::scans.
  [[nodiscard]] const std::vector<std::size_t>& scans() const { return scans_; }
  [[nodiscard]] std::int64_t place_of(std::size_t scan) const { return place_of_.at(scan); }

 private:
  void show(std::size_t scan) {
    const auto next = static_cast<std::int64_t>(scans_.size());
    if (place_of_.try_emplace(scan, next).second) scans_.push_back(scan);
  }

  std::vector<std::size_t> scans_;
  std::unordered_map<std::size_t, std::int64_t> place_of_;
};

PointSet points_in_base(const Scan& scan) {
  PointSet points = points_from_scan(scan);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = scan.T_base_sensor * Eigen::Vector2d(points.x_m[i], points.y_m[i]);
    points.x_m[i] = p.x();
    points.y_m[i] = p.y();
  }
  return points;
}

Json json_from_scans(const Map& map, const ShownScans& shown, Timestamp start) {
  std::unordered_map<std::size_t, const Scan*> kept;
  for (const KeptScan& scan : map.kept_scans) kept[scan.index] = scan.scan.get();
  const std::vector<std::size_t>& rows = shown.scans();
  std::vector<std::int64_t> num_points;
  std::vector<std::int64_t> x_cm;
  std::vector<std::int64_t> y_cm;
  for (const std::size_t index : rows) {
    const PointSet points = points_in_base(*kept.at(index));
    num_points.push_back(static_cast<std::int64_t>(points.size()));
    for (const double x_m : points.x_m) x_cm.push_back(quantised(x_m, kCentimetre));
    for (const double y_m : points.y_m) y_cm.push_back(quantised(y_m, kCentimetre));
  }
  Json json;
  json["t"] = column(rows, [&](std::size_t index) {
    return (map.scans[index].stamp.ns - start.ns) / kMillisecondNs;
  });
  add_poses(json, rows, [&](std::size_t index) { return map.scans[index].T_map_base; });
  json["points"] = packed(num_points);
  json["px"] = packed(x_cm);
  json["py"] = packed(y_cm);
  return json;
}

Json json_from_closures(const std::vector<MappedClosure>& rows, const ShownScans& shown) {
  std::vector<std::string> reasons;  // Each once: there are few.
  for (const MappedClosure& row : rows) reasons.push_back(row.closure.reason);
  std::sort(reasons.begin(), reasons.end());
  reasons.erase(std::unique(reasons.begin(), reasons.end()), reasons.end());

  Json json;
  json["i"] = column(rows, [&](const MappedClosure& row) { return shown.place_of(row.scan_i); });
  json["j"] = column(rows, [&](const MappedClosure& row) { return shown.place_of(row.scan_j); });
  add_poses(json, rows, [](const MappedClosure& row) { return row.closure.T_i_j; });
  json["axes"] =
      column(rows, [](const MappedClosure& row) { return static_cast<int>(row.closure.axes); });
  json["accepted"] =
      column(rows, [](const MappedClosure& row) { return row.closure.is_accepted ? 1 : 0; });
  json["weight"] = column(
      rows, [](const MappedClosure& row) { return quantised(row.closure.weight, kThousandth); });
  json["reason"] = column(rows, [&](const MappedClosure& row) {
    return std::lower_bound(reasons.begin(), reasons.end(), row.closure.reason) - reasons.begin();
  });
  json["reasons"] = reasons;
  return json;
}

/// A keyframe's heading, of the robot.
struct HeadingRow {
  Timestamp stamp;
  const MappedHeading* of_sensor = nullptr;
  double to_base_rad = 0.0;  ///< From the sensor's heading.
  double fused_rad = 0.0;    ///< The heading that the map uses.
};

std::vector<HeadingRow> heading_rows(const Map& map) {
  std::vector<HeadingRow> rows;
  for (std::size_t k = 0; k < map.headings.size(); ++k) {
    const MappedScan& scan = map.scans[map.keyframes[k]];
    const double to_base_rad = wrap_to_pi(scan.T_map_base.theta_rad - scan.T_map_sensor.theta_rad);
    rows.push_back({scan.stamp, &map.headings[k], to_base_rad, scan.T_map_base.theta_rad});
  }
  return rows;
}

Json json_from_headings(const Map& map, Timestamp start) {
  const std::vector<HeadingRow> rows = heading_rows(map);
  const auto angle = [&](const auto& angle_of) {
    return column(
        rows, [&](const HeadingRow& row) { return quantised(angle_of(row), kTenthOfMilliradian); });
  };
  Json json = {{"t", times(rows, start)}};
  json["measured"] = angle([](const HeadingRow& row) {
    const auto& measured_rad = row.of_sensor->measured_rad;
    return measured_rad ? *measured_rad + row.to_base_rad : 0.0;
  });
  json["frame"] = column(rows, [](const HeadingRow& row) {
    return row.of_sensor->measured_rad ? static_cast<std::int64_t>(row.of_sensor->frame) : -1;
  });
  json["weight"] = column(
      rows, [](const HeadingRow& row) { return quantised(row.of_sensor->weight, kThousandth); });
  json["fused"] = angle([](const HeadingRow& row) { return row.fused_rad; });
  json["tracked"] =
      angle([](const HeadingRow& row) { return row.of_sensor->tracked_rad + row.to_base_rad; });
  json["frames"] = Json::array();
  for (const BuildingFrame& frame : map.frames) {
    json["frames"].push_back(std::isfinite(frame.offset_rad) ? frame.offset_rad : 0.0);
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

/// The page counts times from its first stamp, as in the columns.
Json json_from_doubts_of_page(const Map& map, Timestamp start) {
  Json array = Json::array();
  for (const MapDoubt& doubt : map.doubts) {
    array.push_back({{"kind", to_string(doubt.kind)},
                     {"x", doubt.place_m.x()},
                     {"y", doubt.place_m.y()},
                     {"t", static_cast<double>(doubt.first_stamp.ns - start.ns) * 1e-9},
                     {"reason", doubt.reason}});
  }
  return array;
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
  const Map& map = report.map;
  const Timestamp start = first_stamp(map);
  const std::vector<MappedClosure> closures = closures_of_placed(map);
  const ShownScans shown(closures);
  Json json = {{"title", report.title}, {"start", to_string(start)}};
  json["grid_heading"] = report.grid != nullptr ? report.grid->T_map_grid().theta_rad : 0.0;
  json["map"] = report.grid != nullptr ? json_from_grid(*report.grid) : Json(nullptr);
  json["poses"] = json_from_poses(map.scans, start);
  json["begins"] = begins_of(map);
  json["scans"] = json_from_scans(map, shown, start);
  json["closures"] = json_from_closures(closures, shown);
  json["headings"] = json_from_headings(map, start);
  json["verdict"] = map_verdict(map);
  json["doubts"] = json_from_doubts_of_page(map, start);
  json["figures"] = json_from_figures(report.figures);

  return json_within_script(json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace setsquare
