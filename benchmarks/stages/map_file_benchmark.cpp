// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps to bytes and back: as many scans as intel.clf has, every second one kept, its ranges in
// whole centimetres. The argument is the number of beams. Bytes are those of the map file.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "benchmarks/stages/office_scan.hpp"
#include "setsquare/io/map_file/map_file.hpp"

namespace setsquare::benchmarks {
namespace {

constexpr std::size_t kNumMapped = 13631;

Map map_of_office(std::size_t num_beams) {
  Map map;
  for (std::size_t i = 0; i < kNumMapped; ++i) {
    const auto step = static_cast<double>(i);
    MappedScan mapped;
    mapped.stamp = {static_cast<std::int64_t>(i) * 100'000'000};
    mapped.T_map_sensor = {4.0 + std::sin(0.01 * step), 3.0 + std::cos(0.013 * step), 0.02 * step};
    mapped.T_map_base = mapped.T_map_sensor;
    mapped.score = std::abs(std::sin(step));
    mapped.position_sigma_m = 0.01 * mapped.score;
    mapped.position_covariance_m2 = 1e-4 * mapped.score * Eigen::Matrix2d::Identity();
    map.scans.push_back(mapped);
    if (i % 2 == 1) continue;
    const auto scan = std::make_shared<Scan>(office_scan(mapped.T_map_sensor, num_beams));
    for (double& range_m : scan->ranges_m) range_m = std::round(100.0 * range_m) / 100.0;
    map.kept_scans.push_back({i, scan});
  }
  return map;
}

void map_to_bytes(benchmark::State& state) {
  const Map map = map_of_office(static_cast<std::size_t>(state.range(0)));
  std::size_t num_bytes = 0;
  for (auto _ : state) num_bytes += map_file_bytes(map).size();
  state.SetBytesProcessed(static_cast<std::int64_t>(num_bytes));
}
BENCHMARK(map_to_bytes)->Arg(180)->Arg(1081)->Unit(benchmark::kMillisecond);

void map_from_its_bytes(benchmark::State& state) {
  const std::string bytes = map_file_bytes(map_of_office(static_cast<std::size_t>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(map_from_bytes(bytes, "").map.scans.data());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(map_from_its_bytes)->Arg(180)->Arg(1081)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setsquare::benchmarks
