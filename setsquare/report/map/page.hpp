// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// How a pose of the track was found.
enum class ReportCondition {
  kTracked,
  kDegenerate,  ///< The scans did not determine the motion along one direction.
  kRecovered,   ///< Found again by the guess-free matcher after a gap or a fast turn.
  kLost,        ///< No match: the pose is carried on by the odometry or the last motion.
  kNotPlaced,   ///< Of a piece of track that nobody can place in the map: not drawn.
};

struct ReportPose {
  Timestamp stamp;
  Pose2 T_map_base;
  ReportCondition condition = ReportCondition::kTracked;
  /// Standard deviation of the position along its least certain direction; NaN where unknown.
  double sigma_m = std::numeric_limits<double>::quiet_NaN();
};

/// A scan that a loop closure shows.
struct ReportScan {
  Timestamp stamp;
  Pose2 T_map_base;
  PointSet points;  ///< In the base frame, in the order of the beams.
};

struct ReportClosure {
  LoopClosure closure;     ///< Its stamps may differ from the scans'; the scans' are shown.
  std::size_t scan_i = 0;  ///< Index in MapReport::scans.
  std::size_t scan_j = 0;
};

/// A keyframe's heading, in rad in the map frame.
struct ReportHeading {
  Timestamp stamp;
  /// Against the building, its frame's direction included, known modulo 90 degrees; nothing where
  /// no wall was measured.
  std::optional<double> measured_rad;
  int frame = 0;             ///< Which of the building's frames: index in frame_headings_rad.
  double weight = 0.0;       ///< How far the measured heading was believed, 0 to 1.
  double fused_rad = 0.0;    ///< The heading that the map uses.
  double tracked_rad = 0.0;  ///< By tracking alone, drift included.
};

/// One line of a table of the run.
struct ReportFigure {
  std::string group;  ///< Heads the table; figures of one group need not stand together.
  std::string name;
  std::string value;
  std::string unit;         ///< May be empty.
  std::string explanation;  ///< A sentence for a reader who does not know the name; may be empty.
};

/// What the page about a map shows. Everything but the title may be empty.
struct MapReport {
  std::string title;
  const OccupancyGrid* grid = nullptr;  ///< The caller's; the page stands as its rows do.
  std::vector<ReportPose> poses;        ///< In file order; their stamps may run backwards.
  std::vector<ReportScan> scans;        ///< Those that no closure names are left out of the page.
  std::vector<ReportClosure> closures;
  std::vector<ReportHeading> headings;
  std::vector<double> frame_headings_rad;  ///< Direction of the walls of each building frame.
  std::vector<ReportFigure> figures;
};

/// One page that needs no other file and no network: the map with the track, the loop closures, the
/// headings and the figures, to look into with mouse, touch and keyboard. Positions are kept to the
/// mm, angles to 0.1 mrad, points of scans to the cm. The same report gives the same bytes. A
/// closure must name scans that are there.
[[nodiscard]] std::string map_report_html(const MapReport& report);

}  // namespace setsquare
