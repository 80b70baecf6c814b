// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/scan_matcher.hpp"

#include <algorithm>
#include <vector>

#include "setsquare/matching/answer.hpp"
#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {
namespace {

/// The whole circle in equal steps.
std::vector<RotationProposal> all_rotations(std::size_t count) {
  std::vector<RotationProposal> rotations(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    rotations[i].rotation_rad = wrap_to_pi(share * kTwoPi);
  }
  return rotations;
}

void name_fates(const MatchResult& result, MatchTrace& trace) {
  for (std::size_t i = 0; i < trace.candidates.size(); ++i) {
    TracedCandidate& traced = trace.candidates[i];
    if (i == 0) {
      traced.fate = CandidateFate::kAnswer;
    } else if (result.runner_up &&
               traced.candidate.T_reference_current == result.runner_up->T_reference_current) {
      traced.fate = CandidateFate::kRunnerUp;
    }
  }
}

}  // namespace

MatchResult match(const PreparedScan& reference,
                  const PreparedScan& current,
                  const MatchParams& params,
                  MatchTrace* trace) {
  if (trace != nullptr) *trace = {};
  if (std::min(reference.points().size(), current.points().size()) < params.answer.min_points) {
    return {.status = MatchStatus::kTooFewPoints};
  }

  const CorrelationGrid grid(reference.points(), reference.image());
  const auto rotations =
      propose_rotations(reference.histogram, current.histogram, params.quick.num_rotations);
  const auto search = [&](std::span<const RotationProposal> tried, const SearchParams& effort) {
    if (trace != nullptr) trace->verdict.reset();
    return search_candidates(reference, current, grid, tried, effort, params, trace);
  };
  MatchParams at_once = params;
  at_once.answer.min_distinct_m = params.answer.clear_distinct_m;
  MatchResult result = answer(reference, current, search(rotations, params.quick), at_once, trace);
  const bool is_thorough = result.status != MatchStatus::kMatched;
  if (is_thorough) {
    const auto circle = all_rotations(params.thorough.num_rotations);
    result = answer(reference, current, search(circle, params.thorough), params, trace);
  }
  if (trace != nullptr) {
    trace->rotations = rotations;
    trace->was_thorough = is_thorough;
    name_fates(result, *trace);
  }
  return result;
}

MatchResult match(const Scan& reference, const Scan& current, const MatchParams& params) {
  params.validate();
  return match(prepare(reference, params.surface, params.samples),
               prepare(current, params.surface, params.samples),
               params);
}

}  // namespace setsquare
