// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/seen_through.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "setsquare/core/parallel.hpp"
#include "setsquare/mapping/loops/candidates.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {
namespace {

/// Scans from farther apart hardly see each other's walls whole.
constexpr double kNear_m = 2.0;
/// Nearer along the track is the same pass.
constexpr double kSamePass_m = 8.0;
/// Scans of other passes that a keyframe is compared with.
constexpr std::size_t kMaxNumPasses = 4;
constexpr std::size_t kNumSamples = 120;
/// A pair of scans with fewer points that can be judged tells nothing ...
constexpr double kMinJudged = 30.0;
/// ... and one with a larger share contradicted is of two places.
constexpr double kMaxContradicted = 0.35;
/// Crossed walls: so many keyframes, ...
constexpr std::size_t kMinCrossed = 5;
/// ... from each to the next no more, ...
constexpr double kMaxBetween_m = 1.5;
/// ... and this share of those in between.
constexpr double kMinCrossedShare = 0.5;
constexpr AlignmentScale kScale{.gate_m = 0.30, .scale_m = 0.15};

/// The nearest earlier keyframe of each pass near by.
std::vector<std::size_t> other_passes(std::size_t keyframe,
                                      std::span<const Pose2> T_map_sensor,
                                      std::span<const double> way_m,
                                      const PositionHash& places) {
  const Eigen::Vector2d here = T_map_sensor[keyframe].translation();
  std::vector<std::pair<double, std::size_t>> near;
  places.visit(here, kNear_m, [&](std::size_t other) {
    const double apart_m = (T_map_sensor[other].translation() - here).norm();
    if (other < keyframe && apart_m < kNear_m) near.emplace_back(apart_m, other);
  });
  std::sort(near.begin(), near.end());
  std::vector<std::size_t> passes = {keyframe};
  for (const auto& [apart_m, other] : near) {
    const bool is_new = std::all_of(passes.begin(), passes.end(), [&](std::size_t pass) {
      return std::abs(way_m[pass] - way_m[other]) > kSamePass_m;
    });
    if (is_new) passes.push_back(other);
    if (passes.size() > kMaxNumPasses) break;
  }
  passes.erase(passes.begin());
  return passes;
}

SurfaceSamples samples_of(const SurfacePoints& all) {
  return sample_surface(all, direction_balanced_weights(all, angle_histogram(all)), kNumSamples);
}

bool is_seen_through(const SurfaceSamples& points,
                     const SurfaceImage& by,
                     const Pose2& T_by_points,
                     PointMarks& marks) {
  const PlacedImage image{&by, {}};
  const SubmapAlignment fit = align_with_submap({&image, 1}, points, T_by_points, kScale, marks);
  const double num_judged = fit.num_explained + fit.num_contradicted;
  return num_judged >= kMinJudged && fit.num_contradicted > kMaxContradicted * num_judged;
}

}  // namespace

std::vector<std::optional<std::size_t>> seen_through(std::span<const ScanSurfacesPtr> surfaces,
                                                     std::span<const Pose2> T_map_sensor,
                                                     std::span<const double> way_m,
                                                     std::size_t num_threads) {
  assert(T_map_sensor.size() == surfaces.size() && way_m.size() == surfaces.size());
  PositionHash places(kNear_m);
  for (std::size_t k = 0; k < surfaces.size(); ++k) places.add(T_map_sensor[k].translation(), k);
  std::vector<std::optional<std::size_t>> seen_by(surfaces.size());
  run_in_parallel(surfaces.size(), num_threads, [&](std::size_t k) {
    const SurfacePoints& all = surfaces[k]->points;
    const auto passes = other_passes(k, T_map_sensor, way_m, places);
    if (passes.empty() || all.size() == 0) return;
    const SurfaceSamples points = samples_of(all);
    PointMarks marks;
    for (const std::size_t by : passes) {
      const Pose2 T_by_points = T_map_sensor[by].inverse() * T_map_sensor[k];
      if (!is_seen_through(points, surfaces[by]->image, T_by_points, marks)) continue;
      seen_by[k] = by;
      return;
    }
  });
  return seen_by;
}

std::vector<CrossedWalls> crossed_walls(std::span<const std::optional<std::size_t>> seen_through_by,
                                        std::span<const double> way_m,
                                        double min_crossed_m) {
  assert(way_m.size() == seen_through_by.size());
  std::vector<CrossedWalls> runs;
  for (std::size_t k = 0; k < seen_through_by.size(); ++k) {
    if (!seen_through_by[k]) continue;
    const std::size_t by = *seen_through_by[k];
    if (runs.empty() || way_m[k] - way_m[runs.back().last] > kMaxBetween_m) {
      runs.push_back({.first = k, .last = k, .num = 0, .first_by = by, .last_by = by});
    }
    CrossedWalls& run = runs.back();
    run.last = k;
    ++run.num;
    run.first_by = std::min(run.first_by, by);
    run.last_by = std::max(run.last_by, by);
  }
  std::erase_if(runs, [&](const CrossedWalls& run) {
    const auto num_between = static_cast<double>(run.last - run.first + 1);
    return run.num < kMinCrossed || way_m[run.last] - way_m[run.first] < min_crossed_m ||
           static_cast<double>(run.num) < kMinCrossedShare * num_between;
  });
  return runs;
}

std::size_t num_seen_through(const KeyframeTrack& track,
                             std::span<const Pose2> T_map_sensor,
                             std::size_t num_threads) {
  const auto seen_by =
      seen_through(surfaces_of(track), T_map_sensor, ways_m_of(track), num_threads);
  return static_cast<std::size_t>(
      std::ranges::count_if(seen_by, [](const auto& by) { return by.has_value(); }));
}

bool see_through_each_other(const Keyframe& a, const Keyframe& b, const Pose2& T_a_b) {
  if (a.points().size() == 0 || b.points().size() == 0) return false;
  PointMarks marks_a;
  PointMarks marks_b;
  return is_seen_through(samples_of(b.points()), a.image(), T_a_b, marks_a) ||
         is_seen_through(samples_of(a.points()), b.image(), T_a_b.inverse(), marks_b);
}

}  // namespace setsquare
