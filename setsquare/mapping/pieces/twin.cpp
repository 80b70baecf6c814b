// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/twin.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "setsquare/mapping/audit/seen_through.hpp"
#include "setsquare/mapping/loops/candidates.hpp"

namespace setsquare {
namespace {

/// Keyframes nearer to each other see the same.
constexpr double kSameView_m = 2.0;
/// What is nearer to a place that agrees is that place.
constexpr double kSameSpot_m = 3.0;
/// Farther away, as the robot drives, tracking drifts.
constexpr double kUndrifted_m = 12.0;
/// Fewer keyframes tell nothing.
constexpr std::size_t kFewestCompared = 4;

double straight_m(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}

double extent_m(const std::vector<std::size_t>& places, std::span<const Pose2> T_map_sensor) {
  double extent_m = 0.0;
  for (const std::size_t a : places) {
    for (const std::size_t b : places) {
      extent_m = std::max(extent_m, straight_m(T_map_sensor[a], T_map_sensor[b]));
    }
  }
  return extent_m;
}

/// Keyframes of the piece that are not far from one of the places along the track.
std::set<std::size_t> keyframes_about(const JoiningClaim& claim,
                                      const KeyframeTrack& track,
                                      std::span<const Pose2> T_map_sensor) {
  std::set<std::size_t> found(claim.places.begin(), claim.places.end());
  for (const std::size_t place : claim.places) {
    for (const bool is_forward : {false, true}) {
      double way_m = 0.0;
      for (std::size_t k = place; way_m < kUndrifted_m;) {
        if (is_forward ? k + 1 == track.size() : k == 0) break;
        const std::size_t next = is_forward ? k + 1 : k - 1;
        if (track.pieces[next] != track.pieces[k]) break;
        way_m += straight_m(T_map_sensor[next], T_map_sensor[k]);
        k = next;
        if (claim.piece[k]) found.insert(k);
      }
    }
  }
  return found;
}

/// How keyframes of the piece compare with what is known where they would stand.
struct SeenThrough {
  std::size_t num_compared = 0;
  std::size_t num_contradicted = 0;

  void add(bool is_contradicted) {
    ++num_compared;
    num_contradicted += is_contradicted ? 1 : 0;
  }
  [[nodiscard]] bool is_more_than(double share) const {
    return num_compared >= kFewestCompared &&
           static_cast<double>(num_contradicted) > share * static_cast<double>(num_compared);
  }
};

}  // namespace

bool may_be_twin(const JoiningClaim& claim,
                 const KeyframeTrack& track,
                 std::span<const Pose2> T_map_sensor,
                 const PieceJoiningParams& params) {
  return extent_m(claim.places, T_map_sensor) < params.min_extent_m ||
         sees_through_map(claim, track, T_map_sensor, params);
}

bool sees_through_map(const JoiningClaim& claim,
                      const KeyframeTrack& track,
                      std::span<const Pose2> T_map_sensor,
                      const PieceJoiningParams& params) {
  PositionHash known(kSameView_m);
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (claim.known[k]) known.add(T_map_sensor[k].translation(), k);
  }
  SeenThrough all;
  SeenThrough beside;
  for (const std::size_t k : keyframes_about(claim, track, T_map_sensor)) {
    const Pose2 T_map_k = claim.T_map_piece * T_map_sensor[k];
    std::optional<std::size_t> nearest;
    double nearest_m = kSameView_m;
    known.visit(T_map_k.translation(), kSameView_m, [&](std::size_t other) {
      const double apart_m = straight_m(T_map_sensor[other], T_map_k);
      if (apart_m >= nearest_m) return;
      nearest_m = apart_m;
      nearest = other;
    });
    if (!nearest) continue;
    const bool is_contradicted = see_through_each_other(*track.keyframes[*nearest],
                                                        *track.keyframes[k],
                                                        T_map_sensor[*nearest].inverse() * T_map_k);
    all.add(is_contradicted);
    const bool is_beside = std::ranges::none_of(claim.places, [&](std::size_t place) {
      return straight_m(T_map_sensor[place], T_map_sensor[k]) < kSameSpot_m;
    });
    if (is_beside) beside.add(is_contradicted);
  }
  return all.is_more_than(params.max_seen_through) || beside.is_more_than(params.max_seen_through);
}

}  // namespace setsquare
