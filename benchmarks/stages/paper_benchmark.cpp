// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// Each step of bando2014, and one whole match from the ranges of both scans. The argument is the
// number of beams.
#include <benchmark/benchmark.h>

#include "benchmarks/stages/office_scan.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare::benchmarks {
namespace {

Scan reference_scan(const benchmark::State& state) {
  return office_scan(kReferencePose, static_cast<std::size_t>(state.range(0)));
}

Scan current_scan(const benchmark::State& state) {
  return office_scan(kCurrentPose, static_cast<std::size_t>(state.range(0)));
}

PointSet thinned_points(const benchmark::State& state) {
  return thin(points_from_scan(reference_scan(state)), PaperParams{}.min_spacing_m);
}

void points(benchmark::State& state) {
  const Scan scan = reference_scan(state);
  for (auto _ : state) benchmark::DoNotOptimize(points_from_scan(scan));
}
BENCHMARK(points)->Arg(180)->Arg(360)->Arg(1081);

void thinning(benchmark::State& state) {
  const PointSet dense = points_from_scan(reference_scan(state));
  const double min_spacing_m = PaperParams{}.min_spacing_m;
  for (auto _ : state) benchmark::DoNotOptimize(thin(dense, min_spacing_m));
}
BENCHMARK(thinning)->Arg(180)->Arg(360)->Arg(1081);

void paper_projected_profile(benchmark::State& state) {
  const PointSet thinned = thinned_points(state);
  for (auto _ : state) benchmark::DoNotOptimize(projected_profile(thinned, 0.3));
}
BENCHMARK(paper_projected_profile)->Arg(180)->Arg(360)->Arg(1081);

void paper_dominant_direction(benchmark::State& state) {
  const PointSet thinned = thinned_points(state);
  const DominantDirectionParams params = PaperParams{}.direction();
  for (auto _ : state) benchmark::DoNotOptimize(dominant_direction(thinned, params));
}
BENCHMARK(paper_dominant_direction)->Arg(180)->Arg(360)->Arg(1081);

void paper_relative_pose(benchmark::State& state) {
  const PreparedPaperScan reference = prepare_paper(reference_scan(state));
  const PreparedPaperScan current = prepare_paper(current_scan(state));
  const ShiftSearch search = PaperParams{}.shifts();
  for (auto _ : state) {
    benchmark::DoNotOptimize(relative_pose(reference.projected, current.projected, search));
  }
}
BENCHMARK(paper_relative_pose)->Arg(180)->Arg(360)->Arg(1081);

void paper_match(benchmark::State& state) {
  const Scan reference = reference_scan(state);
  const Scan current = current_scan(state);
  for (auto _ : state) benchmark::DoNotOptimize(match_paper(reference, current));
}
BENCHMARK(paper_match)->Arg(180)->Arg(360)->Arg(1081)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace setsquare::benchmarks
