// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/peers/mrpt_icp.hpp"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPosePDF.h>
#include <mrpt/slam/CICP.h>

#include <algorithm>
#include <cmath>

namespace setsquare::peers {
namespace {

/// MRPT's beams are symmetric about the x axis of the sensor: what ours are not turns the sensor.
mrpt::obs::CObservation2DRangeScan observation_from_scan(const Scan& scan) {
  mrpt::obs::CObservation2DRangeScan observation;
  const std::size_t num_beams = scan.num_beams();
  observation.aperture = static_cast<float>(scan.field_of_view_rad());
  observation.rightToLeft = scan.bearing_step_rad >= 0.0;
  observation.maxRange = static_cast<float>(std::min(scan.max_range_m, 1e6));
  observation.resizeScan(num_beams);
  for (std::size_t beam = 0; beam < num_beams; ++beam) {
    const bool is_return = scan.outcome(beam) == BeamOutcome::kReturn;
    observation.setScanRange(beam, is_return ? static_cast<float>(scan.ranges_m[beam]) : 0.0F);
    observation.setScanRangeValidity(beam, is_return);
  }
  const double middle_rad =
      scan.first_bearing_rad + 0.5 * scan.bearing_step_rad * (static_cast<double>(num_beams) - 1.0);
  observation.sensorPose.setFromValues(0.0, 0.0, 0.0, middle_rad, 0.0, 0.0);
  return observation;
}

mrpt::maps::CSimplePointsMap point_map_from_scan(const Scan& scan) {
  mrpt::maps::CSimplePointsMap map;
  map.loadFromRangeScan(observation_from_scan(scan));
  return map;
}

}  // namespace

Pose2 match_by_mrpt_icp(const Scan& reference, const Scan& current, MrptIcpAlgorithm algorithm) {
  const mrpt::maps::CSimplePointsMap reference_map = point_map_from_scan(reference);
  const mrpt::maps::CSimplePointsMap current_map = point_map_from_scan(current);
  mrpt::slam::CICP icp;
  icp.options.ICP_algorithm = algorithm == MrptIcpAlgorithm::kClassic
                                  ? mrpt::slam::icpClassic
                                  : mrpt::slam::icpLevenbergMarquardt;
  const auto answer = icp.Align(&reference_map, &current_map, mrpt::poses::CPose2D());
  const mrpt::poses::CPose2D pose(answer->getMeanVal());
  return {pose.x(), pose.y(), wrap_to_pi(pose.phi())};
}

}  // namespace setsquare::peers
