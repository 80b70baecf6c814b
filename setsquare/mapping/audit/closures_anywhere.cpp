// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/closures_anywhere.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <Eigen/LU>
#include <limits>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/marginal_covariance.hpp"
#include "setsquare/graph/node_sets.hpp"
#include "setsquare/mapping/audit/matched_pairs.hpp"
#include "setsquare/mapping/spread_graph.hpp"

namespace setsquare {
namespace {

/// Matches about which more pairs are matched, at most.
constexpr std::size_t kMaxNumSeconded = 40;
/// Ends of matches within this along the track are of the same place.
constexpr double kSameRoom_m = 6.0;

/// A group of matches, by the one in its middle.
struct ToldPlace {
  AlikeMatches alike;
  AuditPair pair;
  Eigen::Vector2d off_m;  ///< From where the map has the later keyframe to where it is told to be.
};

/// What some matches tell, in metres along two axes.
struct Extent {
  Eigen::Vector2d low_m = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high_m = -low_m;

  void add(const Eigen::Vector2d& point_m) {
    low_m = low_m.cwiseMin(point_m);
    high_m = high_m.cwiseMax(point_m);
  }
};

class ClosureJudge {
 public:
  ClosureJudge(std::span<const AuditMatch> matches,
               const AuditedTrack& track,
               const WaySpread& spread,
               const ClosuresAnywhereParams& params,
               const AuditParams& audit)
      : matches_(matches), track_(track), spread_(spread), params_(params), audit_(audit) {
    audit_.alike_share = 0.0;  // Tracking held within each part: it is off as a whole.
  }

  /// Matches that the map admits and does not know.
  [[nodiscard]] std::vector<std::size_t> undetermined() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const AuditOffset offset = audit_offset(matches_[i], track_, audit_);
      if (offset.off_m < audit_.off_m || offset.off_rad > audit_.off_rad) continue;
      const Eigen::Matrix2d way_m2 = spread_(matches_[i].pair.from, matches_[i].pair.to);
      if (is_loose(way_m2) && admits(way_m2, off_by(matches_[i]))) found.push_back(i);
    }
    return found;
  }

  [[nodiscard]] std::vector<std::size_t> believed() const {
    std::vector<std::size_t> found;
    std::vector<ToldPlace> left = told_places();
    while (!left.empty()) {
      const std::vector<ToldPlace> together = most_together(left);
      if (is_unambiguous(together)) {
        for (const ToldPlace& place : together) {
          found.insert(found.end(), place.alike.members.begin(), place.alike.members.end());
        }
      }
      std::erase_if(left, [&](const ToldPlace& place) {
        return std::any_of(together.begin(), together.end(), [&](const ToldPlace& other) {
          return other.alike.centre == place.alike.centre;
        });
      });
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  [[nodiscard]] bool is_loose(const Eigen::Matrix2d& way_m2) const {
    return symmetric_eigenvalues(way_m2).y() > params_.min_spread_m * params_.min_spread_m;
  }

  [[nodiscard]] bool admits(const Eigen::Matrix2d& way_m2, const Eigen::Vector2d& off_m) const {
    const Eigen::Matrix2d all_m2 =
        way_m2 + audit_.alike_m * audit_.alike_m * Eigen::Matrix2d::Identity();
    return off_m.dot(all_m2.inverse() * off_m) < audit_.max_sigmas * audit_.max_sigmas;
  }

  [[nodiscard]] Eigen::Vector2d off_by(const AuditMatch& match) const {
    return (track_.T_map_sensor[match.pair.from] * match.T_from_to).translation() -
           track_.T_map_sensor[match.pair.to].translation();
  }

  [[nodiscard]] double way_m(std::size_t a, std::size_t b) const {
    return std::abs(track_.way_m[a] - track_.way_m[b]);
  }

  /// Independent matches of the largest group of them that tell the same.
  [[nodiscard]] std::size_t most_alike(std::vector<std::size_t> indices) const {
    const auto groups = alike_groups(matches_, std::move(indices), track_, audit_);
    return groups.empty() ? 0 : groups.front().num_places;
  }

  [[nodiscard]] std::vector<ToldPlace> told_places() const {
    std::vector<ToldPlace> places;
    for (AlikeMatches& alike : alike_groups(matches_, undetermined(), track_, audit_)) {
      if (alike.num_places < params_.min_places) continue;
      const AuditMatch& centre = matches_[alike.centre];
      const ToldPlace place{std::move(alike), centre.pair, off_by(centre)};
      if (!has_rivals(place)) places.push_back(place);
    }
    return places;
  }

  /// Whether the later keyframes were matched with other places, too, that tell otherwise.
  [[nodiscard]] bool has_rivals(const ToldPlace& place) const {
    std::vector<std::size_t> rivals;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const AuditMatch& match = matches_[i];
      if (audit_offset(match, track_, audit_).off_rad > audit_.off_rad) continue;
      const bool is_beside = std::any_of(
          place.alike.members.begin(), place.alike.members.end(), [&](std::size_t member) {
            return way_m(matches_[member].pair.to, match.pair.to) < audit_.near_m;
          });
      const Eigen::Vector2d off_m = off_by(match);
      if (!is_beside || (off_m - place.off_m).norm() < 2.0 * audit_.alike_m) continue;
      const bool is_as_tracked =
          off_m.norm() < audit_.off_m && !is_loose(spread_(match.pair.from, match.pair.to));
      if (!is_as_tracked) rivals.push_back(i);
    }
    return static_cast<double>(most_alike(std::move(rivals))) >=
           params_.max_rival_share * static_cast<double>(place.alike.num_places);
  }

  /// Whether both can be right.
  [[nodiscard]] bool go_together(const ToldPlace& a, const ToldPlace& b) const {
    return admits(spread_(a.pair.from, b.pair.from) + spread_(a.pair.to, b.pair.to),
                  a.off_m - b.off_m);
  }

  /// The most that go together, about one of them.
  [[nodiscard]] std::vector<ToldPlace> most_together(const std::vector<ToldPlace>& places) const {
    std::vector<ToldPlace> best;
    for (const ToldPlace& first : places) {
      std::vector<ToldPlace> together = {first};
      for (const ToldPlace& other : places) {
        const bool is_first = other.alike.centre == first.alike.centre;
        const bool fits = std::all_of(together.begin(), together.end(), [&](const ToldPlace& one) {
          return go_together(one, other);
        });
        if (!is_first && fits) together.push_back(other);
      }
      if (together.size() > best.size()) best = std::move(together);
    }
    return best;
  }

  /// Whether two groups are of one room, or of rooms that look the same: as many matches say so as
  /// tell a closure.
  [[nodiscard]] bool are_alike_rooms(const ToldPlace& a, const ToldPlace& b) const {
    if (way_m(a.pair.from, b.pair.from) < audit_.part_m ||
        way_m(a.pair.to, b.pair.to) < audit_.part_m) {
      return true;
    }
    const auto is_in = [&](const ToldPlace& place, std::size_t keyframe) {
      return way_m(place.pair.from, keyframe) < kSameRoom_m ||
             way_m(place.pair.to, keyframe) < kSameRoom_m;
    };
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const AuditPair& pair = matches_[i].pair;
      const bool is_across =
          (is_in(a, pair.from) && is_in(b, pair.to)) || (is_in(b, pair.from) && is_in(a, pair.to));
      if (!is_across) continue;
      if (audit_offset(matches_[i], track_, audit_).off_rad < audit_.off_rad) alike.push_back(i);
    }
    return most_alike(std::move(alike)) >= params_.min_places;
  }

  /// Rooms among them, no two of which look the same.
  [[nodiscard]] std::size_t num_rooms(const std::vector<ToldPlace>& together) const {
    std::vector<ToldPlace> rooms;
    for (const ToldPlace& place : together) {
      const bool is_known = std::any_of(rooms.begin(), rooms.end(), [&](const ToldPlace& room) {
        return are_alike_rooms(place, room);
      });
      if (!is_known) rooms.push_back(place);
    }
    return rooms.size();
  }

  /// One group of each place: if all are right, those that share a part of the track are of one
  /// place, and tell no extent.
  [[nodiscard]] std::vector<ToldPlace> one_per_place(std::vector<ToldPlace> together) const {
    std::sort(together.begin(), together.end(), [](const auto& a, const auto& b) {
      return a.pair < b.pair;
    });
    const auto share_part = [&](const ToldPlace& a, const ToldPlace& b) {
      const auto is_near = [&](std::size_t k, std::size_t other) {
        return way_m(k, other) < audit_.part_m;
      };
      return is_near(a.pair.from, b.pair.from) || is_near(a.pair.from, b.pair.to) ||
             is_near(a.pair.to, b.pair.from) || is_near(a.pair.to, b.pair.to);
    };
    NodeSets places(together.size());
    for (std::size_t i = 0; i < together.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (share_part(together[i], together[j])) places.join(i, j);
      }
    }
    std::vector<ToldPlace> first;
    for (std::size_t i = 0; i < together.size(); ++i) {
      if (places.lowest(i) == i) first.push_back(together[i]);
    }
    return first;
  }

  /// How far the places of the matches lie apart along two axes: the mean of both passes, for where
  /// both are one they have one length.
  [[nodiscard]] Eigen::Vector2d extent_m(const std::vector<ToldPlace>& together,
                                         const Eigen::Matrix2d& to_axes) const {
    Extent of_from;
    Extent of_to;
    for (const ToldPlace& place : one_per_place(together)) {
      for (const std::size_t i : place.alike.members) {
        const AuditPair& pair = matches_[i].pair;
        of_from.add(to_axes * track_.T_map_sensor[pair.from].translation());
        of_to.add(to_axes * track_.T_map_sensor[pair.to].translation());
      }
    }
    return 0.5 * (of_from.high_m - of_from.low_m + of_to.high_m - of_to.low_m);
  }

  [[nodiscard]] bool is_unambiguous(const std::vector<ToldPlace>& together) const {
    const ToldPlace& entry =
        *std::min_element(together.begin(), together.end(), [](const auto& a, const auto& b) {
          return a.pair.to < b.pair.to;
        });
    const SymmetricEigen<2> spread = symmetric_eigen(spread_(entry.pair.from, entry.pair.to));
    const Eigen::Matrix2d to_axes = spread.vectors.transpose();
    const Eigen::Vector2d extends_m = extent_m(together, to_axes);
    const Eigen::Vector2d off_m = (to_axes * entry.off_m).cwiseAbs();
    const std::size_t rooms = num_rooms(together);
    for (int axis = 0; axis < 2; ++axis) {
      const double sigma_m = std::sqrt(std::max(0.0, spread.values(axis)));
      if (sigma_m < params_.min_spread_m) continue;
      const double num_sigmas = rooms == 2 ? params_.num_sigmas_of_two : params_.num_sigmas_of_one;
      const double least_m = rooms > 2 ? sigma_m : off_m(axis) + num_sigmas * sigma_m;
      if (extends_m(axis) < params_.extent_share * least_m) return false;
    }
    return true;
  }

  std::span<const AuditMatch> matches_;
  const AuditedTrack& track_;
  const WaySpread& spread_;
  const ClosuresAnywhereParams& params_;
  AuditParams audit_;
};

}  // namespace

void ClosuresAnywhereParams::validate() const {
  require_positive(min_spread_m, "anywhere.min_spread_m");
  require_at_least_one(max_num_places, "anywhere.max_num_places");
  require_at_least_one(num_alike, "anywhere.num_alike");
  require_at_least_one(min_places, "anywhere.min_places");
  require_positive(max_rival_share, "anywhere.max_rival_share");
  require_not_negative(num_sigmas_of_one, "anywhere.num_sigmas_of_one");
  require_not_negative(num_sigmas_of_two, "anywhere.num_sigmas_of_two");
  require_not_negative(extent_share, "anywhere.extent_share");
  if (max_rounds < 0) throw ParameterError("anywhere.max_rounds", "must not be negative");
  require_not_negative(min_kept, "anywhere.min_kept");
}

std::vector<std::size_t> believed_closures(std::span<const AuditMatch> matches,
                                           const AuditedTrack& track,
                                           const WaySpread& spread,
                                           const ClosuresAnywhereParams& params,
                                           const AuditParams& audit) {
  return ClosureJudge(matches, track, spread, params, audit).believed();
}

std::vector<MapHypothesis> closures_anywhere(const Map& map,
                                             std::span<const ScanSurfacesPtr> surfaces,
                                             const ClosuresAnywhereParams& params,
                                             const AuditParams& audit,
                                             std::size_t num_threads) {
  assert(surfaces.size() == map.keyframes.size());
  params.validate();
  const AuditedTrack track = audited_track(map);
  const double min_m2 = params.min_spread_m * params.min_spread_m;
  if (track.size() == 0 || !(track.open_m2.back() > min_m2)) return {};
  MatchedPairs matched(track, surfaces, num_threads);
  const auto places = matched.places(telling_places(track, params.max_num_places));
  matched.match(pairs_within_spread(track, places, audit, params.num_alike), MatchEffort::kQuick);
  if (matched.matches().empty()) return {};

  const MarginalCovariance marginals(spread_graph(map));
  const WaySpread spread = [&](std::size_t from, std::size_t to) -> Eigen::Matrix2d {
    return marginals.of_way(track.keyframes[from], track.keyframes[to]);
  };
  const auto undetermined =
      ClosureJudge(matched.matches(), track, spread, params, audit).undetermined();
  const auto groups = alike_groups(matched.matches(), undetermined, track, audit);
  matched.match_about(groups, kMaxNumSeconded);

  std::vector<MapHypothesis> found;
  for (const std::size_t i : believed_closures(matched.matches(), track, spread, params, audit)) {
    found.push_back(hypothesis_by(matched.matches()[i], track, params.min_places));
  }
  return found;
}

bool has_kept(const Map& map,
              std::span<const MapHypothesis> hypotheses,
              const ClosuresAnywhereParams& params,
              const AuditParams& audit) {
  std::size_t num_kept = 0;
  for (const MapHypothesis& told : hypotheses) {
    const Pose2 T_from_to = map.scans[map.keyframes[told.keyframe_from]].T_map_sensor.inverse() *
                            map.scans[map.keyframes[told.keyframe_to]].T_map_sensor;
    const Pose2 off = told.T_from_to.inverse() * T_from_to;
    num_kept += off.translation().norm() < audit.off_m && std::abs(off.theta_rad) < audit.off_rad;
  }
  return static_cast<double>(num_kept) >= params.min_kept * static_cast<double>(hypotheses.size());
}

}  // namespace setsquare
