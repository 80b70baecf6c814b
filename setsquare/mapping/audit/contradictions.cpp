// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/contradictions.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// Matches whose scans were both taken nearer than this to those of another see the same.
constexpr double kSamePlace_m = 0.5;
/// An agreeing match within this of a contradicting one speaks of the same parts.
constexpr double kBeside_m = 3.0;
/// Tracking that held throughout turns by no more than this; what asks for more sees alike corners.
constexpr double kMaxTurn_rad = rad_from_deg(30.0);

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
    group.num_agreeing = num_places_of(agreeing_with_map(group), track_);
    group.raises_doubt = raises_doubt(group);
    return group;
  }

  [[nodiscard]] std::vector<AuditPair> agreeing_with_map(const ContradictionGroup& group) const {
    std::vector<AuditPair> found;
    for (const std::size_t i : agreeing_) {
      const bool is_beside =
          std::any_of(group.members.begin(), group.members.end(), [&](std::size_t member) {
            const auto [from_m, to_m] =
                ways_between(matches_[i].pair, matches_[member].pair, track_);
            return std::max(from_m, to_m) < kBeside_m;
          });
      if (is_beside) found.push_back(matches_[i].pair);
    }
    return found;
  }

  [[nodiscard]] bool raises_doubt(const ContradictionGroup& group) const {
    if (group.num_places < params_.min_seconded) return false;
    if (static_cast<double>(group.num_places) <
        params_.min_majority * static_cast<double>(group.num_agreeing)) {
      return false;
    }
    const AuditMatch& centre = matches_[group.centre];
    return std::abs(correction_of(centre, track_).theta_rad) < kMaxTurn_rad ||
           has_restarted_between(centre.pair, track_);
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
  const double admitted_m =
      params.max_sigmas *
      std::sqrt(std::max(0.0, track.open_m2[match.pair.to] - track.open_m2[match.pair.from]));
  offset.contradicts_map =
      offset.off_m > std::max(params.off_m, admitted_m) || offset.off_rad > params.off_rad;
  return offset;
}

std::vector<ContradictionGroup> contradiction_groups(std::span<const AuditMatch> matches,
                                                     const AuditedTrack& track,
                                                     const AuditParams& params) {
  return ContradictionGrouping(matches, track, params).all();
}

}  // namespace setsquare
