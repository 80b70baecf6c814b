// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/known_keyframes.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/damped_step.hpp"
#include "setsquare/core/is_beyond.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/mapping/loops/candidates.hpp"
#include "setsquare/tracking/open_direction.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {
namespace {

/// From this field of view on a scan shows the same whichever way its sensor looks.
constexpr double kAllAround_rad = rad_from_deg(350.0);
/// Keeps the steps onto the walls short where no point binds anything.
constexpr double kStepDamping = 1e-2;

/// The track, its keyframes' places and the way to each. From one session to the next it is longer
/// than that between two visits.
struct PlacedTrack {
  PlacedTrack(const KeyframeTrack& of, std::span<const Pose2> poses, const ForgettingParams& params)
      : track(of), T_map_sensor(poses), hash(params.near_m), way_m(ways_m_of(of)) {
    for (std::size_t k = 0; k < track.size(); ++k) hash.add(T_map_sensor[k].translation(), k);
    for (const std::size_t begin : track.session_begins) {
      for (std::size_t k = begin; k < track.size(); ++k) way_m[k] += 2.0 * params.visit_way_m;
    }
  }

  const KeyframeTrack& track;
  std::span<const Pose2> T_map_sensor;
  PositionHash hash;
  std::vector<double> way_m;
};

/// Of each visit that covers keyframe k, in their order, the keyframe nearest to it. `examined`:
/// the keyframes before it.
std::vector<std::size_t> visits_about(const PlacedTrack& placed,
                                      std::size_t k,
                                      std::span<const std::optional<KnownPlace>> examined,
                                      const ForgettingParams& params) {
  const KeyframeTrack& track = placed.track;
  const Scan& scan = *track.keyframes[k]->scan;
  const bool is_all_around = scan.field_of_view_rad() >= kAllAround_rad;
  const auto distance_m = [&](std::size_t other) {
    return (placed.T_map_sensor[other].translation() - placed.T_map_sensor[k].translation()).norm();
  };
  std::vector<std::size_t> near;
  placed.hash.visit(placed.T_map_sensor[k].translation(), params.near_m, [&](std::size_t other) {
    if (other >= examined.size() || examined[other]) return;
    if (placed.way_m[k] - placed.way_m[other] < params.visit_way_m) return;
    if (track.pieces[other] != track.pieces[k] || distance_m(other) > params.near_m) return;
    if (track.keyframes[other]->scan->scanner != scan.scanner) return;
    const double turned_rad =
        wrap_to_pi(placed.T_map_sensor[other].theta_rad - placed.T_map_sensor[k].theta_rad);
    if (is_all_around || std::abs(turned_rad) <= params.near_rad) near.push_back(other);
  });
  std::ranges::sort(near);
  std::vector<std::size_t> visits;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (i == 0 || placed.way_m[near[i]] - placed.way_m[near[i - 1]] > params.visit_way_m) {
      visits.push_back(near[i]);
    } else if (distance_m(near[i]) < distance_m(visits.back())) {
      visits.back() = near[i];
    }
  }
  return visits;
}

/// One step of the pose onto the walls, but not along a direction that they leave open.
Pose2 onto_walls(const SubmapAlignment& found, const Pose2& T, const ForgettingParams& params) {
  const OpenDirection open = open_direction(found.hessian.topLeftCorner<2, 2>());
  const Eigen::Matrix3d kept =
      keeping_open_share(open, open.effective_points < params.min_effective_points ? 0.0 : 1.0);
  const NormalEquations<3> bound{kept * found.hessian * kept, kept * found.gradient};
  return stepped(T, damped_step(bound, kStepDamping));
}

/// Where keyframe k stands if all that it sees is what the visits saw.
std::optional<KnownPlace> place_among(const PlacedTrack& placed,
                                      std::size_t k,
                                      std::span<const std::size_t> visits,
                                      const ForgettingParams& params) {
  constexpr int kNumSteps = 3;
  const KeyframeTrack& track = placed.track;
  const std::size_t reference = visits.back();
  const Pose2 T_reference_map = placed.T_map_sensor[reference].inverse();
  std::vector<PlacedImage> submap;
  for (const std::size_t visit : visits) {
    submap.push_back(
        {&track.keyframes[visit]->image(), T_reference_map * placed.T_map_sensor[visit]});
  }
  const SurfacePoints& points = track.keyframes[k]->points();
  const SurfaceSamples samples = sample_surface(points, points.size());
  const Pose2 T_by_graph = T_reference_map * placed.T_map_sensor[k];
  Pose2 T = T_by_graph;
  PointMarks marks;
  SubmapAlignment found = align_with_submap(submap, samples, T, params.scale, marks);
  for (int step = 0; step < kNumSteps; ++step) {
    T = onto_walls(found, T, params);
    found = align_with_submap(submap, samples, T, params.scale, marks);
  }
  if (is_beyond(T_by_graph.inverse() * T, params.max_off_m, params.max_off_rad) ||
      found.num_explained < params.min_explained * static_cast<double>(points.size()) ||
      found.num_contradicted > params.max_contradicted * found.num_compared) {
    return std::nullopt;
  }
  return KnownPlace{track.keyframes[reference]->scan_index, T};
}

}  // namespace

void KnownKeyframes::examine(const KeyframeTrack& track,
                             std::size_t num_keyframes,
                             std::span<const Pose2> T_map_sensor,
                             std::size_t num_threads) {
  const std::size_t first = places_.size();
  const PlacedTrack placed(track, T_map_sensor, params_);
  places_.resize(num_keyframes);
  const auto examined = std::span(places_).first(first);
  run_in_parallel(num_keyframes - first, num_threads, [&](std::size_t i) {
    const std::size_t k = first + i;
    const std::vector<std::size_t> visits = visits_about(placed, k, examined, params_);
    if (visits.size() < params_.min_visits) return;
    const auto last = std::span(visits).last(params_.min_visits);
    places_[k] = place_among(placed, k, last, params_);
  });
}

void KnownKeyframes::keep_only(std::span<const std::size_t> kept) {
  for (std::size_t i = 0; i < kept.size(); ++i) places_[i] = places_[kept[i]];
  places_.resize(kept.size());
}

void KnownKeyframes::renumber(std::size_t end, std::size_t num_gone) {
  for (std::optional<KnownPlace>& place : places_) {
    if (place && place->reference_scan >= end) place->reference_scan -= num_gone;
  }
}

std::vector<Pose2> poses_of_known(const KeyframeTrack& track,
                                  std::span<const std::optional<KnownPlace>> places,
                                  std::span<const Pose2> T_map_sensor) {
  std::vector<Pose2> poses(T_map_sensor.begin(), T_map_sensor.end());
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!places[k]) continue;
    poses[k] = T_map_sensor[keyframe_of_scan(track, places[k]->reference_scan)] *
               places[k]->T_reference_this;
  }
  return poses;
}

}  // namespace setsquare
