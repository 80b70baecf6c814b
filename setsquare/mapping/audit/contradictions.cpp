// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/contradictions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// Matches whose scans were both taken nearer than this to those of another see the same.
constexpr double kSamePlace_m = 0.5;
/// An agreeing match within this of a contradicting one speaks of the same parts.
constexpr double kBeside_m = 3.0;
/// Tracking that held throughout turns by no more than this; what asks for more sees alike corners.
constexpr double kMaxTurn_rad = rad_from_deg(30.0);

/// What tracking may have lost of a way: a share of it, with what a wrong heading adds, and this.
constexpr double kSlip_m = 0.5;
constexpr double kSlipPerMetre = 0.1;
/// Length of a match that agrees with the map, in a way between two places.
constexpr double kMatchWay_m = 1.0;
/// A scan that tracking lost counts for as much way.
constexpr double kLostWay_m = 20.0;

/// Standard deviation that the map itself admits between two of its keyframes.
double admitted_m(const AuditPair& pair, const AuditedTrack& track) {
  return std::sqrt(std::max(0.0, track.open_m2[pair.to] - track.open_m2[pair.from]));
}

/// How the map would move about the later keyframe, which stays what it is elsewhere.
Pose2 correction_of(const AuditMatch& match, const AuditedTrack& track) {
  return track.T_map_sensor[match.pair.from] * match.T_from_to *
         track.T_map_sensor[match.pair.to].inverse();
}

/// Distances along the track between the ends of two pairs.
std::pair<double, double> ways_between(const AuditPair& a,
                                       const AuditPair& b,
                                       const AuditedTrack& track) {
  return {std::abs(track.way_m[a.from] - track.way_m[b.from]),
          std::abs(track.way_m[a.to] - track.way_m[b.to])};
}

bool are_alike(const AuditMatch& a,
               const AuditMatch& b,
               const AuditedTrack& track,
               const AuditParams& params) {
  const auto [from_m, to_m] = ways_between(a.pair, b.pair, track);
  if (std::max(from_m, to_m) > params.part_m) return false;
  const Pose2 by_a = correction_of(a, track);
  const Pose2 by_b = correction_of(b, track);
  if (std::abs(wrap_to_pi(by_a.theta_rad - by_b.theta_rad)) > params.alike_rad) return false;
  const auto moved_apart_m = [&](std::size_t keyframe) {
    const Eigen::Vector2d p = track.T_map_sensor[keyframe].translation();
    return (by_a * p - by_b * p).norm();
  };
  const Eigen::Vector2d p = track.T_map_sensor[a.pair.to].translation();
  const double max_m = params.alike_m + params.alike_share * (by_a * p - p).norm();
  return std::max(moved_apart_m(a.pair.to), moved_apart_m(b.pair.to)) < max_m;
}

/// How many of the pairs were not taken from the same places as one counted before.
std::size_t num_places_of(const std::vector<AuditPair>& pairs, const AuditedTrack& track) {
  std::vector<AuditPair> counted;
  for (const AuditPair& pair : pairs) {
    const auto is_same = [&](const AuditPair& other) {
      const auto [from_m, to_m] = ways_between(pair, other, track);
      return std::max(from_m, to_m) < kSamePlace_m;
    };
    if (std::none_of(counted.begin(), counted.end(), is_same)) counted.push_back(pair);
  }
  return counted.size();
}

bool has_restarted_between(const AuditPair& pair, const AuditedTrack& track) {
  const auto first = std::upper_bound(track.restarts.begin(), track.restarts.end(), pair.from);
  return first != track.restarts.end() && *first <= pair.to;
}

/// The shortest way from one keyframe to another: along the track, or by matches that agree with
/// the map, which tie places to each other.
double shortest_way_m(const AuditPair& ends,
                      const std::vector<AuditPair>& ties,
                      const AuditedTrack& track) {
  std::vector<std::vector<std::size_t>> tied(track.size());
  for (const AuditPair& pair : ties) {
    tied[pair.from].push_back(pair.to);
    tied[pair.to].push_back(pair.from);
  }
  std::vector<double> ways_m(track.size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  const auto step_m = [&](std::size_t k) {  // to k from the keyframe before
    const bool is_lost = std::binary_search(track.losses.begin(), track.losses.end(), k);
    return track.way_m[k] - track.way_m[k - 1] + (is_lost ? kLostWay_m : 0.0);
  };
  const auto reach = [&](std::size_t keyframe, double way_m) {
    if (!(way_m < ways_m[keyframe])) return;
    ways_m[keyframe] = way_m;
    open.push({way_m, keyframe});
  };
  reach(ends.from, 0.0);
  while (!open.empty()) {
    const auto [way_m, k] = open.top();
    open.pop();
    if (k == ends.to) return way_m;
    if (way_m > ways_m[k]) continue;
    if (k > 0) reach(k - 1, way_m + step_m(k));
    if (k + 1 < track.size()) reach(k + 1, way_m + step_m(k + 1));
    for (const std::size_t other : tied[k]) reach(other, way_m + kMatchWay_m);
  }
  return ways_m[ends.to];
}

class ContradictionGrouping {
 public:
  ContradictionGrouping(std::span<const AuditMatch> matches,
                        const AuditedTrack& track,
                        const AuditParams& params)
      : matches_(matches), track_(track), params_(params) {
    for (std::size_t i = 0; i < matches.size(); ++i) {
      (audit_offset(matches[i], track, params).contradicts_map ? left_ : agreeing_).push_back(i);
    }
  }

  std::vector<ContradictionGroup> all() {
    std::vector<ContradictionGroup> groups;
    while (!left_.empty()) groups.push_back(next());
    return groups;
  }

 private:
  /// Those that are left and alike, about one of them.
  [[nodiscard]] std::vector<std::size_t> alike(std::size_t centre) const {
    std::vector<std::size_t> found;
    for (const std::size_t other : left_) {
      if (other == centre || are_alike(matches_[centre], matches_[other], track_, params_)) {
        found.push_back(other);
      }
    }
    return found;
  }

  [[nodiscard]] std::vector<AuditPair> pairs_of(const std::vector<std::size_t>& members) const {
    std::vector<AuditPair> pairs;
    for (const std::size_t i : members) pairs.push_back(matches_[i].pair);
    return pairs;
  }

  /// The greatest group among those that are left, which it leaves.
  ContradictionGroup next() {
    ContradictionGroup group;
    for (const std::size_t centre : left_) {
      std::vector<std::size_t> members = alike(centre);
      const std::size_t num_places = num_places_of(pairs_of(members), track_);
      if (num_places <= group.num_places) continue;
      group = {.members = std::move(members), .centre = centre, .num_places = num_places};
    }
    std::erase_if(left_, [&](std::size_t i) {
      return std::binary_search(group.members.begin(), group.members.end(), i);
    });
    const std::vector<std::size_t> beside = agreeing_beside(group);
    group.num_agreeing = num_places_of(pairs_of(beside), track_);
    group.raises_doubt = has_majority(group) && could_be_error_of_map(group, beside);
    return group;
  }

  /// What agrees with the map between the same parts of the track.
  [[nodiscard]] std::vector<std::size_t> agreeing_beside(const ContradictionGroup& group) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : agreeing_) {
      const auto is_beside = [&](std::size_t member) {
        const auto [from_m, to_m] = ways_between(matches_[i].pair, matches_[member].pair, track_);
        return std::max(from_m, to_m) < kBeside_m;
      };
      if (std::any_of(group.members.begin(), group.members.end(), is_beside)) found.push_back(i);
    }
    return found;
  }

  [[nodiscard]] bool has_majority(const ContradictionGroup& group) const {
    return group.num_places >= params_.min_seconded &&
           static_cast<double>(group.num_places) >=
               params_.min_majority * static_cast<double>(group.num_agreeing);
  }

  /// Whether tracking can have gone wrong by so much between two places, by the shortest way apart
  /// from what is disputed. What cannot be is an alias: a niche every few metres, or a corner that
  /// looks like another one turned.
  [[nodiscard]] bool could_be_error_of_map(const ContradictionGroup& group,
                                           const std::vector<std::size_t>& disputed) const {
    const AuditMatch& match = matches_[group.centre];
    if (has_restarted_between(match.pair, track_)) return true;
    const Pose2 correction = correction_of(match, track_);
    const double turn_rad = std::abs(correction.theta_rad);
    if (turn_rad > kMaxTurn_rad) return false;
    std::vector<std::size_t> undisputed;
    std::set_difference(agreeing_.begin(),
                        agreeing_.end(),
                        disputed.begin(),
                        disputed.end(),
                        std::back_inserter(undisputed));
    const double way_m = shortest_way_m(match.pair, pairs_of(undisputed), track_);
    const double slip_m = kSlip_m + (kSlipPerMetre + turn_rad) * way_m +
                          params_.max_sigmas * admitted_m(match.pair, track_);
    const Eigen::Vector2d p = track_.T_map_sensor[match.pair.to].translation();
    return (correction * p - p).norm() < slip_m;
  }

  std::span<const AuditMatch> matches_;
  const AuditedTrack& track_;
  const AuditParams& params_;
  std::vector<std::size_t> left_;      ///< Contradictions in no group, in order.
  std::vector<std::size_t> agreeing_;  ///< With the map.
};

}  // namespace

AuditOffset audit_offset(const AuditMatch& match,
                         const AuditedTrack& track,
                         const AuditParams& params) {
  const Pose2 T_from_to =
      track.T_map_sensor[match.pair.from].inverse() * track.T_map_sensor[match.pair.to];
  AuditOffset offset{
      .off_m = (match.T_from_to.translation() - T_from_to.translation()).norm(),
      .off_rad = std::abs(wrap_to_pi(match.T_from_to.theta_rad - T_from_to.theta_rad))};
  const double spread_m = params.max_sigmas * admitted_m(match.pair, track);
  offset.contradicts_map =
      offset.off_m > std::max(params.off_m, spread_m) || offset.off_rad > params.off_rad;
  return offset;
}

std::vector<ContradictionGroup> contradiction_groups(std::span<const AuditMatch> matches,
                                                     const AuditedTrack& track,
                                                     const AuditParams& params) {
  return ContradictionGrouping(matches, track, params).all();
}

}  // namespace setsquare
