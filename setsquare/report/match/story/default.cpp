// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/drawing/text.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/report/match/story/scan.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/report/match/story/words.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxProposals = 14;
constexpr std::size_t kMaxRotations = 4;
constexpr double kSameRotation_rad = rad_from_deg(8.0);
/// Wide enough for the default matcher's window; a coarser step than the paper's is enough to see.
constexpr ShiftSearch kShifts = {.max_shift_m = 7.0, .step_m = 0.02};

std::string percent_of_wall(double part_m, double wall_m) {
  return wall_m > 0.0 ? joined({fixed(100.0 * part_m / wall_m, 1), " %"}) : "-";
}

std::string fate_in_words(const TracedCandidate& traced, const MatchStory& story) {
  const double behind = story.result.score - traced.candidate.score;
  switch (traced.fate) {
    case CandidateFate::kAnswer:
      return "the answer: the highest score";
    case CandidateFate::kRunnerUp:
      return joined({"runner-up: ", fixed(behind, 3), " behind the answer"});
    case CandidateFate::kOutscored:
      return joined({"outscored by ", fixed(behind, 3)});
    case CandidateFate::kSameAsBetter:
      return "in the basin of a better one";
    case CandidateFate::kDroppedEarly:
      return "dropped on a few samples already";
  }
  return "";
}

StoryProposal told_proposal(const TracedCandidate& traced, const MatchStory& story) {
  const Candidate& candidate = traced.candidate;
  const Evidence& evidence = candidate.evidence;
  return {candidate.T_reference_current,
          {std::to_string(candidate.correlation),
           percent_of_wall(evidence.agreeing_m, evidence.wall_m),
           percent_of_wall(evidence.contradicted_m, evidence.wall_m),
           percent_of_wall(evidence.hidden_m, evidence.wall_m),
           fixed(candidate.score, 3)},
          fate_in_words(traced, story)};
}

/// The best proposals: first the fully refined ones, then, by score, those dropped early.
void tell_proposals(const MatchTrace& trace, MatchStory& story) {
  std::size_t num_repeated = 0;
  std::size_t num_left_out = 0;
  for (const TracedCandidate& traced : trace.candidates) {
    if (traced.fate == CandidateFate::kSameAsBetter) {
      ++num_repeated;
    } else if (story.proposals.size() < kMaxProposals) {
      story.proposals.push_back(told_proposal(traced, story));
    } else {
      ++num_left_out;
    }
  }
  const std::string effort =
      trace.was_thorough
          ? "The walls' directions left doubt, so every rotation of the circle was tried."
          : joined({"Tried: the ",
                    std::to_string(trace.rotations.size()),
                    " rotations at which the walls face the same ways."});
  story.remark = joined({effort,
                         " Not listed: ",
                         std::to_string(num_repeated),
                         " proposals in the basin of a better one, ",
                         std::to_string(num_left_out),
                         " that lost by more."});
}

/// Correlation curves at the answer's rotation and at the best clearly different ones.
void tell_rotations(MatchStory& story) {
  for (const StoryProposal& proposal : story.proposals) {
    if (story.rotations.size() == kMaxRotations) return;
    const bool is_new =
        std::none_of(story.rotations.begin(), story.rotations.end(), [&](const auto& known) {
          const double turn_rad = proposal.T_reference_current.theta_rad - known.rotation_rad;
          return std::abs(wrap_to_pi(turn_rad)) < kSameRotation_rad;
        });
    if (!is_new) continue;
    const Pose2& pose = proposal.T_reference_current;
    story.rotations.push_back(story_rotation(story.reference, story.current, pose, kShifts));
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
  story.reference = story_scan(reference, {});
  story.current = story_scan(current, {});
  story.shifts = kShifts;
  MatchTrace trace;
  story.result = match(prepare(reference, params.surface, params.samples),
                       prepare(current, params.surface, params.samples),
                       params,
                       &trace);
  story.evidence = evidence_in_words(story.result, params);
  story.measure_names = {"correlation", "agreeing", "contradicted", "hidden", "score"};
  tell_proposals(trace, story);
  if (story.result.T_reference_current && !story.proposals.empty()) {
    story.proposals.front().T_reference_current = *story.result.T_reference_current;
  }
  tell_rotations(story);
  return story;
}

}  // namespace setsquare
