// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

#include "setsquare/drawing/text.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/report/match/story/verdict_rules.hpp"
#include "setsquare/report/match/story/words.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxProposals = 14;

std::string share_of_wall(double part_m, double wall_m) {
  return wall_m > 0.0 ? words_of_share(part_m / wall_m) : "-";
}

std::string fate_in_words(const TracedCandidate& traced, const MatchResult& result) {
  const double behind = result.score - traced.candidate.score;
  switch (traced.fate) {
    case CandidateFate::kAnswer:
      return "the answer: the highest score";
    case CandidateFate::kRunnerUp:
      return fmt::format("runner-up: {} behind the answer", fixed(behind, 3));
    case CandidateFate::kOutscored:
      return fmt::format("outscored by {}", fixed(behind, 3));
    case CandidateFate::kSameAsBetter:
      return "in the basin of a better one";
    case CandidateFate::kDroppedEarly:
      return "dropped by the coarse samples";
  }
  return "";
}

StoryProposal proposal_of(const TracedCandidate& traced, const MatchResult& result) {
  const Candidate& candidate = traced.candidate;
  const Evidence& evidence = candidate.evidence;
  return {candidate.T_reference_current,
          {std::to_string(candidate.correlation),
           share_of_wall(evidence.agreeing_m, evidence.wall_m),
           share_of_wall(evidence.contradicted_m, evidence.wall_m),
           share_of_wall(evidence.hidden_m, evidence.wall_m),
           share_of_wall(evidence.outside_m, evidence.wall_m),
           fixed(candidate.score, 3)},
          fate_in_words(traced, result)};
}

/// The best proposals: first those scored with the fine samples, then, by score, those that the
/// coarse samples dropped.
void add_proposals(const MatchTrace& trace, MatchStory& story) {
  std::size_t num_repeated = 0;
  std::size_t num_left_out = 0;
  for (const TracedCandidate& traced : trace.candidates) {
    if (traced.fate == CandidateFate::kSameAsBetter) {
      ++num_repeated;
    } else if (story.proposals.size() < kMaxProposals) {
      story.proposals.push_back(proposal_of(traced, story.result));
    } else {
      ++num_left_out;
    }
  }
  story.remark = fmt::format(
      "Shares of the compared wall; of those dropped by the coarse samples, else by the fine ones. "
      "Not "
      "listed: {} in the basin of a better one, {} that scored less.",
      num_repeated,
      num_left_out);
  if (story.proposals.empty()) return;
  story.T_proposed = trace.candidates.front().candidate.T_proposed;
  if (story.result.T_reference_current) {
    story.proposals.front().T_reference_current = *story.result.T_reference_current;
  }
}

}  // namespace

MatchStory tell_default_match(const Scan& reference,
                              const Scan& current,
                              const StoryNames& names,
                              const MatchParams& params) {
  params.validate();
  MatchStory story;
  story.names = names;
  story.preset = "default";
  story.reference = {reference, points_from_scan(reference)};
  story.current = {current, points_from_scan(current)};
  SurfaceEvidence looked_at = {.reference = prepare(reference, params.surface, params.samples),
                               .current = prepare(current, params.surface, params.samples),
                               .params = params,
                               .trace = {},
                               .rules = {}};
  story.result = match(looked_at.reference, looked_at.current, params, &looked_at.trace);
  const std::size_t num_points =
      std::min(looked_at.reference.points().size(), looked_at.current.points().size());
  looked_at.rules = verdict_rules(story.result, looked_at.trace, num_points, params.answer);
  story.evidence = evidence_in_words(story.result, looked_at.rules);
  story.measure_names = {"correlation", "agreeing", "contradicted", "hidden", "outside", "score"};
  add_proposals(looked_at.trace, story);
  story.looked_at = std::move(looked_at);
  return story;
}

}  // namespace setsquare
