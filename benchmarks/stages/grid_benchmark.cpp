// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// The occupancy grid: the cells of a ray one by one, and the grid of scans along a path through the
// made-up office. The argument is the length in cells, or the number of beams.
#include <benchmark/benchmark.h>

#include <vector>

#include "benchmarks/stages/office_scan.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/grid/ray_traversal.hpp"

namespace setsquare::benchmarks {
namespace {

void ray_traversal(benchmark::State& state) {
  const std::int64_t length = state.range(0) * kSubcellsPerCell;
  std::int64_t slope = 0;
  for (auto _ : state) {
    slope = (slope + 977) % length;  // no two rays alike, as no branch predictor can learn
    RayTraversal ray({2048, 2048}, {2048 + length - slope, 2048 + slope});
    std::int64_t sum = 0;
    for (std::int32_t step = 0; step < ray.num_steps(); ++step, ray.advance()) {
      sum += ray.cell().row;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(ray_traversal)->Arg(100)->Arg(400);

void grid_of_200_scans(benchmark::State& state) {
  std::vector<Scan> scans;
  std::vector<PlacedScan> placed;
  for (int i = 0; i < 200; ++i) {
    const Pose2 T_map_sensor{2.0 + 0.03 * i, 3.0, 0.1 * i};
    scans.push_back(office_scan(T_map_sensor, static_cast<std::size_t>(state.range(0))));
    placed.push_back({nullptr, T_map_sensor});
  }
  for (std::size_t i = 0; i < scans.size(); ++i) placed[i].scan = &scans[i];
  for (auto _ : state) benchmark::DoNotOptimize(grid_from_scans(placed));
}
BENCHMARK(grid_of_200_scans)->Arg(180)->Arg(1081)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setsquare::benchmarks
