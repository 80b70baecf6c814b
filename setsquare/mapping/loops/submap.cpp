// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/submap.hpp"

#include <cassert>
#include <cmath>

#include "setsquare/surfaces/angle_histogram.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kNumRoughSamples = 120;
constexpr std::size_t kNumFineSamples = 300;

/// Appends a keyframe's points, moved into the submap's frame.
void append(const SurfacePoints& points, const Pose2& T_submap_sensor, SurfacePoints& all) {
  const auto c = static_cast<float>(std::cos(T_submap_sensor.theta_rad));
  const auto s = static_cast<float>(std::sin(T_submap_sensor.theta_rad));
  const auto tx_m = static_cast<float>(T_submap_sensor.x_m);
  const auto ty_m = static_cast<float>(T_submap_sensor.y_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x_m = c * points.x_m[i] - s * points.y_m[i] + tx_m;
    const float y_m = s * points.x_m[i] + c * points.y_m[i] + ty_m;
    all.x_m.push_back(x_m);
    all.y_m.push_back(y_m);
    all.normal_x.push_back(c * points.normal_x[i] - s * points.normal_y[i]);
    all.normal_y.push_back(s * points.normal_x[i] + c * points.normal_y[i]);
    all.weight_m.push_back(points.weight_m[i]);
    all.range_m.push_back(std::hypot(x_m, y_m));
    all.beam.push_back(static_cast<std::int32_t>(all.beam.size()));
    all.joined.push_back(i + 1 < points.size() ? points.joined[i] : std::uint8_t{0});
  }
}

/// Whether the relative pose of two keyframes is known. In a bare corridor they may
/// have slipped, and a submap of both would be too short or too long.
bool is_rigid(const KeyframeTrack& track, std::size_t a, std::size_t b, double slip_sigma_m) {
  constexpr double kMaxSlip_m = 0.1;
  return track.stretches[a] == track.stretches[b] && slip_sigma_m <= kMaxSlip_m;
}

SurfacePoints points_of(const Submap& submap) {
  SurfacePoints all;
  for (std::size_t k = 0; k < submap.members.size(); ++k) {
    append(submap.members[k]->points(), submap.images[k].T_submap_sensor, all);
  }
  return all;
}

}  // namespace

Submap make_submap(const KeyframeTrack& track,
                   std::span<const Pose2> T_map_sensor,
                   std::size_t middle,
                   std::size_t half_width) {
  assert(middle < track.size() && T_map_sensor.size() == track.size());
  std::size_t first = middle;
  for (double slip_m = 0.0; first > 0 && middle - first < half_width; --first) {
    slip_m += track.motions[first].slip_sigma_m;
    if (!is_rigid(track, first - 1, middle, slip_m)) break;
  }
  std::size_t end = middle + 1;
  for (double slip_m = 0.0; end < track.size() && end - middle <= half_width; ++end) {
    slip_m += track.motions[end].slip_sigma_m;
    if (!is_rigid(track, end, middle, slip_m)) break;
  }

  Submap submap;
  submap.keyframe = middle;
  submap.middle_member = middle - first;
  const Pose2 T_submap_map = T_map_sensor[middle].inverse();
  for (std::size_t k = first; k < end; ++k) {
    const Keyframe& keyframe = *track.keyframes[k];
    submap.members.push_back(&keyframe);
    submap.images.push_back({&keyframe.image(), T_submap_map * T_map_sensor[k]});
  }
  const SurfacePoints all = points_of(submap);
  const auto weights = direction_balanced_weights(all, angle_histogram(all));
  submap.coarse = sample_surface(all, weights, CorrelationGrid::kMaxSamples);
  submap.rough = sample_surface(all, weights, kNumRoughSamples);
  submap.fine = sample_surface(all, weights, kNumFineSamples);
  return submap;
}

CorrelationGrid correlation_grid(const Submap& submap) {
  return CorrelationGrid(points_of(submap), submap.members[submap.middle_member]->image());
}

}  // namespace setsquare
