// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/loop_closer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare {
namespace {

/// Way from one keyframe to a later one, with what uncertain motion counts as way.
double way_between(const KeyframeTrack& track,
                   std::size_t from,
                   std::size_t to,
                   const ClosureCandidateParams& params) {
  double way_m = 0.0;
  for (std::size_t k = from + 1; k <= to; ++k) {
    const Pose2 moved =
        track.keyframes[k - 1]->T_odom_body.inverse() * track.keyframes[k]->T_odom_body;
    way_m += std::hypot(moved.x_m, moved.y_m) + params.slip_way * track.motions[k].slip_sigma_m;
  }
  return way_m;
}

/// Variance that open stretches add to the position of each keyframe, from the first on: over one
/// stretch sigmas add up.
std::vector<double> open_m2_of(const KeyframeTrack& track, std::size_t num_keyframes) {
  std::vector<double> open_m2(num_keyframes, 0.0);
  double before_m2 = 0.0;
  double stretch_m = 0.0;
  for (std::size_t k = 1; k < num_keyframes; ++k) {
    if (track.motions[k].open_stretch != track.motions[k - 1].open_stretch) {
      before_m2 += stretch_m * stretch_m;
      stretch_m = 0.0;
    }
    stretch_m += track.motions[k].open_sigma_m.trace();
    open_m2[k] = before_m2 + stretch_m * stretch_m;
  }
  return open_m2;
}

}  // namespace

void LoopCloserParams::validate() const {
  if (station_spacing < 1) throw ParameterError("station_spacing", "must be at least 1");
  if (!(point_sigma_m > 0.0)) throw ParameterError("point_sigma_m", "must be positive");
  candidates.validate();
  match.validate();
  verdict.validate();
}

LoopCloser::LoopCloser(const LoopCloserParams& params)
    : params_(params), candidates_(params.candidates) {
  params_.validate();
}

void LoopCloser::add_joints(std::span<const ComparedPlaces> joints) {
  for (const ComparedPlaces& joint : joints) joints_to_link_.emplace_back(joint.from, joint.to);
  compared_.insert(compared_.end(), joints.begin(), joints.end());
}

std::size_t LoopCloser::nearest_station(std::size_t keyframe) const {
  const auto after = std::lower_bound(stations_.begin(), stations_.end(), keyframe);
  return static_cast<std::size_t>(after - stations_.begin()) - (after == stations_.end() ? 1 : 0);
}

void LoopCloser::add_stations(const KeyframeTrack& track, std::size_t num_keyframes) {
  const std::size_t num_scanners = track.num_scanners();
  const std::size_t spacing = params_.station_spacing * num_scanners;
  const std::size_t half_width = params_.submap_half_width * num_scanners;
  std::size_t next = stations_.empty() ? spacing : stations_.back() + spacing;
  const std::vector<double> open_m2 = open_m2_of(track, num_keyframes);
  for (; next + half_width < num_keyframes; next += spacing) {
    const std::size_t before = stations_.empty() ? next : stations_.back();
    candidates_.add_station(
        way_between(track, before, next, params_.candidates), track.pieces[next], open_m2[next]);
    stations_.push_back(next);
  }
  std::erase_if(joints_to_link_, [&](const auto& joint) {
    if (stations_.empty() || std::max(joint.first, joint.second) > stations_.back()) return false;
    candidates_.link(nearest_station(joint.first), nearest_station(joint.second));
    return true;
  });
}

std::vector<ComparedPlaces> LoopCloser::compare(const KeyframeTrack& track,
                                                std::span<const Pose2> T_map_sensor,
                                                std::span<const ClosureCandidate> candidates,
                                                std::size_t num_threads) const {
  std::map<std::size_t, Submap> submaps;  // by station
  for (const ClosureCandidate& candidate : candidates) {
    submaps[candidate.reference];
    submaps[candidate.current];
  }
  std::vector<std::pair<const std::size_t, Submap>*> to_make;
  for (auto& entry : submaps) to_make.push_back(&entry);
  const std::size_t half_width = params_.submap_half_width * track.num_scanners();
  run_in_parallel(to_make.size(), num_threads, [&](std::size_t i) {
    const std::size_t middle = stations_[to_make[i]->first];
    to_make[i]->second = make_submap(track, T_map_sensor, middle, half_width);
  });

  std::vector<ComparedPlaces> compared(candidates.size());
  run_in_parallel(candidates.size(), num_threads, [&](std::size_t i) {
    const Submap& reference = submaps.at(candidates[i].reference);
    const Submap& current = submaps.at(candidates[i].current);
    const Pose2& T_map_from = T_map_sensor[reference.keyframe];
    const Pose2 expected = T_map_from.inverse() * T_map_sensor[current.keyframe];
    compared[i].from = reference.keyframe;
    compared[i].to = current.keyframe;
    compared[i].T_from_to = expected;
    const auto match =
        match_submaps(reference, current, {expected, candidates[i].window_m}, params_.match);
    if (!match) return;
    compared[i] = judged_places(reference.keyframe,
                                current.keyframe,
                                *match,
                                T_map_from.theta_rad,
                                params_.point_sigma_m,
                                params_.verdict);
  });
  return compared;
}

void LoopCloser::extend(const KeyframeTrack& track,
                        std::size_t num_keyframes,
                        std::span<const Pose2> T_map_sensor,
                        std::size_t num_threads) {
  assert(num_keyframes <= track.size());
  const std::size_t first_new = stations_.size();
  add_stations(track, num_keyframes);
  std::vector<Eigen::Vector2d> positions_m;
  for (const std::size_t keyframe : stations_) {
    positions_m.push_back(T_map_sensor[keyframe].translation());
  }
  const std::vector<ClosureCandidate> candidates = candidates_.find(first_new, positions_m);
  const std::vector<ComparedPlaces> compared =
      compare(track, T_map_sensor, candidates, num_threads);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (compared[i].verdict.reason != ClosureReason::kStandsAlone) continue;
    candidates_.link(candidates[i].reference, candidates[i].current);
  }
  compared_.insert(compared_.end(), compared.begin(), compared.end());
}

void LoopCloser::keep_only(std::span<const std::size_t> kept, const KeyframeTrack& track) {
  const auto index_of = [&](std::size_t& keyframe) {
    const auto found = std::ranges::lower_bound(kept, keyframe);
    if (found == kept.end() || *found != keyframe) return false;
    keyframe = static_cast<std::size_t>(found - kept.begin());
    return true;
  };
  std::erase_if(stations_, [&](std::size_t& station) { return !index_of(station); });
  std::erase_if(compared_, [&](ComparedPlaces& places) {
    return !index_of(places.from) || !index_of(places.to);
  });
  std::erase_if(joints_to_link_,
                [&](auto& joint) { return !index_of(joint.first) || !index_of(joint.second); });
  candidates_ = ClosureCandidates(params_.candidates);
  const std::vector<double> open_m2 = open_m2_of(track, track.size());
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const std::size_t station = stations_[i];
    const std::size_t before = i == 0 ? station : stations_[i - 1];
    candidates_.add_station(way_between(track, before, station, params_.candidates),
                            track.pieces[station],
                            open_m2[station]);
  }
  for (const ComparedPlaces& places : compared_) {
    if (places.verdict.reason != ClosureReason::kStandsAlone) continue;
    candidates_.link(nearest_station(places.from), nearest_station(places.to));
  }
}

}  // namespace setsquare
