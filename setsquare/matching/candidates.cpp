// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/sort_by.hpp"
#include "setsquare/matching/keep_best.hpp"
#include "setsquare/matching/trace.hpp"

namespace setsquare {
namespace {

std::vector<TranslationProposal> propose(const PreparedScan& current,
                                         const CorrelationGrid& grid,
                                         std::span<const RotationProposal> rotations,
                                         const SearchParams& search,
                                         const MotionBounds& bounds) {
  std::vector<TranslationProposal> proposals;
  int min_correlation = search.min_correlation;
  for (const RotationProposal& rotation : rotations) {
    const Pose2 middle{0.0, 0.0, rotation.rotation_rad};
    if (!bounds.may_hold(middle)) continue;
    grid.propose_translations(current.coarse, middle, min_correlation, proposals);
    if (std::isfinite(bounds.max_translation_m)) {
      std::erase_if(proposals, [&](const TranslationProposal& proposal) {
        return !bounds.may_hold(proposal.T_reference_current);
      });
    }
    min_correlation = std::max(min_correlation, keep_best(search.num_coarse, proposals));
  }
  return proposals;
}

Candidate candidate_from(const TranslationProposal& proposal) {
  return {.T_proposed = proposal.T_reference_current,
          .correlation = proposal.correlation,
          .T_reference_current = proposal.T_reference_current};
}

Candidate refined(const AlignedScan& reference,
                  const AlignedScan& current,
                  std::span<const double> tolerances_m,
                  const ScoreParams& params,
                  Candidate candidate) {
  candidate.T_reference_current =
      refine(reference, current, candidate.T_reference_current, tolerances_m);
  candidate.evidence =
      align(reference, current, candidate.T_reference_current, params.tolerance_m).evidence;
  candidate.score = score(candidate.evidence, params);
  return candidate;
}

void sort_best_first(std::vector<Candidate>& candidates) {
  sort_by_greatest(candidates, &Candidate::score);
}

bool is_new(const Candidate& candidate,
            const std::vector<Candidate>& kept,
            const AnswerParams& params) {
  return std::none_of(kept.begin(), kept.end(), [&](const Candidate& other) {
    return are_same(candidate.T_reference_current, other.T_reference_current, params);
  });
}

void record(const std::vector<Candidate>& dropped,
            CandidateFate fate,
            std::vector<TracedCandidate>& trace) {
  for (const Candidate& candidate : dropped) trace.push_back({candidate, fate});
}

}  // namespace

double score(const Evidence& evidence, const ScoreParams& params) {
  const double compared_m = evidence.wall_m - params.outside_discount * evidence.outside_m;
  if (!(compared_m > 0.0)) return 0.0;
  const double contradiction = evidence.contradicted_m / compared_m;
  return (evidence.agreeing_m - params.hidden_weight * evidence.hidden_m) / compared_m -
         params.contradiction_weight * std::log1p(contradiction / params.usual_contradiction);
}

bool are_same(const Pose2& a, const Pose2& b, const AnswerParams& params) {
  const double dx_m = a.x_m - b.x_m;
  const double dy_m = a.y_m - b.y_m;
  return dx_m * dx_m + dy_m * dy_m < params.same_translation_m * params.same_translation_m &&
         std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)) < params.same_rotation_rad;
}

std::vector<Candidate> search_candidates(const PreparedScan& reference,
                                         const PreparedScan& current,
                                         const CorrelationGrid& grid,
                                         std::span<const RotationProposal> rotations,
                                         const SearchParams& search,
                                         const MatchParams& params,
                                         MatchTrace* trace) {
  std::vector<Candidate> coarse;
  for (const auto& proposal : propose(current, grid, rotations, search, params.bounds)) {
    const Candidate candidate = refined(reference.coarse_alignment(),
                                        current.coarse_alignment(),
                                        params.refinement.coarse_tolerances_m,
                                        params.score,
                                        candidate_from(proposal));
    if (params.bounds.may_hold(candidate.T_reference_current)) coarse.push_back(candidate);
  }
  sort_best_first(coarse);

  std::vector<Candidate> fine;
  std::vector<Candidate> repeated;
  std::vector<Candidate> dropped;
  for (const Candidate& candidate : coarse) {
    if (fine.size() == search.num_fine) {
      dropped.push_back(candidate);
    } else if (is_new(candidate, fine, params.answer)) {
      fine.push_back(candidate);
    } else {
      repeated.push_back(candidate);
    }
  }
  for (Candidate& candidate : fine) {
    candidate = refined(reference.fine_alignment(),
                        current.fine_alignment(),
                        params.refinement.fine_tolerances_m,
                        params.score,
                        candidate);
  }
  // Refinement may lead out of the bounds, to a place that is known not to be the answer.
  std::erase_if(fine, [&](const Candidate& candidate) {
    return !params.bounds.may_hold(candidate.T_reference_current);
  });
  sort_best_first(fine);
  if (trace == nullptr) return fine;
  trace->candidates.clear();
  record(fine, CandidateFate::kOutscored, trace->candidates);
  record(repeated, CandidateFate::kSameAsBetter, trace->candidates);
  record(dropped, CandidateFate::kDroppedEarly, trace->candidates);
  return fine;
}

}  // namespace setsquare
