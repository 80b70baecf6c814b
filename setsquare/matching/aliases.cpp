// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/aliases.hpp"

#include "setsquare/matching/verdict.hpp"
#include "setsquare/matching/wall_kinds.hpp"

namespace setsquare {
namespace {

/// Wall that holds the position along its open direction, of what agrees closely.
double held_m(const PreparedScan& a,
              const PreparedScan& b,
              const Pose2& T_a_b,
              double tolerance_m) {
  const Alignment alignment = align(a.fine_alignment(), b.fine_alignment(), T_a_b, tolerance_m);
  return wall_constraint(alignment.hessian).open_direction_m;
}

}  // namespace

std::vector<Pose2> find_aliases(const PreparedScan& reference,
                                const PreparedScan& current,
                                std::span<const Candidate> candidates,
                                double tight_m,
                                const AliasParams& params) {
  const Candidate& best = candidates.front();
  const Pose2 T_current_reference = best.T_reference_current.inverse();
  const double min_tight_m = params.min_share * tight_m;
  const double max_contradicted_m = best.evidence.contradicted_m + params.max_contradiction_m;
  std::vector<Pose2> aliases;
  for (const Candidate& other : candidates.subspan(1)) {
    const Pose2& T = other.T_reference_current;
    // What agrees closely counts almost in full: a cheap first look.
    constexpr double kAlmost = 0.9;
    if (other.evidence.agreeing_m < kAlmost * min_tight_m ||
        other.evidence.contradicted_m > max_contradicted_m) {
      continue;
    }
    const auto is_held = [&](const PreparedScan& a, const PreparedScan& b, const Pose2& T_a_b) {
      return held_m(a, b, T_a_b, params.tolerance_m) >= params.min_constraint_m;
    };
    if (!is_held(reference, current, T)) continue;
    const TwoWayKinds kinds = wall_kinds(reference.fine_alignment(), current.fine_alignment(), T);
    if (kinds.forward.tight_m + kinds.backward.tight_m < min_tight_m) continue;
    const Pose2 of_reference = T * T_current_reference;
    if (is_held(reference, reference, of_reference) &&
        is_held(current, current, T_current_reference * T)) {
      aliases.push_back(of_reference);
    }
  }
  return aliases;
}

}  // namespace setsquare
