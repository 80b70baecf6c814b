// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/agreed_place.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/matching/probability.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/tracking/known_place.hpp"

namespace setsquare {
namespace {

constexpr double kAloneWeight = 1.0;
constexpr double kAmbiguousWeight = 0.5;

/// Whether two matches that stand alone are one place: others would not change that.
bool has_two_alike(std::span<const PlaceVote> votes, const PlaceVoteParams& params) {
  const auto is_alone = [](const PlaceVote& vote) { return vote.status == MatchStatus::kMatched; };
  return votes.size() == 2 && is_alone(votes[0]) && is_alone(votes[1]) &&
         is_same_place(votes[0].T_odom_sensor, votes[1].T_odom_sensor, params);
}

/// The probability of a place by the surest match that has the scan there: matches with keyframes
/// of one room err alike.
double probability_of(const Pose2& T_odom_sensor,
                      std::span<const PlaceVote> votes,
                      const ExpectedStep& step,
                      const PlaceVoteParams& params) {
  double surest = 0.0;
  for (const PlaceVote& vote : votes) {
    const bool is_there = is_same_place(T_odom_sensor, vote.T_odom_sensor, params);
    if (is_there) surest = std::max(surest, vote.probability);
  }
  const double against = odds_against(step, T_odom_sensor, params.odds);
  return 1.0 / (1.0 + std::exp(-log_odds_of_place(surest, against, params.odds)));
}

}  // namespace

bool is_within(const ExpectedStep& step, const Pose2& T_odom_sensor) {
  const Pose2 off = step.T_odom_sensor.inverse() * T_odom_sensor;
  return !is_beyond(off, step.reach.distance_m, step.reach.turn_rad);
}

std::optional<StepReach> departure_from(const ExpectedStep& step, const Pose2& T_odom_sensor) {
  const bool has_odometry = step.by != ExpectedStep::By::kLastMotion;
  if (!has_odometry || is_within(step, T_odom_sensor)) return std::nullopt;
  return reach_of(step.T_odom_sensor.inverse() * T_odom_sensor);
}

bool is_refuted(const AgreedPlace& place,
                const ExpectedStep& step,
                bool fits_as_driven,
                const PlaceVoteParams& params) {
  using By = ExpectedStep::By;
  if (step.by == By::kLastMotion || is_within(step, place.T_odom_sensor)) return false;
  const bool is_seconded = place.votes >= params.min_votes_for_jump;
  return step.by == By::kProvedOdometry ? fits_as_driven || !is_seconded
                                        : fits_as_driven && !is_seconded;
}

double vote_weight(MatchStatus status) {
  if (status == MatchStatus::kMatched) return kAloneWeight;
  return status == MatchStatus::kAmbiguous ? kAmbiguousWeight : 0.0;
}

bool is_same_place(const Pose2& a, const Pose2& b, const PlaceVoteParams& params) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) < params.same_m &&
         std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)) < params.same_rad;
}

std::vector<PlaceVote> place_votes(PreparedKeyframes& keyframes,
                                   const PreparedScan& current,
                                   const PlaceVoteParams& params) {
  const MatchParams match_params = params_of_a_known_place();
  std::vector<PlaceVote> votes;
  const std::size_t num_asked = std::min(params.num_keyframes, keyframes.size());
  for (std::size_t age = 0; age < num_asked && !has_two_alike(votes, params); ++age) {
    const MatchResult match = setsquare::match(keyframes.scan(age), current, match_params);
    if (!match.T_reference_current) continue;
    const Pose2& T_odom_keyframe = keyframes.keyframe(age).T_odom_sensor;
    votes.push_back({.T_odom_sensor = T_odom_keyframe * *match.T_reference_current,
                     .status = match.status,
                     .probability = match.probability});
    if (match.degenerate_direction_rad) {
      votes.back().open_direction_rad = T_odom_keyframe.theta_rad + *match.degenerate_direction_rad;
    }
  }
  return votes;
}

std::optional<AgreedPlace> agreed_place(std::span<const PlaceVote> votes,
                                        const std::optional<ExpectedStep>& step,
                                        const PlaceVoteParams& params) {
  const auto votes_for = [&](const Pose2& place) {
    double sum = step && is_within(*step, place) ? kAmbiguousWeight : 0.0;
    for (const PlaceVote& vote : votes) {
      if (is_same_place(place, vote.T_odom_sensor, params)) {
        sum += vote_weight(vote.status);
      }
    }
    return sum;
  };
  const auto stands_alone = [&](const Pose2& place) {
    return std::ranges::any_of(votes, [&](const PlaceVote& vote) {
      return vote.status == MatchStatus::kMatched &&
             is_same_place(place, vote.T_odom_sensor, params);
    });
  };
  std::optional<AgreedPlace> best;
  for (const PlaceVote& vote : votes) {
    if (vote_weight(vote.status) == 0.0) continue;
    const AgreedPlace place{vote.T_odom_sensor, votes_for(vote.T_odom_sensor)};
    const bool is_jump = step && !is_within(*step, place.T_odom_sensor);
    const bool is_by_motion = step && step->by == ExpectedStep::By::kLastMotion;
    if (is_jump && !stands_alone(place.T_odom_sensor)) continue;
    const bool is_seconded =
        is_by_motion
            ? probability_of(vote.T_odom_sensor, votes, *step, params) >= params.min_probability
            : !is_jump || place.votes >= params.min_votes_for_jump;
    if (!is_seconded) continue;
    if (!best || place.votes > best->votes) best = place;
  }
  if (!best || best->votes < kAloneWeight) return std::nullopt;
  const bool has_rival = std::any_of(votes.begin(), votes.end(), [&](const PlaceVote& vote) {
    return vote_weight(vote.status) > 0.0 &&
           !is_same_place(vote.T_odom_sensor, best->T_odom_sensor, params) &&
           votes_for(vote.T_odom_sensor) >= best->votes;
  });
  return has_rival ? std::nullopt : best;
}

double odds_against(const ExpectedStep& step,
                    const Pose2& T_odom_sensor,
                    const StepOddsParams& params) {
  const StepReach off = reach_of(step.T_odom_sensor.inverse() * T_odom_sensor);
  const double num_reaches =
      std::max(off.distance_m / step.reach.distance_m, off.turn_rad / step.reach.turn_rad);
  if (num_reaches > 1.0) return std::pow(10.0, params.decades_per_reach * (num_reaches - 1.0));
  const double share_of_way = std::min(1.0, step.reach.distance_m / kProbabilityWithin_m);
  const double share_of_turn = std::min(1.0, step.reach.turn_rad / kPi);
  return share_of_way * share_of_way * share_of_turn;
}

double log_odds_of_place(double probability, double odds_against, const StepOddsParams& params) {
  const double wrong = std::clamp(1.0 - probability, params.least_wrong, 1.0 - params.least_wrong);
  return std::log((1.0 - wrong) / (wrong * odds_against));
}

std::optional<ProbablePlace> probable_place(std::span<const PlaceVote> votes,
                                            const ExpectedStep& step,
                                            const PlaceVoteParams& params) {
  std::optional<ProbablePlace> best;
  for (const PlaceVote& vote : votes) {
    const double probability = probability_of(vote.T_odom_sensor, votes, step, params);
    const bool is_likely =
        vote.status != MatchStatus::kNoOverlap && probability >= params.min_probability;
    if (!is_likely || (best && probability <= best->probability)) continue;
    best = ProbablePlace{.T_odom_sensor = vote.T_odom_sensor,
                         .probability = probability,
                         .is_open = true,
                         .open_direction_rad = vote.open_direction_rad};
  }
  if (!best) return std::nullopt;
  for (const PlaceVote& vote : votes) {
    if (is_same_place(best->T_odom_sensor, vote.T_odom_sensor, params)) {
      best->is_open = best->is_open && vote_weight(vote.status) == 0.0;
    } else if (probability_of(vote.T_odom_sensor, votes, step, params) >= params.min_probability) {
      return std::nullopt;
    }
  }
  return best;
}

}  // namespace setsquare
