// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from audit, its only caller: tested with matches of its own.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/mapping/audit/matched_pairs.hpp"

namespace setsquare {

/// Scans that tell of a step lie at most so many steps apart: farther off they seldom see the same.
inline constexpr std::size_t kMaxSecondingSteps = 3;

/// The long steps of a track (AuditedTrack::long_steps) that no independent match seconds: for logs
/// of key frames. There a few matches tell each step, by rules that ask less than the audit's, and
/// one that is wrong bends all that follows. Scans up to two steps apart are matched, and up to
/// three about the steps that these leave. Of wrong steps hardly one is seconded.
[[nodiscard]] std::vector<std::size_t> unseconded_steps(const AuditedTrack& track,
                                                        const AuditParams& params,
                                                        MatchedPairs& matched);

/// Those of the steps that no majority of the matches that span them, over up to three steps,
/// agrees with.
[[nodiscard]] std::vector<std::size_t> without_second(const std::vector<std::size_t>& steps,
                                                      std::span<const AuditMatch> matches,
                                                      const AuditedTrack& track,
                                                      const AuditParams& params);

/// Keyframes between long steps that may be wrong by themselves: most matches over them, over up to
/// three steps, agree with the map, but not most of those that end there. What spans both steps
/// seconds them together, and tells nothing of the place between.
[[nodiscard]] std::vector<std::size_t> astray_keyframes(std::span<const AuditMatch> matches,
                                                        const AuditedTrack& track,
                                                        const AuditParams& params);

}  // namespace setsquare
