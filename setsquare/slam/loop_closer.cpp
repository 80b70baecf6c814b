// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/loop_closer.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare {
namespace {

/// The submap about a keyframe, within its piece of track.
Submap submap_about(const KeyframeTrack& track,
                    std::span<const Pose2> T_map_sensor,
                    std::size_t middle,
                    std::size_t half_width) {
  std::size_t first = middle;
  while (first > 0 && middle - first < half_width &&
         track.pieces[first - 1] == track.pieces[middle]) {
    --first;
  }
  std::size_t end = middle + 1;
  while (end < track.size() && end - middle <= half_width &&
         track.pieces[end] == track.pieces[middle]) {
    ++end;
  }
  return make_submap(track.keyframes, T_map_sensor, first, middle, end);
}

/// What remains of the information where one direction, a unit vector, is open.
Eigen::Matrix3d without_direction(const Eigen::Matrix3d& information, const Eigen::Vector2d& open) {
  Eigen::Matrix3d kept = Eigen::Matrix3d::Identity();
  kept.topLeftCorner<2, 2>() -= open * open.transpose();
  return kept * information * kept;
}

/// Way from one keyframe to a later one, with what uncertain motion counts as way.
double way_between(const KeyframeTrack& track,
                   std::size_t from,
                   std::size_t to,
                   const ClosureCandidateParams& params) {
  double way_m = 0.0;
  for (std::size_t k = from + 1; k <= to; ++k) {
    const Pose2 moved =
        track.keyframes[k - 1]->T_odom_sensor.inverse() * track.keyframes[k]->T_odom_sensor;
    const double sigma_m = std::sqrt(track.motions[k].translation_m2.trace());
    way_m += std::hypot(moved.x_m, moved.y_m) + params.sigma_way * sigma_m;
  }
  return way_m;
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

void LoopCloser::add_stations(const KeyframeTrack& track) {
  const std::size_t spacing = params_.station_spacing;
  std::size_t next = stations_.empty() ? spacing : stations_.back() + spacing;
  for (; next + params_.submap_half_width < track.size(); next += spacing) {
    const std::size_t before = stations_.empty() ? next : stations_.back();
    candidates_.add_station(way_between(track, before, next, params_.candidates));
    stations_.push_back(next);
  }
}

void LoopCloser::extend(const KeyframeTrack& track,
                        std::span<const Pose2> T_map_sensor,
                        std::size_t num_threads) {
  const std::size_t first_new = stations_.size();
  add_stations(track);
  std::vector<Eigen::Vector2d> positions_m;
  for (const std::size_t keyframe : stations_) {
    positions_m.push_back(T_map_sensor[keyframe].translation());
  }
  const std::vector<ClosureCandidate> found = candidates_.find(first_new, positions_m);

  std::map<std::size_t, Submap> submaps;
  for (const ClosureCandidate& candidate : found) {
    submaps[candidate.reference];
    submaps[candidate.current];
  }
  std::vector<std::pair<const std::size_t, Submap>*> to_make;
  for (auto& entry : submaps) to_make.push_back(&entry);
  run_in_parallel(to_make.size(), num_threads, [&](std::size_t i) {
    to_make[i]->second =
        submap_about(track, T_map_sensor, stations_[to_make[i]->first], params_.submap_half_width);
  });

  std::vector<ComparedPlaces> compared(found.size());
  run_in_parallel(found.size(), num_threads, [&](std::size_t i) {
    const ClosureCandidate& candidate = found[i];
    ComparedPlaces& places = compared[i];
    places.from = stations_[candidate.reference];
    places.to = stations_[candidate.current];
    const Pose2& T_map_from = T_map_sensor[places.from];
    places.T_from_to = T_map_from.inverse() * T_map_sensor[places.to];
    const auto match = match_submaps(submaps.at(candidate.reference),
                                     submaps.at(candidate.current),
                                     {places.T_from_to, candidate.window_m},
                                     params_.match);
    if (!match) return;
    places.verdict = closure_verdict(*match, T_map_from.theta_rad, params_.verdict);
    places.T_from_to = match->best.T_reference_current;
    places.information = match->best.hessian / (params_.point_sigma_m * params_.point_sigma_m);
    if (places.verdict.reason == ClosureReason::kOneAxis) {
      places.information = without_direction(places.information, match->weak.direction);
    }
    places.score = match->best.score;
    places.contradiction = match->best.contradiction;
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (compared[i].verdict.reason != ClosureReason::kStandsAlone) continue;
    candidates_.link(found[i].reference, found[i].current);
  }
  compared_.insert(compared_.end(), compared.begin(), compared.end());
}

Constraint closure_constraint(const ComparedPlaces& places) {
  return {.from = places.from,
          .to = places.to,
          .T_from_to = places.T_from_to,
          .information = places.information,
          .kind = ConstraintKind::kLoopClosure,
          .weight = 1.0};
}

}  // namespace setsquare
