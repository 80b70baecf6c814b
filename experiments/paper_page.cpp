// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// paper.html: the template of web/ with two data blocks, the numbers of paper.json and what only
// the pictures need: walls, tracks, errors along the track, maps.
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "experiments/page_web.hpp"
#include "experiments/paper_experiment.hpp"
#include "setsquare/report/map/page_data.hpp"
#include "setsquare/report/page_template.hpp"

namespace setsquare::experiments {
namespace {

/// To the millimetre (or a thousandth of a degree): a picture shows no more.
double rounded(double value) { return std::round(1000.0 * value) / 1000.0; }

Json walls_json(const FloorPlan& plan) {
  Json walls = Json::array();
  for (const PlanSegment& segment : plan.segments) {
    walls.push_back({rounded(segment.start_m.x()),
                     rounded(segment.start_m.y()),
                     rounded(segment.end_m.x()),
                     rounded(segment.end_m.y())});
  }
  return walls;
}

Json path_json(const std::string& name, const std::vector<Pose2>& T_map_base) {
  Json points = Json::array();
  for (const Pose2& pose : T_map_base) points.push_back({rounded(pose.x_m), rounded(pose.y_m)});
  return {{"name", name}, {"points", points}};
}

/// Position error against the distance travelled, every tenth scan.
Json position_error_json(const std::string& name,
                         const CircuitRun& run,
                         const ChainOutcome& track) {
  const std::vector<double> path_m = travelled_m(run.truth);
  Json points = Json::array();
  for (std::size_t k = 0; k < run.truth.size(); k += 10) {
    const Eigen::Vector2d error_m =
        track.chain.T_map_base[k].translation() - run.truth[k].translation();
    points.push_back({rounded(path_m[k]), rounded(error_m.norm())});
  }
  return {{"name", name}, {"points", points}};
}

/// Heading error in deg against the distance travelled, every fifth scan.
Json heading_error_json(const std::string& name, const CircuitRun& run, const ChainOutcome& track) {
  const std::vector<double> path_m = travelled_m(run.truth);
  Json points = Json::array();
  for (std::size_t k = 0; k < run.truth.size(); k += 5) {
    const double error_rad =
        wrap_to_pi(track.chain.T_map_base[k].theta_rad - run.truth[k].theta_rad);
    points.push_back({rounded(path_m[k]), rounded(deg_from_rad(error_rad))});
  }
  return {{"name", name}, {"points", points}};
}

Json hallway_drawing(const HallwayRun& run) {
  return {{"walls", walls_json(run.plan)},
          {"paths", Json::array({path_json("the robot's path", run.T_map_base)})}};
}

Json circuit_drawing(const CircuitStudy& study) {
  const CircuitRun& first = study.runs.front();
  Json paths = Json::array();
  Json position = Json::array();
  Json heading = Json::array();
  const std::pair<const char*, const ChainOutcome*> shown[] = {
      {"--preset paper, in sequence", &first.paper},
      {"default", &first.ours},
      {"full mapper", &first.mapper}};
  for (const auto& [name, track] : shown) {
    paths.push_back(path_json(name, track->chain.T_map_base));
    position.push_back(position_error_json(name, first, *track));
    heading.push_back(heading_error_json(name, first, *track));
  }
  paths.push_back(path_json("true track", first.truth));
  return {{"walls", walls_json(study.plan)},
          {"paths", paths},
          {"position_error_m", position},
          {"heading_error_deg", heading},
          {"maps",
           {{"default", base64(study.default_map)},
            {"paper", base64(study.paper_map)},
            {"full_mapper", base64(study.mapper_map)}}}};
}

}  // namespace

std::string paper_html(const PaperExperiment& experiment) {
  Json drawings = Json::object();
  if (experiment.hallways) drawings["hallway"] = hallway_drawing(experiment.hallways->runs.front());
  if (experiment.circuits) drawings["circuit"] = circuit_drawing(*experiment.circuits);
  // In the order of the page, so that nothing that was put in is taken for a mark.
  const std::array<PageMark, 4> marks = {{{"@STYLE@", paper_style()},
                                          {"@NUMBERS@", json_within_script(paper_json(experiment))},
                                          {"@DRAWINGS@", json_within_script(drawings.dump())},
                                          {"@SCRIPT@", paper_script()}}};
  return filled_page(paper_page(), marks);
}

}  // namespace setsquare::experiments
