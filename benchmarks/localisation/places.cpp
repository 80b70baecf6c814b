// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/localisation/places.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <map>
#include <span>
#include <vector>

#include "setsquare/eval/absolute_trajectory_error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "setsquare/sim/floor_plan_from_cells.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {
namespace {

/// A random place in free space, nothing nearer than this, any heading.
constexpr double kClearance_m = 0.3;

Pose2 random_free_pose(const WallDistance& walls, Random& random) {
  while (true) {
    const double x_m = random.uniform(0.0, walls.num_columns() * walls.resolution_m());
    const double y_m = random.uniform(0.0, walls.num_rows() * walls.resolution_m());
    const CellIndex cell = walls.cell_at(x_m, y_m);
    if (walls.state(cell) != CellState::kFree || walls.distance_m(cell) < kClearance_m) continue;
    return {x_m, y_m, random.uniform(-kPi, kPi)};
  }
}

SimulatedScan still_scan(const RayCaster& caster,
                         const std::vector<Person>& people,
                         const ScannerModel& scanner,
                         const Pose2& T_map_sensor,
                         double time_s,
                         Random& random) {
  const RobotPath path({T_map_sensor.translation()});
  return simulate_scan(
      caster, people, scanner, path, time_s, random, {0.0, 0.0, T_map_sensor.theta_rad});
}

/// The map of a share of the route, from its start on.
KnownMap map_of_route(const Building& building,
                      const RayCaster& caster,
                      std::uint64_t seed,
                      double share = 1.0) {
  const RobotPath path(building.route_m);
  Random random(sub_seed(seed, 31));
  std::vector<SimulatedScan> scans;
  for (double at_m = 0.0; at_m < share * path.length_m(); at_m += 0.4) {
    const double time_s = path.time_at_route_distance(at_m);
    scans.push_back(simulate_scan(caster, building.people, utm_30lx(), path, time_s, random));
  }
  std::vector<PlacedScan> placed;
  for (const SimulatedScan& scan : scans) placed.push_back({&scan.scan, scan.T_map_base});
  GridFromScansParams params;
  params.resolution_m = seed % 2 == 0 ? 0.05 : 0.1;
  return KnownMap(grid_from_scans(placed, 0.0, params), placed);
}

/// The building some time later: of its furniture and clutter a part has moved, a part is gone.
FloorPlan refurnished(const FloorPlan& plan, Random& random) {
  constexpr double kMoved = 0.35;
  constexpr double kGone = 0.15;
  constexpr double kMove_m = 0.5;
  FloorPlan later;
  Eigen::Vector2d move_m = Eigen::Vector2d::Zero();
  bool is_gone = false;
  const PlanSegment* last = nullptr;
  for (const PlanSegment& segment : plan.segments) {
    const bool continues = last != nullptr && last->material == segment.material &&
                           (last->end_m - segment.start_m).norm() < 1e-9;
    if (!continues) {
      const double fate = random.uniform();
      const double x_m = kMove_m * random.normal();
      const double y_m = kMove_m * random.normal();
      const bool may_move = is_clutter(segment.material);
      is_gone = may_move && fate < kGone;
      move_m =
          may_move && fate < kGone + kMoved ? Eigen::Vector2d(x_m, y_m) : Eigen::Vector2d(0.0, 0.0);
    }
    last = &segment;
    if (is_gone) continue;
    later.segments.push_back({segment.start_m + move_m, segment.end_m + move_m, segment.material});
  }
  return later;
}

}  // namespace

ScannerModel still_scanner(double field_of_view_rad,
                           std::size_t num_beams,
                           double noise_m,
                           double max_range_m) {
  ScannerModel scanner;
  scanner.name = "still";
  scanner.num_beams = num_beams;
  const bool is_round = field_of_view_rad > kTwoPi - 1e-6;
  scanner.first_bearing_rad = -0.5 * field_of_view_rad;
  scanner.bearing_step_rad =
      field_of_view_rad / static_cast<double>(is_round ? num_beams : num_beams - 1);
  scanner.min_range_m = 0.02;
  scanner.max_range_m = max_range_m;
  scanner.noise_share = 100.0;
  scanner.near_noise_m = noise_m;
  scanner.far_noise_m = noise_m;
  scanner.resolution_m = 0.001;
  return scanner;
}

void visit_map_image(const std::string& yaml_path,
                     const ScannerModel& scanner,
                     std::size_t num_scans,
                     std::uint64_t seed,
                     const VisitPlace& visit) {
  const OccupancyGrid grid = read_map_pgm_yaml(yaml_path);
  const KnownMap map(grid);
  PlanCells cells;
  cells.T_map_cells = grid.T_map_grid();
  cells.resolution_m = grid.resolution_m();
  cells.num_columns = static_cast<std::size_t>(grid.num_columns());
  cells.num_rows = static_cast<std::size_t>(grid.num_rows());
  for (const float value : grid.values()) cells.is_filled.push_back(value > 0.0F);
  const RayCaster caster(floor_plan_from_cells(cells));
  Random random(seed);
  for (std::size_t k = 0; k < num_scans; ++k) {
    const Pose2 T_map_sensor = grid.T_map_grid() * random_free_pose(map.walls(), random);
    const SimulatedScan scan = still_scan(caster, {}, scanner, T_map_sensor, 0.0, random);
    visit({map, scan.scan, T_map_sensor});
  }
}

void visit_building(BuildingClass building_class,
                    std::uint64_t seed,
                    const ScannerModel& scanner,
                    std::size_t num_scans,
                    bool is_partly_mapped,
                    const VisitPlace& visit) {
  const Building building = make_building(building_class, seed);
  const RayCaster caster(building.plan);
  const double share = is_partly_mapped ? 0.5 : 1.0;
  const KnownMap map = map_of_route(building, caster, seed, share);
  // Places of the whole building, whether they are in the map or not.
  const KnownMap whole = map_of_route(building, caster, seed);
  Random random(sub_seed(seed, 32));
  const RayCaster later(refurnished(building.plan, random));
  for (std::size_t k = 0; k < num_scans; ++k) {
    const Pose2 T = whole.T_map_grid() * random_free_pose(whole.walls(), random);
    // People stand elsewhere by then, too.
    const SimulatedScan scan = still_scan(later, building.people, scanner, T, 1e4, random);
    visit({map, scan.scan, T});
  }
}

MappedHalf mapped_half(const std::string& log_path, bool maps_second) {
  MappedHalf half;
  std::vector<Scan>& scans = half.scans;
  const auto reader = open_log(log_path);
  while (const LogRecord* record = reader->next()) scans.push_back(record->scan);
  Mapper whole_mapper;
  Mapper half_mapper;
  const std::size_t begin = maps_second ? scans.size() / 2 : 0;
  const std::size_t end = maps_second ? scans.size() : scans.size() / 2;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    whole_mapper.add(scans[i]);
    if (i >= begin && i < end) half_mapper.add(scans[i]);
  }
  const Map whole = whole_mapper.finish();
  const Map part = half_mapper.finish();
  // The two maps' frames, by the scans that both have.
  std::vector<PosePair> pairs;
  const std::size_t stride = std::clamp<std::size_t>(part.scans.size() / 50, 1, 10);
  for (std::size_t i = 0; i < part.scans.size(); i += stride) {
    const MappedScan& in_whole = whole.scans[begin + i];
    if (!part.scans[i].is_placed || !in_whole.is_placed) continue;
    pairs.push_back({in_whole.stamp, in_whole.T_map_sensor, part.scans[i].T_map_sensor});
  }
  const Pose2 T_part_whole = best_rigid_alignment(pairs);
  for (const MappedScan& scan : whole.scans) {
    half.T_map_sensor.push_back(scan.is_placed ? std::optional(T_part_whole * scan.T_map_sensor)
                                               : std::nullopt);
  }
  half.map = std::make_shared<const KnownMap>(part);
  return half;
}

double overlap_with_map(const KnownMap& map, const Scan& scan, const Pose2& T_map_sensor) {
  const Pose2 T = map.T_map_grid().inverse() * T_map_sensor;
  const PointSet points = points_from_scan(scan);
  std::size_t num_near = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector2d at = T * Eigen::Vector2d(points.x_m[k], points.y_m[k]);
    num_near +=
        map.walls().slope_at(static_cast<float>(at.x()), static_cast<float>(at.y())).distance_m <
        0.12F;
  }
  return points.empty() ? 0.0 : static_cast<double>(num_near) / static_cast<double>(points.size());
}

void visit_other_half(const std::string& log_path,
                      double every_m,
                      bool maps_second,
                      const VisitPlace& visit) {
  const MappedHalf half = mapped_half(log_path, maps_second);
  const std::size_t middle = half.scans.size() / 2;
  const std::size_t begin = maps_second ? 0 : middle;
  const std::size_t end = maps_second ? middle : half.scans.size();
  // Those that overlap are every so many metres, too, whatever lies between them.
  Eigen::Vector2d last(1e9, 1e9);
  Eigen::Vector2d last_overlapping(1e9, 1e9);
  for (std::size_t i = begin; i < end; ++i) {
    if (!half.T_map_sensor[i]) continue;
    const Pose2& T = *half.T_map_sensor[i];
    const double overlap = overlap_with_map(*half.map, half.scans[i], T);
    Eigen::Vector2d& before = overlap < kMinOverlap ? last : last_overlapping;
    if ((T.translation() - before).norm() < every_m) continue;
    before = T.translation();
    visit({*half.map, half.scans[i], T, overlap});
  }
}

}  // namespace setsquare::experiments
