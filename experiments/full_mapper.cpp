// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/full_mapper.hpp"

#include <algorithm>
#include <vector>

#include "setsquare/eval/absolute_trajectory_error.hpp"
#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/sim/sensing/odometry_model.hpp"

namespace setsquare::experiments {
namespace {

/// More than this in the final graph bends the map.
constexpr double kHeavyWeight = 0.3;

std::vector<PosePair> pairs_of(const Map& track, std::span<const Pose2> truth) {
  std::vector<PosePair> pairs;
  pairs.reserve(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    pairs.push_back({track.scans[k].stamp, track.scans[k].T_map_base, truth[k]});
  }
  return pairs;
}

ClosureCounts count_closures(const Map& track, std::span<const Pose2> truth) {
  ClosureCounts counts;
  for (const MappedClosure& mapped : track.closures) {
    if (!mapped.closure.is_accepted) continue;
    const Pose2 T_i_j = truth[mapped.scan_i].inverse() * truth[mapped.scan_j];
    const ClosureError error =
        closure_error(mapped.closure, T_i_j, track.scans[mapped.scan_i].T_map_base.theta_rad);
    const bool is_wrong = !error.is_within(ClosureLimits{});
    ++counts.num_accepted;
    counts.num_wrong += is_wrong;
    counts.num_wrong_heavy += is_wrong && mapped.closure.weight > kHeavyWeight;
  }
  return counts;
}

}  // namespace

Map track_by_mapper(std::span<const SimulatedScan> scans,
                    std::optional<std::uint64_t> odometry_seed) {
  std::optional<OdometryModel> wheels;
  if (odometry_seed) wheels.emplace(OdometryParams{}, *odometry_seed);
  Mapper mapper;
  for (const SimulatedScan& simulated : scans) {
    std::optional<Pose2> T_wheels_base;
    if (wheels) T_wheels_base = wheels->move_to(simulated.T_map_base);
    static_cast<void>(mapper.add(simulated.scan, T_wheels_base));
  }
  return mapper.finish();
}

ClosureCounts& ClosureCounts::operator+=(const ClosureCounts& other) {
  num_accepted += other.num_accepted;
  num_wrong += other.num_wrong;
  num_wrong_heavy += other.num_wrong_heavy;
  return *this;
}

MapErrors map_errors(const Map& track, std::span<const Pose2> truth) {
  const std::vector<PosePair> pairs = pairs_of(track, truth);
  const auto first = absolute_trajectory_error(pairs, TrajectoryAlignment::kFirst);
  const auto best = absolute_trajectory_error(pairs, TrajectoryAlignment::kBest);
  MapErrors errors;
  errors.first_mean_m = first.translation_m.mean;
  errors.first_final_m = first.final_translation_m;
  errors.mean_m = best.translation_m.mean;
  errors.highest_m = best.translation_m.max;
  errors.heading_mean_rad = best.rotation_rad.mean;
  errors.heading_highest_rad = best.rotation_rad.max;
  errors.num_pieces = track.pieces.size();
  errors.num_unjoined = static_cast<std::size_t>(
      std::count_if(track.pieces.begin(), track.pieces.end(), [](const TrackPiece& piece) {
        return !piece.is_joined;
      }));
  errors.num_lost = static_cast<std::size_t>(
      std::count_if(track.scans.begin(), track.scans.end(), [](const MappedScan& scan) {
        return scan.status == TrackStatus::kLost;
      }));
  errors.closures = count_closures(track, truth);
  return errors;
}

}  // namespace setsquare::experiments
