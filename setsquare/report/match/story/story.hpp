// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/paper/direction_curve.hpp"
#include "setsquare/paper/dominant_direction.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/paper/profile_correlation.hpp"
#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/point_set.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// How a scan is called in the story: "scan 120, 976052891.337000".
struct StoryNames {
  std::string log;
  std::string reference;
  std::string current;
};

/// A scan as it was measured.
struct StoryScan {
  Scan scan;
  PointSet points;  ///< All returns, in the sensor frame.
};

/// A relative pose that was considered.
struct StoryProposal {
  Pose2 T_reference_current;
  std::vector<std::string> measures;  ///< One per name of MatchStory::measure_names.
  std::string fate;                   ///< "the answer", or why it lost.
};

/// A scan as the paper sees it. theta_D is that of Algorithm 2.
struct PaperScan {
  PointSet thinned;  ///< Section 4.2.
  DirectionGrid directions;
  std::vector<double> moments;  ///< M(theta), eq. (7), one per direction over half a turn.
  DominantDirection dominant;   ///< Algorithm 2.
  ProjectedProfile along;       ///< x': eq. (5) at theta_D.
  ProjectedProfile across;      ///< y': at theta_D + 90 deg.
  ProjectedProfile off;         ///< At theta_D + kOffDirection_rad, where no wall runs along.
};

inline constexpr double kOffDirection_rad = rad_from_deg(30.0);

/// Correlation of the profiles against the shift at one offset, eqs. (9) and (10).
struct PaperRotation {
  std::string label;  ///< "offset 90 deg"
  std::vector<std::int32_t> along;
  std::vector<std::int32_t> across;
  double shift_along_m = 0.0;  ///< Chosen along x'.
  double shift_across_m = 0.0;
};

/// What the paper's method looked at.
struct PaperEvidence {
  PaperScan reference;
  PaperScan current;
  ShiftSearch shifts;
  std::vector<PaperRotation> rotations;  ///< The answer's first.
};

/// A rule of the default matcher's verdict, with what was measured. The rules are asked in order;
/// the first that fails decides.
struct VerdictRule {
  std::string name;   ///< "Agreement"
  std::string asked;  ///< "at least 10.0 % of the wall"
  std::string found;  ///< "83.1 %"
  bool holds = false;
  MatchStatus otherwise = MatchStatus::kAmbiguous;  ///< The answer where it fails.
};

/// What the default matcher looked at.
struct SurfaceEvidence {
  PreparedScan reference;
  PreparedScan current;
  MatchParams params;
  MatchTrace trace;
  std::vector<VerdictRule> rules;
};

/// One match with all that led to its answer. Poses are those of the sensors.
struct MatchStory {
  StoryNames names;
  std::string preset;  ///< "paper" or "default".
  StoryScan reference;
  StoryScan current;
  MatchResult result;
  std::variant<PaperEvidence, SurfaceEvidence> looked_at;
  std::optional<Pose2> T_proposed;  ///< The answer before it was refined; the paper refines none.
  std::vector<std::string> measure_names;
  std::vector<StoryProposal> proposals;  ///< The answer first, then by merit.
  std::string remark;                    ///< On what else was tried.
  std::vector<std::string> evidence;     ///< The answer in words, a sentence each.
};

/// Matches by the paper's method and records the steps.
[[nodiscard]] MatchStory tell_paper_match(const Scan& reference,
                                          const Scan& current,
                                          const StoryNames& names,
                                          const PaperParams& params = {});

/// Matches with the default matcher and records the steps.
[[nodiscard]] MatchStory tell_default_match(const Scan& reference,
                                            const Scan& current,
                                            const StoryNames& names,
                                            const MatchParams& params = {});

}  // namespace setsquare
