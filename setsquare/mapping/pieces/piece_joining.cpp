// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/piece_joining.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "setsquare/core/median.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/mapping/pieces/place_signature.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {
namespace {

/// A keyframe that stands for its surroundings.
struct Place {
  std::size_t keyframe = 0;
  PlaceSignature signature;
};

/// Two places that may be the same and, where they are, how.
struct Proposal {
  std::size_t known = 0;   ///< Keyframe of a joined piece.
  std::size_t sought = 0;  ///< Keyframe of the piece that is sought.
  bool is_verified = false;
  Pose2 T_map_piece;  ///< How the whole piece would move.
  ComparedPlaces places;
};

class PieceJoiner {
 public:
  PieceJoiner(const KeyframeTrack& track,
              std::span<const Pose2> T_map_sensor,
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
    joined_.turn_rad.assign(num_pieces, 0.0);
    joined_.is_joined.assign(num_pieces, false);
    const std::size_t spacing = closing.station_spacing * track.num_scanners();
    for (std::size_t k = 0; k < track.size(); k += spacing) add_place(k);
  }

  JoinedPieces join_all() {
    if (places_.empty()) return joined_;
    const auto largest =
        std::max_element(places_.begin(), places_.end(), [](const auto& a, const auto& b) {
          return a.size() < b.size();
        });
    joined_.is_joined[static_cast<std::size_t>(largest - places_.begin())] = true;
    // A piece that finds no place may find one when others have been joined.
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t piece = 0; piece < places_.size(); ++piece) {
        if (!joined_.is_joined[piece] && join(piece)) has_grown = true;
      }
    }
    return joined_;
  }

 private:
  void add_place(std::size_t keyframe) {
    const Submap submap = make_submap(track_, T_map_sensor_, keyframe, half_width_);
    places_[track_.pieces[keyframe]].push_back(
        {keyframe, place_signature(submap.fine, T_map_sensor_[keyframe].theta_rad)});
  }

  bool join(std::size_t piece) {
    if (places_[piece].size() < params_.min_agreeing) return false;
    const std::vector<Proposal> agreed = most_agreed(verified(propose(piece)));
    if (agreed.empty()) return false;
    joined_.is_joined[piece] = true;
    joined_.turn_rad[piece] = tracked_turn_rad(agreed);
    for (const Proposal& proposal : agreed) joined_.joints.push_back(proposal.places);
    for (std::size_t k = 0; k < track_.size(); ++k) {
      if (track_.pieces[k] != piece) continue;
      T_map_sensor_[k] = agreed.front().T_map_piece * T_map_sensor_[k];
    }
    return true;
  }

  /// The median of the turns that the joints give for the piece's tracked headings.
  [[nodiscard]] double tracked_turn_rad(const std::vector<Proposal>& joints) const {
    const auto turn_by = [&](const Proposal& joint) {
      return joined_.turn_rad[track_.pieces[joint.known]] +
             track_.keyframes[joint.known]->T_odom_sensor.theta_rad +
             joint.places.T_from_to.theta_rad -
             track_.keyframes[joint.sought]->T_odom_sensor.theta_rad;
    };
    const double first_rad = turn_by(joints.front());
    std::vector<double> off_rad;
    for (const Proposal& joint : joints) off_rad.push_back(wrap_to_pi(turn_by(joint) - first_rad));
    return wrap_to_pi(first_rad + upper_median(std::move(off_rad)));
  }

  [[nodiscard]] std::vector<Proposal> propose(std::size_t piece) const {
    std::vector<PlaceSignature> known;
    std::vector<std::size_t> known_keyframes;
    for (std::size_t other = 0; other < places_.size(); ++other) {
      if (!joined_.is_joined[other]) continue;
      for (const Place& place : places_[other]) {
        known.push_back(place.signature);
        known_keyframes.push_back(place.keyframe);
      }
    }
    const std::vector<Place>& sought = places_[piece];
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
    std::vector<std::size_t> unprepared;
    for (const Proposal& proposal : proposals) {
      if (verified_.contains(pair_of(proposal))) continue;
      unknown.push_back(proposal);
      for (const std::size_t keyframe : {proposal.known, proposal.sought}) {
        if (prepared_.try_emplace(keyframe).second) unprepared.push_back(keyframe);
      }
    }
    run_in_parallel(unprepared.size(), num_threads_, [&](std::size_t i) {
      prepared_.at(unprepared[i]) = prepare(track_.keyframes[unprepared[i]]->surfaces);
    });
    run_in_parallel(
        unknown.size(), num_threads_, [&](std::size_t i) { unknown[i] = verify(unknown[i]); });
    for (const Proposal& proposal : unknown) verified_.emplace(pair_of(proposal), proposal);

    std::vector<Proposal> right;
    for (const Proposal& proposal : proposals) {
      const Proposal& known = verified_.at(pair_of(proposal));
      if (known.is_verified) right.push_back(known);
    }
    return right;
  }

  [[nodiscard]] static std::pair<std::size_t, std::size_t> pair_of(const Proposal& proposal) {
    return {proposal.known, proposal.sought};
  }

  [[nodiscard]] Proposal verify(Proposal proposal) const {
    const MatchResult match =
        setsquare::match(prepared_.at(proposal.known), prepared_.at(proposal.sought));
    if (match.status != MatchStatus::kMatched) return proposal;

    const auto found =
        match_submaps(make_submap(track_, T_map_sensor_, proposal.known, half_width_),
                      make_submap(track_, T_map_sensor_, proposal.sought, half_width_),
                      {*match.T_reference_current, params_.window_m},
                      closing_.match);
    if (!found) return proposal;
    const Pose2& T_map_known = T_map_sensor_[proposal.known];
    proposal.places = judged_places(proposal.known,
                                    proposal.sought,
                                    *found,
                                    T_map_known.theta_rad,
                                    closing_.point_sigma_m,
                                    closing_.verdict);
    proposal.is_verified = proposal.places.verdict.reason == ClosureReason::kStandsAlone;
    proposal.T_map_piece =
        T_map_known * proposal.places.T_from_to * T_map_sensor_[proposal.sought].inverse();
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

  /// The proposals that agree with the one that has most votes of places; none where it has too few
  /// votes, or another place has half as many votes.
  [[nodiscard]] std::vector<Proposal> most_agreed(const std::vector<Proposal>& proposals) const {
    const auto num_places = [](const std::vector<Proposal>& list) {
      std::set<std::size_t> places;
      for (const Proposal& proposal : list) places.insert(proposal.sought);
      return places.size();
    };
    std::vector<Proposal> best;
    for (const Proposal& centre : proposals) {
      std::vector<Proposal> agreeing = {centre};
      for (const Proposal& other : proposals) {
        if (&other != &centre && agree(centre, other)) agreeing.push_back(other);
      }
      if (num_places(agreeing) > num_places(best)) best = std::move(agreeing);
    }
    if (num_places(best) < params_.min_agreeing) return {};
    std::vector<Proposal> others;
    for (const Proposal& proposal : proposals) {
      if (!agree(best.front(), proposal)) others.push_back(proposal);
    }
    for (const Proposal& centre : others) {
      std::vector<Proposal> rivals;
      for (const Proposal& other : others) {
        if (agree(centre, other)) rivals.push_back(other);
      }
      if (2 * num_places(rivals) >= num_places(best)) return {};
    }
    return best;
  }

  const KeyframeTrack& track_;
  std::vector<Pose2> T_map_sensor_;
  const LoopCloserParams& closing_;
  const PieceJoiningParams& params_;
  std::size_t num_threads_;
  std::size_t half_width_;                                            ///< Of submaps, in keyframes.
  std::vector<std::vector<Place>> places_;                            ///< By piece.
  std::map<std::pair<std::size_t, std::size_t>, Proposal> verified_;  ///< By known and sought.
  std::map<std::size_t, PreparedScan> prepared_;                      ///< By keyframe.
  JoinedPieces joined_;
};

}  // namespace

void PieceJoiningParams::validate() const {
  require_at_least_one(max_num_queries, "joining.max_num_queries");
  require_at_least_one(num_similar, "joining.num_similar");
  require_positive(window_m, "joining.window_m");
  require_at_least_one(min_agreeing, "joining.min_agreeing");
  require_positive(agreeing_m, "joining.agreeing_m");
  require_positive(agreeing_rad, "joining.agreeing_rad");
}

JoinedPieces join_pieces(const KeyframeTrack& track,
                         std::span<const Pose2> T_map_sensor,
                         const LoopCloserParams& closing,
                         const PieceJoiningParams& params,
                         std::size_t num_threads) {
  params.validate();
  return PieceJoiner(track, T_map_sensor, closing, params, num_threads).join_all();
}

}  // namespace setsquare
