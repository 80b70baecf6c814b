// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {

/// How many scans were placed how.
struct ChainCounts {
  std::size_t num_matched = 0;
  std::size_t num_degenerate = 0;  ///< Carried on along one direction by the last motion.
  std::size_t num_ambiguous = 0;   ///< Of the two best poses the one nearer to the last motion.
  std::size_t num_unmatched = 0;   ///< Carried on by the last motion, or standing still (paper).

  ChainCounts& operator+=(const ChainCounts& other);
};

/// Scans and the poses that a method gave them; unless it says otherwise each by its match with the
/// one before, no loop closed, no odometry used.
struct ScanChain {
  std::vector<Pose2> T_map_base;  ///< One per scan.
  ChainCounts counts;
};

/// bando2014, section 5.2, by two readings.
struct PaperChains {
  ScanChain literal;      ///< Algorithm 3 as printed: any of the four offsets.
  ScanChain in_sequence;  ///< PaperMapper's: neighbours turn by 45 deg at most.
};

/// PaperMapper with every accepted scan as the next one's reference. The map's frame is the first
/// scan's, turned by its dominant direction.
[[nodiscard]] PaperChains chains_by_paper(std::span<const SimulatedScan> scans);

/// The default matcher, headings from the building:
///
/// 1. Each scan is matched with the one before. Where the answer is not `matched`, what it leaves
///    open is the last motion's.
/// 2. The walls of each scan measure its heading modulo a quarter turn (square_directions); chain
///    and measurements are fused (fuse_headings).
/// 3. The translations, given those headings, are laid out one after the other.
///
/// The map's frame is the first scan's position, with the building's axes.
[[nodiscard]] ScanChain chain_by_default_matcher(std::span<const SimulatedScan> scans);

/// What a mapper answered: a scan that tracking lost is unmatched, any other but the first matched.
[[nodiscard]] ScanChain chain_from(const Map& track);

/// The relative pose that a chain goes on with: the answer where it is `matched`, else as far as it
/// binds the motion; the rest is `last_motion`.
[[nodiscard]] Pose2 motion_from(const MatchResult& result, const Pose2& last_motion);

/// The translation of an answer, given that its rotation is `turn_rad` and not the answer's own:
/// where e^T Omega e is least. The answer's own where Omega does not bind the translation.
[[nodiscard]] Eigen::Vector2d translation_given_turn(const MatchResult& result,
                                                     const Pose2& answered,
                                                     double turn_rad);

}  // namespace setsquare::experiments
