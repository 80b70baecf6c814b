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
/// A way that the map admits to be off by more (sigma) leads through an open stretch.
constexpr double kOpenWay_m = 0.5;
/// A scan that tracking lost counts for as much way.
constexpr double kLostWay_m = 20.0;

/// Standard deviation that the map itself admits between two of its keyframes.
double admitted_m(const AuditPair& pair, const AuditedTrack& track) {
  return std::sqrt(std::max(0.0, track.open_m2[pair.to] - track.open_m2[pair.from]));
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
  const Pose2 by_a = correction_by(a, track);
  const Pose2 by_b = correction_by(b, track);
  if (std::abs(wrap_to_pi(by_a.theta_rad - by_b.theta_rad)) > params.alike_rad) return false;
  const auto moved_apart_m = [&](std::size_t keyframe) {
    const Eigen::Vector2d p = track.T_map_sensor[keyframe].translation();
    return (by_a * p - by_b * p).norm();
  };
  const Eigen::Vector2d p = track.T_map_sensor[a.pair.to].translation();
  const double max_m = params.alike_m + params.alike_share * (by_a * p - p).norm();
  return std::max(moved_apart_m(a.pair.to), moved_apart_m(b.pair.to)) < max_m;
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
      (audit_offset(matches[i], track, params).contradicts_map ? contradicting_ : agreeing_)
          .push_back(i);
    }
  }

  std::vector<ContradictionGroup> all() {
    std::vector<ContradictionGroup> groups;
    for (AlikeMatches& alike : alike_groups(matches_, contradicting_, track_, params_)) {
      groups.push_back(weighed(std::move(alike)));
    }
    return groups;
  }

 private:
  [[nodiscard]] std::vector<AuditPair> pairs_of(const std::vector<std::size_t>& members) const {
    std::vector<AuditPair> pairs;
    for (const std::size_t i : members) pairs.push_back(matches_[i].pair);
    return pairs;
  }

  /// The group against what agrees with the map.
  [[nodiscard]] ContradictionGroup weighed(AlikeMatches alike) const {
    ContradictionGroup group{std::move(alike)};
    const std::vector<std::size_t> beside = agreeing_beside(group);
    group.num_agreeing = num_places_of(matches_, beside, track_);
    group.raises_doubt = has_majority(group) && could_be_error_of_map(group, beside);
    group.may_be_twin = is_twin_admitted(group);
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

  [[nodiscard]] bool is_twin_admitted(const ContradictionGroup& group) const {
    const AuditMatch& centre = matches_[group.centre];
    if (admitted_m(centre.pair, track_) < kOpenWay_m) return false;
    const Eigen::Vector2d p = track_.T_map_sensor[centre.pair.to].translation();
    const Eigen::Vector2d off_m = correction_by(centre, track_) * p - p;
    double low_m = 0.0;
    double high_m = 0.0;
    for (const std::size_t i : group.members) {
      const Eigen::Vector2d member_m = track_.T_map_sensor[matches_[i].pair.to].translation();
      const double along_m = (member_m - p).dot(off_m.normalized());
      low_m = std::min(low_m, along_m);
      high_m = std::max(high_m, along_m);
    }
    return off_m.norm() > high_m - low_m;
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
    const Pose2 correction = correction_by(match, track_);
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
  std::vector<std::size_t> contradicting_;  ///< The map.
  std::vector<std::size_t> agreeing_;       ///< With the map.
};

/// Those that are alike one of them.
std::vector<std::size_t> alike_one(std::size_t centre,
                                   std::span<const AuditMatch> matches,
                                   const std::vector<std::size_t>& among,
                                   const AuditedTrack& track,
                                   const AuditParams& params) {
  std::vector<std::size_t> found;
  for (const std::size_t other : among) {
    if (other == centre || are_alike(matches[centre], matches[other], track, params)) {
      found.push_back(other);
    }
  }
  return found;
}

}  // namespace

Pose2 correction_by(const AuditMatch& match, const AuditedTrack& track) {
  return track.T_map_sensor[match.pair.from] * match.T_from_to *
         track.T_map_sensor[match.pair.to].inverse();
}

std::size_t num_places_of(std::span<const AuditMatch> matches,
                          const std::vector<std::size_t>& indices,
                          const AuditedTrack& track) {
  std::vector<AuditPair> counted;
  for (const std::size_t i : indices) {
    const AuditPair& pair = matches[i].pair;
    const auto is_same = [&](const AuditPair& other) {
      const auto [from_m, to_m] = ways_between(pair, other, track);
      return std::max(from_m, to_m) < kSamePlace_m;
    };
    if (std::none_of(counted.begin(), counted.end(), is_same)) counted.push_back(pair);
  }
  return counted.size();
}

std::vector<AlikeMatches> alike_groups(std::span<const AuditMatch> matches,
                                       std::vector<std::size_t> indices,
                                       const AuditedTrack& track,
                                       const AuditParams& params) {
  std::vector<AlikeMatches> groups;
  while (!indices.empty()) {
    AlikeMatches group;
    for (const std::size_t centre : indices) {
      std::vector<std::size_t> members = alike_one(centre, matches, indices, track, params);
      const std::size_t num_places = num_places_of(matches, members, track);
      if (num_places <= group.num_places) continue;
      group = {.members = std::move(members), .centre = centre, .num_places = num_places};
    }
    std::erase_if(indices, [&](std::size_t i) {
      return std::binary_search(group.members.begin(), group.members.end(), i);
    });
    groups.push_back(std::move(group));
  }
  return groups;
}

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

bool agrees(const AuditOffset& offset, const AuditParams& params) {
  return offset.off_m < params.off_m && offset.off_rad < params.off_rad;
}

std::vector<ContradictionGroup> contradiction_groups(std::span<const AuditMatch> matches,
                                                     const AuditedTrack& track,
                                                     const AuditParams& params) {
  return ContradictionGrouping(matches, track, params).all();
}

}  // namespace setsquare
