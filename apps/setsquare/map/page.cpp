// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "apps/setsquare/map/image.hpp"
#include "apps/setsquare/map/report.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/mapping/track_certainty.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare::app {
namespace {

ReportCondition report_condition_from(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return ReportCondition::kTracked;
    case TrackStatus::kDegenerate:
      return ReportCondition::kDegenerate;
    case TrackStatus::kRecovered:
      return ReportCondition::kRecovered;
    case TrackStatus::kLost:
      break;
  }
  return ReportCondition::kLost;
}

std::vector<ReportPose> poses_of(const MappedTrack& track) {
  const std::vector<double> sigmas_m = position_sigmas_m(track);
  const std::vector<bool> is_placed = scans_placed(track);
  std::vector<ReportPose> poses;
  poses.reserve(track.scans.size());
  for (std::size_t i = 0; i < track.scans.size(); ++i) {
    const MappedScan& scan = track.scans[i];
    poses.push_back({.stamp = scan.stamp,
                     .T_map_base = scan.T_map_base,
                     .condition = is_placed[i] ? report_condition_from(scan.status)
                                               : ReportCondition::kNotPlaced});
    if (!sigmas_m.empty()) poses.back().sigma_m = sigmas_m[i];
  }
  return poses;
}

PointSet points_in_base(const Scan& scan) {
  PointSet points = points_from_scan(scan);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = scan.T_base_sensor * Eigen::Vector2d(points.x_m[i], points.y_m[i]);
    points.x_m[i] = p.x();
    points.y_m[i] = p.y();
  }
  return points;
}

/// The closures, and the scans that they show.
void add_closures(const MapRun& run, MapReport& report) {
  std::unordered_map<std::size_t, std::size_t> place_of_scan;
  for (std::size_t k = 0; k < run.picture_scans.size(); ++k) {
    place_of_scan[run.picture_scans[k].index] = k;
  }
  std::unordered_map<std::size_t, std::size_t> shown;
  const auto show = [&](std::size_t scan) {
    const auto [entry, is_new] = shown.try_emplace(scan, report.scans.size());
    if (is_new) {
      report.scans.push_back(
          {.stamp = run.track.scans[scan].stamp,
           .T_map_base = run.track.scans[scan].T_map_base,
           .points = points_in_base(run.picture_scans[place_of_scan.at(scan)].scan)});
    }
    return entry->second;
  };
  for (const MappedClosure& mapped : run.track.closures) {
    const std::size_t scan_i = show(mapped.scan_i);
    const std::size_t scan_j = show(mapped.scan_j);
    report.closures.push_back({mapped.closure, scan_i, scan_j});
  }
}

void add_headings(const MappedTrack& track, MapReport& report) {
  const FusedHeadings& headings = track.headings;
  for (const HeadingFrame& frame : headings.frames) {
    report.frame_headings_rad.push_back(frame.offset_rad);
  }
  for (std::size_t k = 0; k < headings.heading_rad.size(); ++k) {
    const MappedScan& scan = track.scans[track.keyframes[k]];
    const double to_base_rad = wrap_to_pi(scan.T_map_base.theta_rad - scan.T_map_sensor.theta_rad);
    ReportHeading heading{
        .stamp = scan.stamp,
        .measured_rad = std::nullopt,
        .frame = std::max(0, headings.frame[k]),
        .weight = headings.weight[k],
        .fused_rad = scan.T_map_base.theta_rad,
        .tracked_rad = headings.heading_rad[k] - headings.drift_rad[k] + to_base_rad};
    if (headings.frame[k] >= 0) {
      heading.measured_rad = headings.measured_heading_rad[k] + to_base_rad;
    }
    report.headings.push_back(heading);
  }
}

class Figures {
 public:
  explicit Figures(std::vector<ReportFigure>& figures) : figures_(figures) {}

  void add(const std::string& group,
           const std::string& name,
           const std::string& value,
           const std::string& unit = "",
           const std::string& explanation = "") {
    figures_.push_back({group, name, value, unit, explanation});
  }
  void add(const std::string& group,
           const std::string& name,
           std::size_t count,
           const std::string& explanation = "") {
    add(group, name, std::to_string(count), "", explanation);
  }

 private:
  std::vector<ReportFigure>& figures_;
};

void add_track_figures(const MapRun& run, Figures& figures) {
  const MappedTrack& track = run.track;
  std::array<std::size_t, 4> count{};
  for (const MappedScan& scan : track.scans) ++count[static_cast<std::size_t>(scan.status)];
  figures.add("Track", "scans", track.scans.size());
  figures.add(
      "Track",
      "with odometry",
      run.num_with_odometry,
      "Scans whose motion the robot's wheels told, too; they are a witness, not the truth.");
  figures.add("Track", "way", fmt::format("{:.1f}", path_length_m(track)), "m");
  figures.add("Track", "keyframes", track.keyframes.size(), "Scans that the map is built of.");
  figures.add("Track",
              "degenerate",
              count[static_cast<std::size_t>(TrackStatus::kDegenerate)],
              "Scans whose walls leave one direction open, as in a bare corridor.");
  figures.add("Track",
              "recovered",
              count[static_cast<std::size_t>(TrackStatus::kRecovered)],
              "Scans found again, anywhere and at any turn, after tracking had lost them.");
  figures.add("Track",
              "lost",
              count[static_cast<std::size_t>(TrackStatus::kLost)],
              "Scans that fit nowhere: their poses are guesses, and the map leaves them out.");
  std::size_t num_unjoined = 0;
  for (const TrackPiece& piece : track.pieces) num_unjoined += !piece.is_joined;
  figures.add("Track",
              "pieces not joined",
              num_unjoined,
              "Stretches of which nobody knows where they lie in the map; they are left out.");
}

void add_closure_figures(const MapRun& run, Figures& figures) {
  const ClosureCounts counts = count_closures(run.track);
  figures.add("Loop closures", "compared", counts.num_compared, "Pairs of places near each other.");
  figures.add("Loop closures", "accepted", counts.num_accepted);
  figures.add("Loop closures",
              "of one axis",
              counts.num_one_axis,
              "Accepted across a corridor, open along it.");
  figures.add("Loop closures",
              "outvoted",
              counts.num_outvoted,
              "Accepted at first, then at odds with all the others: weight below one half.");
}

void add_building_figures(const MapRun& run, Figures& figures) {
  for (const HeadingFrame& frame : run.track.headings.frames) {
    figures.add("Building",
                "walls at",
                fmt::format("{:.2f}", deg_from_rad(frame.offset_rad)),
                "deg",
                "A direction, modulo 90 degrees, along which walls run.");
  }
  double open_m = 0.0;
  double worst_sigma_m = 0.0;
  for (const OpenStretch& stretch : run.open_stretches) {
    open_m += stretch.way_m;
    worst_sigma_m = std::max(worst_sigma_m, stretch.length_sigma_m);
  }
  figures.add("Building",
              "way in bare corridors",
              fmt::format("{:.1f}", open_m),
              "m",
              "Where no scan determines the motion along the corridor.");
  figures.add("Building",
              "their length is known to",
              fmt::format("{:.2f}", worst_sigma_m),
              "m",
              "Standard deviation of the least certain of them, given odometry and closures.");
}

}  // namespace

MapReport map_page(const MapOptions& options, const MapRun& run, const OccupancyGrid& grid) {
  MapReport report;
  report.title = title_of_log(options.log_path);
  report.grid = &grid;
  report.poses = poses_of(run.track);
  add_closures(run, report);
  add_headings(run.track, report);
  Figures figures(report.figures);
  add_track_figures(run, figures);
  add_closure_figures(run, figures);
  add_building_figures(run, figures);
  return report;
}

}  // namespace setsquare::app
