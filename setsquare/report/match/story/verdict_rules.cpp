// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/story/verdict_rules.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/story/words.hpp"

namespace setsquare {
namespace {

VerdictRule at_least(
    const char* name, double found, double asked, int num_decimals, const char* unit) {
  return {.name = name,
          .asked = fmt::format("at least {}{}", fixed(asked, num_decimals), unit),
          .found = fmt::format("{}{}", fixed(found, num_decimals), unit),
          .holds = found >= asked};
}

/// What must be true before there is a pose to judge.
VerdictRule rule_of_points(std::size_t num_points, const AnswerParams& params) {
  return {.name = "Returns on surfaces in either scan",
          .asked = fmt::format("at least {}", params.min_points),
          .found = std::to_string(num_points),
          .holds = num_points >= params.min_points,
          .otherwise = MatchStatus::kTooFewPoints};
}

VerdictRule rule_of_agreement(const Candidate& best, const AnswerParams& params) {
  const Evidence& evidence = best.evidence;
  const double share = evidence.wall_m > 0.0 ? evidence.agreeing_m / evidence.wall_m : 0.0;
  VerdictRule rule = at_least(
      "Wall on which the scans agree", 100.0 * share, 100.0 * params.min_agreement, 1, " %");
  rule.holds = evidence.agreeing_m >= params.min_agreement * evidence.wall_m;
  rule.otherwise = MatchStatus::kNoOverlap;
  return rule;
}

/// Whether the walls hold the pose.
void add_rules_of_constraint(const WallConstraint& constraint,
                             const AnswerParams& params,
                             std::vector<VerdictRule>& rules) {
  rules.push_back(at_least("Wall that holds the open direction",
                           constraint.open_direction_m,
                           params.min_constraint_m,
                           2,
                           " m"));
  rules.back().otherwise = MatchStatus::kDegenerate;
  rules.push_back(at_least("Wall times squared lever arm that holds the rotation",
                           constraint.turning_m3,
                           params.min_turning_m3,
                           2,
                           " m^3"));
  rules.back().otherwise = MatchStatus::kDegenerate;
}

/// Whether the answer is probable enough; what the rules of the score must add.
VerdictRule rule_of_probability(const MatchResult& result, const AnswerParams& params) {
  return {.name = "Probability that the answer is right",
          .asked = fmt::format("at least {}, or {} and the rules of score, margin and lines",
                               fixed(params.min_probability, 5),
                               fixed(params.min_probability_by_rules, 3)),
          .found = fixed(result.probability, 5),
          .holds = result.probability >= params.min_probability_by_rules};
}

/// An answer that is probable enough needs no rule of the score.
VerdictRule unless_probable(VerdictRule rule,
                            const MatchResult& result,
                            const AnswerParams& params) {
  if (rule.holds || !(result.probability >= params.min_probability)) return rule;
  rule.holds = true;
  rule.found += " (not needed: the probability suffices)";
  return rule;
}

/// Whether score and margin speak for the answer alone.
void add_rules_of_score(const MatchResult& result,
                        const TracedVerdict& verdict,
                        const AnswerParams& params,
                        std::vector<VerdictRule>& rules) {
  const double score = result.score;
  const double runner_up_score = result.runner_up ? result.runner_up->score : 0.0;
  const double margin = score_margin(score, runner_up_score, params);
  const double all_m = verdict.constraint.all_m;
  const auto add = [&](VerdictRule rule) {
    rules.push_back(unless_probable(std::move(rule), result, params));
  };
  add({.name = "Wall that holds a low score",
       .asked = fmt::format("a score of {} or {} m of wall",
                            fixed(params.low_score, 2),
                            fixed(params.min_wall_m, 1)),
       .found = fmt::format("{} and {} m", fixed(score, 3), fixed(all_m, 1)),
       .holds = score >= params.low_score || all_m >= params.min_wall_m});
  add(at_least("Margin above the runner-up, by what one scan contradicts",
               margin,
               params.margin_per_contradiction * one_way_share(verdict.two_way),
               3,
               ""));
  add({.name = "Score, and margin above the runner-up",
       .asked = fmt::format("{} and {}, or {} and {}",
                            fixed(params.min_score, 2),
                            fixed(params.min_margin, 2),
                            fixed(params.min_score_alone, 2),
                            fixed(params.min_margin_alone, 2)),
       .found = fmt::format("{} and {}", fixed(score, 3), fixed(margin, 3)),
       .holds = (score >= params.min_score && margin >= params.min_margin) ||
                (score >= params.min_score_alone && margin >= params.min_margin_alone)});
  add(at_least("Agreeing wall on different lines",
               verdict.distinct_wall_m,
               verdict.min_distinct_m,
               2,
               " m"));
}

/// Whether the scans show one place at all, where that was asked.
void add_rule_of_place(const TracedVerdict& verdict,
                       const AnswerParams& params,
                       std::vector<VerdictRule>& rules) {
  if (!verdict.place_log_odds) return;
  rules.push_back(at_least("Log odds that both scans show one place",
                           *verdict.place_log_odds,
                           params.min_place_log_odds,
                           1,
                           ""));
}

/// The different pose with the most agreeing wall among those that are contradicted as little.
VerdictRule rule_of_rivals(const MatchTrace& trace, const AnswerParams& params) {
  const Candidate& best = trace.candidates.front().candidate;
  const double max_share = contradicted_share(best.evidence) + params.rival_contradiction;
  const double max_m = best.evidence.contradicted_m + params.rival_contradiction_m;
  double rival_m = 0.0;
  for (const TracedCandidate& traced : trace.candidates) {
    const Candidate& other = traced.candidate;
    const bool is_judged =
        traced.fate == CandidateFate::kRunnerUp || traced.fate == CandidateFate::kOutscored;
    if (!is_judged || are_same(best.T_reference_current, other.T_reference_current, params) ||
        other.evidence.contradicted_m > max_m || contradicted_share(other.evidence) > max_share) {
      continue;
    }
    rival_m = std::max(rival_m, other.evidence.agreeing_m);
  }
  const double asked_m = params.rival_agreement * best.evidence.agreeing_m;
  return {.name = "Most agreeing wall of a different pose that is contradicted as little",
          .asked = fmt::format("less than {} m", fixed(asked_m, 2)),
          .found = rival_m > 0.0 ? fixed(rival_m, 2) + " m" : "no such pose",
          .holds = !(rival_m >= asked_m) || rival_m == 0.0};
}

}  // namespace

std::vector<VerdictRule> verdict_rules(const MatchResult& result,
                                       const MatchTrace& trace,
                                       std::size_t num_points,
                                       const AnswerParams& params) {
  std::vector<VerdictRule> rules = {rule_of_points(num_points, params)};
  if (!rules.front().holds) return rules;
  rules.push_back({.name = "Proposals of the correlation",
                   .asked = "at least 1",
                   .found = std::to_string(trace.candidates.size()),
                   .holds = trace.verdict.has_value(),
                   .otherwise = MatchStatus::kNoOverlap});
  if (!trace.verdict) return rules;
  rules.push_back(rule_of_agreement(trace.candidates.front().candidate, params));
  add_rules_of_constraint(trace.verdict->constraint, params, rules);
  rules.push_back(rule_of_probability(result, params));
  add_rules_of_score(result, *trace.verdict, params, rules);
  rules.push_back(rule_of_rivals(trace, params));
  rules.push_back({.name = "Motions under which the place looks the same",
                   .asked = "none",
                   .found = std::to_string(trace.verdict->aliases.size()),
                   .holds = trace.verdict->aliases.empty()});
  add_rule_of_place(*trace.verdict, params, rules);
  return rules;
}

MatchStatus status_of_rules(const std::vector<VerdictRule>& rules) {
  const auto failed =
      std::find_if(rules.begin(), rules.end(), [](const VerdictRule& rule) { return !rule.holds; });
  return failed == rules.end() ? MatchStatus::kMatched : failed->otherwise;
}

}  // namespace setsquare
