// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/map/map.hpp"

namespace setsquare {

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
  const Map& map;                          ///< Its stamps may run backwards.
  const OccupancyGrid* grid = nullptr;     ///< The page stands as its rows do.
  std::vector<ReportFigure> figures = {};  ///< map_figures(map), and what the caller adds.
};

/// The figures of a map: its track, its loop closures, its building.
[[nodiscard]] std::vector<ReportFigure> map_figures(const Map& map);

/// One page that needs no other file and no network: the map with the track, the loop closures, the
/// headings and the figures, to look into with mouse, touch and keyboard. Positions are kept to the
/// mm, angles to 0.1 mrad, points of scans to the cm. The same report gives the same bytes. A
/// closure must be of scans that Map::kept_scans holds.
[[nodiscard]] std::string map_report_html(const MapReport& report);

}  // namespace setsquare
