// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/report/map/page.hpp"

namespace setsquare {
namespace {

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

void add_track_figures(const MapSummary& summary, std::size_t num_with_odometry, Figures& figures) {
  figures.add("Track", "scans", summary.num_scans);
  figures.add(
      "Track",
      "with odometry",
      num_with_odometry,
      "Scans that came with wheel odometry, which helps tracking but is not taken as truth.");
  figures.add("Track", "way", fmt::format("{:.1f}", summary.path_m), "m");
  figures.add("Track", "keyframes", summary.num_keyframes, "Scans that the map is built of.");
  figures.add("Track",
              "degenerate",
              summary.num_degenerate,
              "Scans whose walls leave one direction open, as in a bare corridor.");
  figures.add("Track",
              "recovered",
              summary.num_recovered,
              "Scans found again, anywhere and at any turn, after tracking had lost them.");
  figures.add("Track",
              "lost",
              summary.num_lost,
              "Scans that fit nowhere: their poses are guesses, and the map leaves them out.");
  figures.add("Track",
              "pieces not joined",
              summary.num_unjoined_pieces,
              "Stretches whose place in the map is unknown; they are left out.");
}

void add_closure_figures(const MapSummary& summary, Figures& figures) {
  figures.add("Loop closures",
              "compared",
              summary.num_compared_closures,
              "Pairs of places near each other.");
  figures.add("Loop closures", "accepted", summary.num_accepted_closures);
  figures.add("Loop closures",
              "of one axis",
              summary.num_one_axis_closures,
              "Accepted across a corridor, open along it.");
  figures.add("Loop closures",
              "outvoted",
              summary.num_outvoted_closures,
              "Accepted at first, then at odds with all the others: weight below one half.");
}

void add_building_figures(const Map& map, const MapSummary& summary, Figures& figures) {
  for (const BuildingFrame& frame : map.frames) {
    figures.add("Building",
                "walls at",
                fmt::format("{:.2f}", deg_from_rad(frame.offset_rad)),
                "deg",
                "A direction, modulo 90 degrees, along which walls run.");
  }
  figures.add("Building",
              "way in bare corridors",
              fmt::format("{:.1f}", summary.open_m),
              "m",
              "Where no scan determines the motion along the corridor.");
  figures.add("Building",
              "their length is known to",
              fmt::format("{:.2f}", summary.worst_length_sigma_m),
              "m",
              "Standard deviation of the least certain of them, given odometry and closures.");
}

}  // namespace

std::vector<ReportFigure> map_figures(const Map& map) {
  const MapSummary summary = summary_of(map);
  std::vector<ReportFigure> rows;
  Figures figures(rows);
  add_track_figures(summary, map.num_with_odometry, figures);
  add_closure_figures(summary, figures);
  add_building_figures(map, summary, figures);
  return rows;
}

}  // namespace setsquare
