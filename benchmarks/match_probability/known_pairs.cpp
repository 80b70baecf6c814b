// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/match_probability/known_pairs.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

#include "experiments/simulated_run.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "setsquare/sim/pairs/study_sampling.hpp"
#include "tests/support/rooms.hpp"

namespace setsquare::experiments {
namespace {

std::vector<PreparedScan> prepared_scans(const SimulatedRun& run) {
  std::vector<PreparedScan> prepared;
  for (const SimulatedScan& scan : run.scans) prepared.push_back(prepare(scan.scan));
  return prepared;
}

void visit_pairs_of(const SimulatedRun& run,
                    const ScannerModel& scanner,
                    double max_distance_m,
                    const VisitPair& visit) {
  const std::vector<PreparedScan> prepared = prepared_scans(run);
  for (std::size_t i = 0; i < run.scans.size(); ++i) {
    for (std::size_t j = i + 1; j < run.scans.size(); ++j) {
      const Pose2 truth = true_relative_pose(run.scans[i], run.scans[j]);
      if (truth.translation().norm() > max_distance_m) continue;
      const PairGeometry geometry =
          pair_geometry(run.caster, scanner, run.scans[i].T_map_base, run.scans[j].T_map_base);
      visit({prepared[i], prepared[j], truth, geometry.overlap, geometry.is_determined()});
    }
  }
}

using Scans = std::map<Timestamp, Scan>;
constexpr std::array kLogs = {"intel", "aces", "fr079"};

Scans read_scans(const std::string& data_folder, const std::string& name) {
  Scans scans;
  const auto reader = open_log(data_folder + "/" + name + "/" + name + ".clf");
  while (const LogRecord* record = reader->next()) scans[record->stamp] = record->scan;
  return scans;
}

/// Relations round the log's stamps.
const Scan* scan_at(const Scans& scans, Timestamp stamp) {
  constexpr std::int64_t kRounding_ns = 20'000;
  const auto near = scans.lower_bound(Timestamp{stamp.ns - kRounding_ns});
  const bool is_there = near != scans.end() && near->first.ns <= stamp.ns + kRounding_ns;
  return is_there ? &near->second : nullptr;
}

}  // namespace

void visit_buildings(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit) {
  constexpr double kMaxDistance_m = 5.0;
  RunParams params;
  params.scanner = scanner;
  for (const BuildingClass building_class : kAllBuildingClasses) {
    for (std::uint64_t k = 0; k < seeds.count; ++k) {
      const SimulatedRun run = simulate_study_run(building_class, seeds.first + k, params);
      visit_pairs_of(run, scanner, kMaxDistance_m, visit);
    }
  }
}

void visit_strangers(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit) {
  RunParams params;
  params.scanner = scanner;
  const auto& classes = kAllBuildingClasses;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
      const auto a = prepared_scans(simulate_study_run(classes[c], seed, params));
      const auto b = prepared_scans(
          simulate_study_run(classes[(c + 1) % classes.size()], seed + 1000, params));
      for (std::size_t i = 0; i < a.size(); i += 4) {
        for (std::size_t j = 0; j < b.size(); j += 2) visit({a[i], b[j], std::nullopt});
      }
    }
  }
}

void visit_world(SmallWorld world, Seeds seeds, const VisitPair& visit) {
  constexpr std::size_t kNumScans = 9;
  for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
    const Building building = make_small_world(world, seed);
    const RobotPath path(building.route_m);
    std::vector<double> times_s = sample_times(path, 0.5, rad_from_deg(30.0));
    times_s.resize(std::min(times_s.size(), kNumScans));
    const SimulatedRun run = simulate_run(building, path, times_s, {}, sub_seed(seed, 700));
    visit_pairs_of(run, utm_30lx(), 1e9, visit);
  }
}

void visit_rooms(std::uint64_t seed, std::size_t num_pairs, const VisitPair& visit) {
  std::mt19937_64 generator(seed);
  const testing::Fan fan{361, rad_from_deg(-90), rad_from_deg(0.5)};
  for (std::size_t k = 0; k < num_pairs; ++k) {
    const auto room = testing::furnished_room(generator);
    const Pose2 a = testing::free_pose(room, generator);
    const Pose2 b = testing::free_pose(room, generator);
    const auto scan = [&](const Pose2& T) {
      const double noise_m = std::uniform_real_distribution<double>(0.01, 0.02)(generator);
      return testing::scan_of_walls(room.walls, T, fan, noise_m, generator(), 0.1);
    };
    const Scan reference = scan(a);
    const Scan current = scan(b);
    const Pose2 truth = a.inverse() * b;
    const double overlap = std::min(testing::true_overlap(reference, current, truth),
                                    testing::true_overlap(current, reference, truth.inverse()));
    visit({prepare(reference), prepare(current), truth, overlap, true});
  }
}

void visit_corridor_ends(std::uint64_t seed, std::size_t num_pairs, const VisitPair& visit) {
  std::mt19937_64 generator(seed);
  const testing::Fan fan{181, rad_from_deg(-90), rad_from_deg(1.0)};
  for (std::size_t k = 0; k < num_pairs; ++k) {
    const double noise_m = std::uniform_real_distribution<double>(0.01, 0.02)(generator);
    const auto look = [&](const std::vector<testing::Wall>& walls, const Pose2& T) {
      return prepare(testing::scan_of_walls(walls, T, fan, noise_m, generator()));
    };
    const auto one = testing::end_of_a_corridor(generator);
    const auto other = testing::end_of_a_corridor(generator);
    const Pose2 a = testing::pose_before_the_end(generator);
    const Pose2 b = testing::pose_before_the_end(generator);
    const PreparedScan reference = look(one, a);
    visit({reference, look(other, b), std::nullopt});
    visit({reference, look(one, b), a.inverse() * b, 0.0, true});
  }
}

void visit_many_strangers(const ScannerModel& scanner, Seeds seeds, const VisitPair& visit) {
  constexpr std::uint64_t kOthers = 50'000;  // Seeds of the buildings that a seed is compared with.
  RunParams params;
  params.scanner = scanner;
  for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
    std::vector<std::vector<PreparedScan>> others;
    for (const BuildingClass of : kAllBuildingClasses) {
      others.push_back(prepared_scans(simulate_study_run(of, seed + kOthers, params)));
    }
    for (const BuildingClass of : kAllBuildingClasses) {
      const auto scans = prepared_scans(simulate_study_run(of, seed, params));
      for (const auto& other : others) {
        for (std::size_t i = seed % 2; i < scans.size(); i += 2) {
          for (std::size_t j = (i + seed) % 4; j < other.size(); j += 4) {
            visit({scans[i], other[j], std::nullopt});
          }
        }
      }
    }
  }
}

void visit_real_loops(const std::string& data_folder, const VisitPair& visit) {
  for (const std::string name : kLogs) {
    const Scans scans = read_scans(data_folder, name);
    const std::string base = data_folder + "/" + name + "/" + name + ".loop.";
    const auto relations = read_relations(base + "relations");
    const auto overlaps = read_overlaps(base + "overlap");
    for (std::size_t i = 0; i < relations.size(); ++i) {
      const Scan* a = scan_at(scans, relations[i].reference_stamp);
      const Scan* b = scan_at(scans, relations[i].current_stamp);
      if (a == nullptr || b == nullptr) continue;
      const Pose2 truth =
          a->T_base_sensor.inverse() * relations[i].T_reference_current * b->T_base_sensor;
      visit({prepare(*a), prepare(*b), truth, overlaps.at(i).overlap, true});
    }
  }
}

void visit_real_strangers(const std::string& data_folder,
                          std::size_t num_pairs,
                          const VisitPair& visit) {
  std::vector<Scans> logs;
  for (const std::string name : kLogs) logs.push_back(read_scans(data_folder, name));
  std::mt19937_64 generator(1);
  const auto any = [&](const Scans& scans) {
    std::uniform_int_distribution<std::size_t> place(0, scans.size() - 1);
    return std::next(scans.begin(), static_cast<std::ptrdiff_t>(place(generator)))->second;
  };
  for (std::size_t k = 0; k < logs.size(); ++k) {
    for (std::size_t i = 0; i < num_pairs / logs.size(); ++i) {
      const Scan reference = any(logs[k]);
      const Scan current = any(logs[(k + 1) % logs.size()]);
      visit({prepare(reference), prepare(current), std::nullopt});
    }
  }
}

ScannerModel half_turn_scanner(double noise_m) {
  ScannerModel scanner = with_num_beams(with_field_of_view(utm_30lx(), kPi), 181);
  scanner.near_noise_m = scanner.far_noise_m = noise_m;
  scanner.noise_share = 1.0;
  return scanner;
}

}  // namespace setsquare::experiments
