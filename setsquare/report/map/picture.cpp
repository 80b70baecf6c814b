// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/drawing/paint.hpp"
#include "setsquare/report/map/closures.hpp"
#include "setsquare/report/map/doubt_marks.hpp"
#include "setsquare/report/map/footer.hpp"
#include "setsquare/report/map/layout.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

using Scans = std::span<const MappedScan>;

struct StatusStyle {
  TrackStatus status;
  Color value;
  const char* words;
};

constexpr std::array<StatusStyle, 3> kStatusStyles = {
    {{TrackStatus::kTracked, palette::kTracked, "robot's path"},
     {TrackStatus::kDegenerate, palette::kDegenerate, "one direction open"},
     {TrackStatus::kLost, palette::kLost, "not matched"}}};

/// Whether a pose is drawn in this style; one that was recovered is tracked again.
bool has_style(const MappedScan& scan, const StatusStyle& style) {
  const bool is_recovered = scan.status == TrackStatus::kRecovered;
  return scan.is_placed && (is_recovered ? TrackStatus::kTracked : scan.status) == style.status;
}

const PixelPoint kGap = PixelPoint::Constant(std::nan(""));

/// Poses that are not placed become gaps, of the path and of closures.
void leave_out_unplaced(std::vector<Eigen::Vector2d>& path_cells, Scans scans) {
  for (std::size_t i = 0; i < path_cells.size(); ++i) {
    if (!scans[i].is_placed) path_cells[i] = kGap;
  }
}

/// The path in its colours; a stretch has the colour of the pose that it leads to.
void draw_path(Image& image,
               const MapLayout& layout,
               std::span<const Eigen::Vector2d> path_cells,
               const MapPictureLayers& layers) {
  const Scans scans = layers.scans;
  const auto begins_way = [&](std::size_t scan) {
    return std::ranges::binary_search(layers.sessions, scan, {}, &MapSession::first_scan) ||
           std::ranges::binary_search(layers.gaps, scan, {}, &ForgottenPoses::next_scan);
  };
  for (const StatusStyle& style : kStatusStyles) {
    std::vector<PixelPoint> line;
    for (std::size_t i = 1; i < path_cells.size(); ++i) {
      if (!has_style(scans[i], style)) continue;
      if (begins_way(i)) {
        line.push_back(kGap);
        line.push_back(layout.pixel_of(path_cells[i]));
        continue;
      }
      if (i == 1 || !has_style(scans[i - 1], style)) {
        line.push_back(kGap);
        line.push_back(layout.pixel_of(path_cells[i - 1]));
      }
      line.push_back(layout.pixel_of(path_cells[i]));
    }
    draw_polyline(image, line, std::max(1.5, 0.15 * layout.letter_px), style.value);
  }
}

// In heights of a letter; where a path ends at its start, both marks show.
constexpr double kStartRadius = 0.75;
constexpr double kEndRadius = 0.45;

void draw_mark(Image& image, const PixelPoint& centre, double radius_px, Color value) {
  fill_disc(image, centre, 1.25 * radius_px + 1.0, palette::kPaper);
  fill_disc(image, centre, radius_px, value);
}

std::vector<LegendEntry> legend_entries(Scans scans, const PlacedClosures& closures) {
  std::vector<LegendEntry> entries;
  if (scans.empty()) return entries;
  entries.push_back({"start", palette::kStart, kStartRadius});
  entries.push_back({"end", palette::kEnd, kEndRadius});
  for (const StatusStyle& style : kStatusStyles) {
    const auto is_drawn = [&](const MappedScan& scan) { return has_style(scan, style); };
    if (std::ranges::any_of(scans, is_drawn)) entries.push_back({style.words, style.value});
  }
  for (LegendEntry& entry : legend_entries(closures)) entries.push_back(std::move(entry));
  return entries;
}

Trajectory trajectory_of(Scans scans) {
  Trajectory trajectory;
  trajectory.reserve(scans.size());
  for (const MappedScan& scan : scans) trajectory.push_back({scan.stamp, scan.T_map_base});
  return trajectory;
}

}  // namespace

void MapPictureParams::validate() const {
  if (max_side_px < 100) throw ParameterError("max_side_px", "must be at least 100");
  if (min_side_px < 1) throw ParameterError("min_side_px", "must be positive");
  if (!(margin_m >= 0.0 && margin_m <= 1000.0)) {
    throw ParameterError("margin_m", "must be between 0 and 1000");
  }
}

Image layered_map_picture(const OccupancyGrid& grid,
                          const MapPictureLayers& layers,
                          const MapPictureParams& params) {
  params.validate();
  const Trajectory trajectory = trajectory_of(layers.scans);
  std::vector<Eigen::Vector2d> path = path_in_cells(grid, trajectory);
  leave_out_unplaced(path, layers.scans);
  const PlacedClosures closures = placed_closures(layers.closures, trajectory, path);
  MapLayout layout =
      map_layout(box_to_show(grid, path, params.margin_m), params.min_side_px, params.max_side_px);
  const double letter_px = layout.letter_px;
  std::vector<LegendEntry> entries;
  if (params.has_legend) entries = legend_entries(layers.scans, closures);
  if (params.has_legend && !layers.doubts.empty()) entries.push_back(doubt_legend_entry());
  constexpr double kMaxBarLetters = 20.0;
  const double bar_width_px = params.has_scale_bar ? (kMaxBarLetters + 6.0) * letter_px : 0.0;
  const double footer_width_px = bar_width_px + legend_width_px(entries, letter_px);
  if (footer_width_px > 0.0) layout.add_footer(footer_width_px + 4.0 * letter_px);

  Image image(layout.width_px, layout.height_px, palette::kPaper);
  fill_rectangle(
      image, {0, 0}, PixelPoint(layout.width_px, layout.map_height_px), palette::kUnknown);
  draw_cells(image, layout.left_px, 0, grid, layout.box, layout.scale);
  draw_closures(image, layout, closures);
  draw_path(image, layout, path, layers);
  const auto is_placed = [](const Eigen::Vector2d& place) { return place.allFinite(); };
  const auto first = std::find_if(path.begin(), path.end(), is_placed);
  const auto last = std::find_if(path.rbegin(), path.rend(), is_placed);
  if (first != path.end()) {
    draw_mark(image, layout.pixel_of(*first), kStartRadius * letter_px, palette::kStart);
    draw_mark(image, layout.pixel_of(*last), kEndRadius * letter_px, palette::kEnd);
  }
  draw_doubts(image, layout, grid, layers.doubts);
  // What lies beyond the map ends at its edge.
  fill_rectangle(image,
                 PixelPoint(0, layout.map_height_px),
                 PixelPoint(layout.width_px, layout.height_px),
                 palette::kPaper);
  const double footer_px = 0.5 * (layout.map_height_px + layout.height_px);
  if (params.has_scale_bar) {
    const double pixels_per_m = layout.scale.pixels_per_cell() / grid.resolution_m();
    const PixelPoint start(2.0 * letter_px, footer_px);
    draw_scale_bar(image, start, kMaxBarLetters * letter_px, pixels_per_m, letter_px);
  }
  draw_legend(image, {layout.width_px - 2.0 * letter_px, footer_px}, entries, letter_px);
  return image;
}

Image map_picture(const OccupancyGrid& grid,
                  const Trajectory& T_map_base,
                  const MapPictureParams& params) {
  std::vector<MappedScan> scans;
  for (const StampedPose& pose : T_map_base) {
    scans.push_back({.stamp = pose.stamp, .T_map_sensor = pose.pose, .T_map_base = pose.pose});
  }
  return layered_map_picture(grid, {.scans = scans, .closures = {}}, params);
}

}  // namespace setsquare
