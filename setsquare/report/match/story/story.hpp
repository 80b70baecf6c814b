// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/paper/direction_curve.hpp"
#include "setsquare/paper/dominant_direction.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/paper/profile_correlation.hpp"
#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/point_set.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How a scan is called in the story: "scan 120, 976052891.337000".
struct StoryNames {
  std::string log;
  std::string reference;
  std::string current;
};

/// A scan as the paper sees it. theta_D is that of Algorithm 2.
struct StoryScan {
  Scan scan;
  PointSet points;   ///< All returns, in the sensor frame.
  PointSet thinned;  ///< Section 4.2.
  DirectionGrid directions;
  std::vector<double> moments;  ///< M(theta), eq. (7), one a direction over half a turn.
  DominantDirection dominant;   ///< Algorithm 2.
  ProjectedProfile along;       ///< x': eq. (5) at theta_D.
  ProjectedProfile across;      ///< y': at theta_D + 90 deg.
  ProjectedProfile off;         ///< At theta_D + kOffDirection_rad, where no wall runs along.
};

inline constexpr double kOffDirection_rad = rad_from_deg(30.0);

/// Correlation of the profiles against the shift at one rotation, eqs. (9) and (10).
struct StoryRotation {
  double rotation_rad = 0.0;  ///< Of T_reference_current.
  std::string label;          ///< "offset 90 deg", "rotation -3.1 deg".
  std::vector<std::int32_t> along;
  std::vector<std::int32_t> across;
  double shift_along_m = 0.0;  ///< Chosen along x'.
  double shift_across_m = 0.0;
};

/// A relative pose that was considered.
struct StoryProposal {
  Pose2 T_reference_current;
  std::vector<std::string> measures;  ///< One a name of MatchStory::measure_names.
  std::string fate;                   ///< "the answer", or why it lost.
};

/// One match with all that led to its answer. Poses are those of the sensors.
struct MatchStory {
  StoryNames names;
  std::string preset;  ///< "paper" or "default".
  StoryScan reference;
  StoryScan current;
  MatchResult result;
  ShiftSearch shifts;
  std::vector<StoryRotation> rotations;  ///< The answer's first.
  std::vector<std::string> measure_names;
  std::vector<StoryProposal> proposals;  ///< The answer first, then by merit.
  std::string remark;                    ///< On what else was tried.
  std::vector<std::string> evidence;     ///< The answer in words, a sentence each.
};

/// Matches by the paper's method and tells how.
[[nodiscard]] MatchStory tell_paper_match(const Scan& reference,
                                          const Scan& current,
                                          const StoryNames& names,
                                          const PaperParams& params = {});

/// Matches with the default matcher and tells how; the paper's curves are drawn beside it.
[[nodiscard]] MatchStory tell_default_match(const Scan& reference,
                                            const Scan& current,
                                            const StoryNames& names,
                                            const MatchParams& params = {});

}  // namespace setsquare
