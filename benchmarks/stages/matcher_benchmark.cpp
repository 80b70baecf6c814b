// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// Each stage of the default matcher, a whole match from the ranges of both scans, and a match of
// scans prepared before. The argument is the number of beams.
#include <benchmark/benchmark.h>

#include <array>

#include "benchmarks/stages/office_scan.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare::benchmarks {
namespace {

Scan reference_scan(const benchmark::State& state) {
  return office_scan(kReferencePose, static_cast<std::size_t>(state.range(0)));
}

Scan current_scan(const benchmark::State& state) {
  return office_scan(kCurrentPose, static_cast<std::size_t>(state.range(0)));
}

const Pose2 kTruth = kReferencePose.inverse() * kCurrentPose;

void surface_points(benchmark::State& state) {
  const Scan scan = reference_scan(state);
  for (auto _ : state) benchmark::DoNotOptimize(surface_points_from_scan(scan));
}
BENCHMARK(surface_points)->Arg(180)->Arg(360)->Arg(1081);

void surface_image(benchmark::State& state) {
  const Scan scan = reference_scan(state);
  const SurfacePoints points = surface_points_from_scan(scan);
  for (auto _ : state) benchmark::DoNotOptimize(SurfaceImage(scan, points));
}
BENCHMARK(surface_image)->Arg(180)->Arg(360)->Arg(1081);

void preparation(benchmark::State& state) {
  const Scan scan = reference_scan(state);
  for (auto _ : state) benchmark::DoNotOptimize(prepare(scan));
}
BENCHMARK(preparation)->Arg(180)->Arg(360)->Arg(1081)->Unit(benchmark::kMicrosecond);

void correlation_grid(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  for (auto _ : state) {
    benchmark::DoNotOptimize(CorrelationGrid(reference.points(), reference.image()));
  }
}
BENCHMARK(correlation_grid)->Arg(180)->Arg(360)->Arg(1081)->Unit(benchmark::kMicrosecond);

void rotation_proposals(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  const PreparedScan current = prepare(current_scan(state));
  const std::size_t num_rotations = MatchParams{}.quick.num_rotations;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        propose_rotations(reference.histogram, current.histogram, num_rotations));
  }
}
BENCHMARK(rotation_proposals)->Arg(180)->Arg(1081)->Unit(benchmark::kMicrosecond);

/// Every translation of the window at one rotation.
void translation_proposals(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  const PreparedScan current = prepare(current_scan(state));
  const CorrelationGrid grid(reference.points(), reference.image());
  std::vector<TranslationProposal> proposals;
  for (auto _ : state) {
    proposals.clear();
    grid.propose_translations(current.coarse, {0.0, 0.0, kTruth.theta_rad}, 60, proposals);
    benchmark::DoNotOptimize(proposals.data());
  }
}
BENCHMARK(translation_proposals)->Arg(180)->Arg(1081)->Unit(benchmark::kMicrosecond);

void verification(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  const PreparedScan current = prepare(current_scan(state));
  const double tolerance_m = MatchParams{}.score.tolerance_m;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        align(reference.fine_alignment(), current.fine_alignment(), kTruth, tolerance_m));
  }
}
BENCHMARK(verification)->Arg(180)->Arg(360)->Arg(1081);

void refinement(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  const PreparedScan current = prepare(current_scan(state));
  const Pose2 T_start = kTruth * Pose2{0.08, -0.05, 0.02};
  constexpr std::array kTolerances_m = {0.3, 0.2, 0.1};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        refine(reference.fine_alignment(), current.fine_alignment(), T_start, kTolerances_m));
  }
}
BENCHMARK(refinement)->Arg(180)->Arg(360)->Arg(1081);

void prepared_match(benchmark::State& state) {
  const PreparedScan reference = prepare(reference_scan(state));
  const PreparedScan current = prepare(current_scan(state));
  for (auto _ : state) benchmark::DoNotOptimize(match(reference, current));
}
BENCHMARK(prepared_match)->Arg(180)->Arg(360)->Arg(1081)->Unit(benchmark::kMicrosecond);

void whole_match(benchmark::State& state) {
  const Scan reference = reference_scan(state);
  const Scan current = current_scan(state);
  for (auto _ : state) benchmark::DoNotOptimize(match(reference, current));
}
BENCHMARK(whole_match)->Arg(180)->Arg(360)->Arg(1081)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace setsquare::benchmarks
