// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/piece_joining.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "setsquare/core/median.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/mapping/pieces/known_joints.hpp"
#include "setsquare/mapping/pieces/place_signature.hpp"
#include "setsquare/mapping/pieces/proposal.hpp"
#include "setsquare/mapping/pieces/steps_across_break.hpp"
#include "setsquare/mapping/pieces/twin.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/agreed_place.hpp"

namespace setsquare {
namespace {

/// A keyframe that stands for its surroundings.
struct Place {
  std::size_t keyframe = 0;
  PlaceSignature signature;
};

class PieceJoiner {
 public:
  PieceJoiner(const KeyframeTrack& track,
              std::span<const Pose2> T_map_sensor,
              std::span<const AnchoredKeyframe> known,
              const LoopCloserParams& closing,
              const PieceJoiningParams& params,
              std::size_t num_threads)
      : track_(track),
        T_map_sensor_(T_map_sensor.begin(), T_map_sensor.end()),
        closing_(closing),
        params_(params),
        num_threads_(num_threads),
        half_width_(closing.submap_half_width * track.num_scanners()) {
    const std::size_t num_pieces = track.pieces.empty() ? 0 : track.pieces.back() + 1;
    places_.resize(num_pieces);
    groups_.resize(num_pieces);
    std::iota(groups_.begin(), groups_.end(), std::size_t{0});
    joined_.turn_rad.assign(num_pieces, 0.0);
    joined_.is_joined.assign(num_pieces, false);
    joined_.searches.resize(num_pieces);
    const std::size_t spacing = closing.station_spacing * track.num_scanners();
    lay_known(known, T_map_sensor_);
    for (std::size_t k = 0; k < track.size(); ++k) {
      // Among key frames each has come as far as several keyframes elsewhere.
      if (k % spacing == 0 || track.motions[k].is_long_step) add_place(k);
    }
    join_known(known);
  }

  JoinedPieces join_all() {
    if (places_.empty()) return joined_;
    for (std::size_t k = 1; k < track_.size(); ++k) {
      const bool is_break = track_.pieces[k] != track_.pieces[k - 1];
      if (is_break && !std::ranges::binary_search(track_.session_begins, k)) join_across_break(k);
    }
    const std::size_t main = largest_group();
    // A group that finds no place may find one when others have been joined.
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (const std::size_t group : groups_besides(main)) {
        if (join_anywhere(group, main)) has_grown = true;
      }
    }
    for (std::size_t piece = 0; piece < groups_.size(); ++piece) {
      joined_.is_joined[piece] = groups_[piece] == main;
    }
    std::erase_if(joined_.joints, [&](const ComparedPlaces& joint) {
      return !joined_.is_joined[track_.pieces[joint.from]];
    });
    return joined_;
  }

 private:
  using Votes = double (*)(const std::vector<Proposal>&);

  void add_place(std::size_t keyframe) {
    const Submap submap = make_submap(track_, T_map_sensor_, keyframe, half_width_);
    places_[track_.pieces[keyframe]].push_back(
        {keyframe, place_signature(submap.fine, T_map_sensor_[keyframe].theta_rad)});
  }

  /// Joins the pieces that a map has joined.
  void join_known(std::span<const AnchoredKeyframe> known) {
    for (const std::vector<ComparedPlaces>& of_piece : known_joints(track_, known, params_)) {
      std::vector<Proposal> joints(of_piece.size());
      for (std::size_t i = 0; i < joints.size(); ++i) {
        joints[i].known = of_piece[i].from;
        joints[i].sought = of_piece[i].to;
        joints[i].places = of_piece[i];
      }
      merge(group_of(joints.front().sought), group_of(joints.front().known), joints);
    }
  }

  [[nodiscard]] std::size_t group_of(std::size_t keyframe) const {
    return groups_[track_.pieces[keyframe]];
  }

  /// The places of the group's pieces.
  [[nodiscard]] std::vector<Place> places_of(std::size_t group) const {
    std::vector<Place> places;
    for (std::size_t piece = 0; piece < places_.size(); ++piece) {
      if (groups_[piece] != group) continue;
      places.insert(places.end(), places_[piece].begin(), places_[piece].end());
    }
    return places;
  }

  /// The group with the most places, the earliest of several. Where a map is gone on with, only its
  /// own pieces count.
  [[nodiscard]] std::size_t largest_group() const {
    const std::size_t num_known =
        track_.num_known == 0 ? groups_.size() : track_.pieces[track_.num_known - 1] + 1;
    std::vector<std::size_t> num_places(groups_.size());
    for (std::size_t p = 0; p < num_known; ++p) num_places[groups_[p]] += places_[p].size();
    return static_cast<std::size_t>(std::max_element(num_places.begin(), num_places.end()) -
                                    num_places.begin());
  }

  [[nodiscard]] std::set<std::size_t> groups_besides(std::size_t main) const {
    std::set<std::size_t> others(groups_.begin(), groups_.end());
    others.erase(main);
    return others;
  }

  /// Moves all pieces of `sought` to where the joints, which agree, have them in `known`.
  void merge(std::size_t sought, std::size_t known, const std::vector<Proposal>& joints) {
    const double turn_rad = tracked_turn_rad(joints);
    for (std::size_t k = 0; k < track_.size(); ++k) {
      if (group_of(k) == sought) T_map_sensor_[k] = joints.front().T_map_piece * T_map_sensor_[k];
    }
    for (std::size_t piece = 0; piece < groups_.size(); ++piece) {
      if (groups_[piece] != sought) continue;
      joined_.turn_rad[piece] = wrap_to_pi(joined_.turn_rad[piece] + turn_rad);
      groups_[piece] = known;
    }
    for (const Proposal& joint : joints) joined_.joints.push_back(joint.places);
  }

  /// Tracking lost a scan, or found nothing that stood alone, and began anew; the scans around may
  /// all the same see enough of each other. `begin`: the keyframe after the break. Where steps are
  /// not long the robot may have been carried: then a match must have it where tracking has it,
  /// which does not happen by chance.
  void join_across_break(std::size_t begin) {
    const bool is_long_step = track_.motions[begin].is_long_step;
    const std::size_t reach =
        (is_long_step ? params_.num_across_break : params_.num_across_lost) * track_.num_scanners();
    const std::size_t first = begin - std::min(begin, reach);
    std::set<std::size_t> refused;  ///< Groups: until one is merged, nothing new can be found.
    for (std::size_t before = begin; before-- > first;) {
      const std::size_t known = group_of(before);
      const std::size_t sought = group_of(begin);
      if (known == sought || !refused.insert(known).second) continue;
      std::vector<Proposal> proposals;
      for (std::size_t i = first; i < begin; ++i) {
        for (std::size_t j = begin; j < std::min(begin + reach, track_.size()); ++j) {
          if (group_of(i) != known || group_of(j) != sought) continue;
          proposals.emplace_back();
          proposals.back().known = i;
          proposals.back().sought = j;
        }
      }
      const auto step_reach = is_long_step
                                  ? std::optional(reach_about_break(track_, begin, params_.steps))
                                  : std::nullopt;
      std::vector<Proposal> across = matched(std::move(proposals), step_reach);
      if (!is_long_step) {
        std::erase_if(across, [&](const Proposal& proposal) { return !is_as_tracked(proposal); });
      }
      std::vector<Proposal> agreed =
          is_long_step ? agreed_alone(across, &surest_in, params_.min_log_odds_across_break)
                       : agreed_alone(across, &weight_in, params_.min_votes_across_break);
      if (agreed.empty()) continue;
      if (is_long_step) std::ranges::stable_sort(agreed, std::greater{}, &Proposal::weight);
      const JoiningClaim claim = claim_of(agreed, sought, known);
      if (sees_through_map(claim, track_, T_map_sensor_, params_)) continue;
      merge(sought, known, agreed);
      refused.clear();
    }
  }

  bool join_anywhere(std::size_t group, std::size_t main) {
    if (places_of(group).size() < params_.min_agreeing) return false;
    const std::vector<Proposal> proposed = propose(group, main);
    const std::vector<Proposal> right = verified(proposed);
    note_search(group,
                {.num_pairs = proposed.size(),
                 .num_matched = right.size(),
                 .num_agreeing = static_cast<std::size_t>(places_in(most_agreed(right)))});
    const bool is_of_another = is_of_another_session(group, main);
    const std::vector<Proposal> agreed = agreed_alone(right,
                                                      is_of_another ? &places_seen_in : &places_in,
                                                      static_cast<double>(params_.min_agreeing));
    if (agreed.empty()) return false;
    if (is_of_another && 2.0 * places_seen_in(agreed) < places_in(agreed)) return false;
    const JoiningClaim claim = claim_of(agreed, group, main);
    const bool may_be_anywhere = is_of_another || open_way_m(agreed) > params_.min_extent_m;
    if (may_be_anywhere ? may_be_twin(claim, track_, T_map_sensor_, params_)
                        : sees_through_map(claim, track_, T_map_sensor_, params_)) {
      return false;
    }
    merge(group, main, agreed);
    return true;
  }

  /// The session that a keyframe is of.
  [[nodiscard]] std::size_t session_of(std::size_t keyframe) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(track_.session_begins, keyframe) -
                                    track_.session_begins.begin());
  }

  /// Whether the two groups have no session in common, whose odometry or gaps would tell more.
  [[nodiscard]] bool is_of_another_session(std::size_t group, std::size_t main) const {
    std::set<std::size_t> sessions;
    for (std::size_t k = 0; k < track_.size(); ++k) {
      if (group_of(k) == main) sessions.insert(session_of(k));
    }
    for (std::size_t k = 0; k < track_.size(); ++k) {
      if (group_of(k) == group && sessions.contains(session_of(k))) return false;
    }
    return true;
  }

  /// How far the way between the places of a joint may be off, by the open stretches in between
  /// (sigma); of the joints the least.
  [[nodiscard]] double open_way_m(const std::vector<Proposal>& joints) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (const Proposal& joint : joints) {
      const auto [from, to] = std::minmax(joint.known, joint.sought);
      double sum_m = 0.0;
      for (std::size_t k = from + 1; k <= to; ++k) sum_m += track_.motions[k].open_sigma_m.trace();
      least_m = std::min(least_m, sum_m);
    }
    return least_m;
  }

  /// The agreement as may_be_twin() asks for it.
  [[nodiscard]] JoiningClaim claim_of(const std::vector<Proposal>& agreed,
                                      std::size_t group,
                                      std::size_t main) const {
    JoiningClaim claim{
        .T_map_piece = agreed.front().T_map_piece, .places = {}, .known = {}, .piece = {}};
    for (const Proposal& proposal : agreed) claim.places.push_back(proposal.sought);
    for (std::size_t k = 0; k < track_.size(); ++k) {
      claim.known.push_back(group_of(k) == main);
      claim.piece.push_back(group_of(k) == group);
    }
    return claim;
  }

  void note_search(std::size_t group, const SessionSearch& search) {
    for (std::size_t piece = 0; piece < groups_.size(); ++piece) {
      if (groups_[piece] == group) joined_.searches[piece] = search;
    }
  }

  /// The median of the turns that the joints give for the tracked headings.
  [[nodiscard]] double tracked_turn_rad(const std::vector<Proposal>& joints) const {
    const auto heading_of = [&](std::size_t keyframe) {
      return joined_.turn_rad[track_.pieces[keyframe]] +
             track_.keyframes[keyframe]->T_odom_sensor.theta_rad;
    };
    const auto turn_by = [&](const Proposal& joint) {
      return heading_of(joint.known) + joint.places.T_from_to.theta_rad - heading_of(joint.sought);
    };
    const double first_rad = turn_by(joints.front());
    std::vector<double> off_rad;
    for (const Proposal& joint : joints) off_rad.push_back(wrap_to_pi(turn_by(joint) - first_rad));
    return wrap_to_pi(first_rad + upper_median(std::move(off_rad)));
  }

  [[nodiscard]] std::vector<Proposal> propose(std::size_t group, std::size_t main) const {
    std::vector<PlaceSignature> known;
    std::vector<std::size_t> known_keyframes;
    for (const Place& place : places_of(main)) {
      known.push_back(place.signature);
      known_keyframes.push_back(place.keyframe);
    }
    const std::vector<Place> sought = places_of(group);
    const std::size_t stride = 1 + (sought.size() - 1) / params_.max_num_queries;  // rounded up
    std::vector<Proposal> proposals;
    for (std::size_t i = 0; i < sought.size(); i += stride) {
      for (const std::size_t k :
           nearest_signatures(sought[i].signature, known, params_.num_similar)) {
        Proposal proposal;
        proposal.known = known_keyframes[k];
        proposal.sought = sought[i].keyframe;
        proposals.push_back(proposal);
      }
    }
    return proposals;
  }

  /// Those of the proposals that are verified. A pair is verified once, however often it is
  /// proposed, and the samples of a scan are drawn once.
  [[nodiscard]] std::vector<Proposal> verified(const std::vector<Proposal>& proposals) {
    std::vector<Proposal> unknown;
    std::ranges::copy_if(proposals, std::back_inserter(unknown), [&](const Proposal& proposal) {
      return !verified_.contains(pair_of(proposal));
    });
    prepare_scans_of(unknown);
    run_in_parallel(
        unknown.size(), num_threads_, [&](std::size_t i) { unknown[i] = verify(unknown[i]); });
    for (const Proposal& proposal : unknown) verified_.emplace(pair_of(proposal), proposal);

    std::vector<Proposal> right;
    for (const Proposal& proposal : proposals) {
      const Proposal& known = verified_.at(pair_of(proposal));
      if (!known.is_verified) continue;
      right.push_back(known);
      right.back().T_map_piece = T_map_sensor_[known.known] * known.places.T_from_to *
                                 T_map_sensor_[known.sought].inverse();
    }
    return right;
  }

  /// Those of the proposals, across a break, whose scans match. `step_reach`: how far the robot
  /// goes from keyframe to keyframe, where steps are long.
  [[nodiscard]] std::vector<Proposal> matched(std::vector<Proposal> proposals,
                                              const std::optional<StepReach>& step_reach) {
    prepare_scans_of(proposals);
    run_in_parallel(proposals.size(), num_threads_, [&](std::size_t i) {
      proposals[i] = compare_scans(proposals[i], step_reach);
    });
    std::erase_if(proposals, [](const Proposal& proposal) { return proposal.weight <= 0.0; });
    return proposals;
  }

  /// Scans of different sessions may be of different buildings, and must show that they are not.
  [[nodiscard]] MatchResult match_of(const Proposal& proposal) const {
    MatchParams params;
    if (session_of(proposal.known) != session_of(proposal.sought)) {
      params.answer.min_place_log_odds = kOnePlaceLogOdds;
    }
    return setsquare::match(prepared_.at(proposal.known), prepared_.at(proposal.sought), params);
  }

  /// With no weight where they do not match.
  [[nodiscard]] Proposal compare_scans(Proposal proposal,
                                       const std::optional<StepReach>& step_reach) const {
    const MatchResult match = match_of(proposal);
    if (!match.T_reference_current) return proposal;
    const Pose2& T_known_sought = *match.T_reference_current;
    proposal.weight = step_reach
                          ? log_odds_across_steps(
                                match, proposal.sought - proposal.known, *step_reach, params_.odds)
                          : vote_weight(match.status);
    proposal.places = matched_places(proposal.known,
                                     proposal.sought,
                                     T_known_sought,
                                     information_of_joint(params_, match.degenerate_direction_rad));
    proposal.places.score = match.score;
    proposal.places.contradiction = match.contradiction;
    proposal.T_map_piece =
        T_map_sensor_[proposal.known] * T_known_sought * T_map_sensor_[proposal.sought].inverse();
    return proposal;
  }

  void prepare_scans_of(const std::vector<Proposal>& proposals) {
    std::vector<std::size_t> unprepared;
    for (const Proposal& proposal : proposals) {
      for (const std::size_t keyframe : {proposal.known, proposal.sought}) {
        if (prepared_.try_emplace(keyframe).second) unprepared.push_back(keyframe);
      }
    }
    run_in_parallel(unprepared.size(), num_threads_, [&](std::size_t i) {
      prepared_.at(unprepared[i]) = prepare(track_.keyframes[unprepared[i]]->surfaces);
    });
  }

  [[nodiscard]] static std::pair<std::size_t, std::size_t> pair_of(const Proposal& proposal) {
    return {proposal.known, proposal.sought};
  }

  [[nodiscard]] Proposal verify(Proposal proposal) const {
    const MatchResult match = match_of(proposal);
    if (match.status != MatchStatus::kMatched) return proposal;

    const auto found =
        match_submaps(make_submap(track_, T_map_sensor_, proposal.known, half_width_),
                      make_submap(track_, T_map_sensor_, proposal.sought, half_width_),
                      {*match.T_reference_current, params_.window_m},
                      closing_.match);
    if (!found) return proposal;
    proposal.places = judged_places(proposal.known,
                                    proposal.sought,
                                    *found,
                                    T_map_sensor_[proposal.known].theta_rad,
                                    closing_.point_sigma_m,
                                    closing_.verdict);
    proposal.is_verified = proposal.places.verdict.reason == ClosureReason::kStandsAlone;
    return proposal;
  }

  /// Whether two proposals give nearly the same places.
  [[nodiscard]] bool agree(const Proposal& a, const Proposal& b) const {
    const double turn_rad = wrap_to_pi(a.T_map_piece.theta_rad - b.T_map_piece.theta_rad);
    if (std::abs(turn_rad) > params_.agreeing_rad) return false;
    const auto disagreement_m = [&](std::size_t keyframe) {
      const Eigen::Vector2d p = T_map_sensor_[keyframe].translation();
      return (a.T_map_piece * p - b.T_map_piece * p).norm();
    };
    return std::max(disagreement_m(a.sought), disagreement_m(b.sought)) < params_.agreeing_m;
  }

  /// Whether the proposal leaves the piece where tracking has it.
  [[nodiscard]] bool is_as_tracked(const Proposal& proposal) const {
    Proposal tracked = proposal;
    tracked.T_map_piece = {};
    return agree(proposal, tracked);
  }

  /// The proposals that agree with the one that has most votes.
  [[nodiscard]] std::vector<Proposal> most_agreed(const std::vector<Proposal>& proposals,
                                                  const Votes& num_votes = &places_in) const {
    std::vector<Proposal> best;
    for (const Proposal& centre : proposals) {
      std::vector<Proposal> agreeing = {centre};
      for (const Proposal& other : proposals) {
        if (&other != &centre && agree(centre, other)) agreeing.push_back(other);
      }
      if (num_votes(agreeing) > num_votes(best)) best = std::move(agreeing);
    }
    return best;
  }

  /// The same; none where it has too few votes, or another place has half as many votes.
  [[nodiscard]] std::vector<Proposal> agreed_alone(const std::vector<Proposal>& proposals,
                                                   const Votes& num_votes,
                                                   double min_votes) const {
    std::vector<Proposal> best = most_agreed(proposals, num_votes);
    if (num_votes(best) < min_votes) return {};
    std::vector<Proposal> others;
    for (const Proposal& proposal : proposals) {
      if (!agree(best.front(), proposal)) others.push_back(proposal);
    }
    if (2.0 * num_votes(most_agreed(others, num_votes)) >= num_votes(best)) return {};
    return best;
  }

  const KeyframeTrack& track_;
  std::vector<Pose2> T_map_sensor_;
  const LoopCloserParams& closing_;
  const PieceJoiningParams& params_;
  std::size_t num_threads_;
  std::size_t half_width_;                  ///< Of submaps, in keyframes.
  std::vector<std::vector<Place>> places_;  ///< By piece.
  std::vector<std::size_t> groups_;         ///< By piece: those of one group hang together.
  std::map<std::pair<std::size_t, std::size_t>, Proposal> verified_;  ///< By known and sought.
  std::map<std::size_t, PreparedScan> prepared_;                      ///< By keyframe.
  JoinedPieces joined_;
};

}  // namespace

JoinedPieces join_pieces(const KeyframeTrack& track,
                         std::span<const Pose2> T_map_sensor,
                         std::span<const AnchoredKeyframe> known,
                         const LoopCloserParams& closing,
                         const PieceJoiningParams& params,
                         std::size_t num_threads) {
  params.validate();
  return PieceJoiner(track, T_map_sensor, known, closing, params, num_threads).join_all();
}

}  // namespace setsquare
