// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/peers/pair_set.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::peers {

/// One way to match two scans without an initial guess: from raw ranges to the pose of current's
/// sensor in reference's, nothing kept between calls.
struct Matcher {
  std::string name;
  std::function<std::optional<Pose2>(const Scan& reference, const Scan& current)> match;
};

/// What a matcher reached on one set of pairs.
struct MatcherScore {
  std::string name;
  double success = 0.0;    ///< Share of pairs within 0.2 m and 30 deg of the truth.
  double tight = 0.0;      ///< Share within 0.05 m and 1 deg.
  double median_ms = 0.0;  ///< Of the time of one match.
};

/// Each matcher once on each pair, the matchers taking turns pair by pair so that whatever else the
/// machine does affects them equally.
[[nodiscard]] std::vector<MatcherScore> compare(const std::vector<Matcher>& matchers,
                                                const std::vector<ScanPair>& pairs);

}  // namespace setsquare::peers
