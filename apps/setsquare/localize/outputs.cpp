// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/localize/outputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/map/picture.hpp"

namespace setsquare::app {
namespace {

std::string localisation_tsv(const LocalizedLog& log, PoseOf pose_of) {
  std::string text =
      "stamp\tstatus\tx_m\ty_m\theading_deg\tsigma_x_m\tsigma_y_m\tcorrelation_xy\t"
      "sigma_heading_deg\tprobability\tconfirmed\tunconfirmed_m\talternatives\n";
  for (const LocalisedPose& pose : log.poses) {
    const Pose2& at = pose_of == PoseOf::kSensor ? pose.T_map_sensor : pose.T_map_base;
    const double sigma_x_m = std::sqrt(pose.covariance(0, 0));
    const double sigma_y_m = std::sqrt(pose.covariance(1, 1));
    const double product_m2 = sigma_x_m * sigma_y_m;
    std::string alternatives;
    for (const PossiblePlace& place : pose.alternatives) {
      const Pose2& T = place.T_map_sensor;
      alternatives += fmt::format("{}{:.3f},{:.3f},{:.2f}:{:.4f}",
                                  alternatives.empty() ? "" : ";",
                                  T.x_m,
                                  T.y_m,
                                  deg_from_rad(T.theta_rad),
                                  place.probability);
    }
    fmt::format_to(
        std::back_inserter(text),
        "{}\t{}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.5f}\t{}\t{:.3f}\t{}\n",
        to_string(pose.stamp),
        to_string(pose.status),
        at.x_m,
        at.y_m,
        deg_from_rad(wrap_to_pi(at.theta_rad)),
        sigma_x_m,
        sigma_y_m,
        product_m2 > 0.0 ? std::clamp(pose.covariance(0, 1) / product_m2, -1.0, 1.0) : 0.0,
        deg_from_rad(std::sqrt(pose.covariance(2, 2))),
        pose.probability,
        pose.is_confirmed ? 1 : 0,
        pose.unconfirmed_m,
        alternatives.empty() ? "-" : alternatives);
  }
  return text;
}

/// The way as the picture of a map has it: scans that are not localised are gaps.
std::vector<MappedScan> as_drawn(const LocalizedLog& log) {
  std::vector<MappedScan> scans;
  for (const LocalisedPose& pose : log.poses) {
    MappedScan scan;
    scan.stamp = pose.stamp;
    scan.is_placed = pose.status == LocalisationStatus::kLocalised;
    scan.T_map_sensor = pose.T_map_sensor;
    scan.T_map_base = pose.T_map_base;
    scans.push_back(scan);
  }
  return scans;
}

std::string run_json_of(const LocalizedLog& log, const std::string& map_name, PoseOf pose_of) {
  const LocalisationCounts counts = counts_of(log);
  nlohmann::ordered_json json = {{"setsquare", SETSQUARE_VERSION},
                                 {"command", "localize"},
                                 {"log", log.name},
                                 {"format", log.format},
                                 {"sensor", log.sensor},
                                 {"map", map_name},
                                 {"pose_of", pose_of == PoseOf::kSensor ? "sensor" : "base"},
                                 {"scans", counts.num_scans()},
                                 {"localised", counts.num_localised},
                                 {"ambiguous", counts.num_ambiguous},
                                 {"lost", counts.num_lost},
                                 {"confirmed", counts.num_confirmed}};
  json["first_localised"] = counts.first_localised ? nlohmann::ordered_json(*counts.first_localised)
                                                   : nlohmann::ordered_json(nullptr);
  if (log.left_out.num_scans() > 0) json["forgotten_poses"] = log.left_out.num_scans();
  return json.dump(2) + "\n";
}

}  // namespace

std::vector<std::string> localize_output_names() {
  return {"trajectory.tum", "localisation.tsv", "localisation.png", "run.json"};
}

std::vector<NamedBytes> localize_outputs(const LocalizedLog& log,
                                         const OccupancyGrid& grid,
                                         const std::string& map_name,
                                         PoseOf pose_of) {
  const std::vector<MappedScan> scans = as_drawn(log);
  return {{"trajectory.tum", tum_from_trajectory(trajectory_of(log, pose_of))},
          {"localisation.tsv", localisation_tsv(log, pose_of)},
          {"localisation.png",
           png_from_image(layered_map_picture(grid, {.scans = scans, .closures = {}}))},
          {"run.json", run_json_of(log, map_name, pose_of)}};
}

}  // namespace setsquare::app
