// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/match/summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace setsquare::app {
namespace {

constexpr double kSuccess_m = 0.2;
constexpr double kSuccess_rad = rad_from_deg(30.0);  // the paper's criterion
constexpr double kTight_m = 0.05;
constexpr double kTight_rad = rad_from_deg(1.0);
constexpr double kWrong_m = 0.2;
constexpr double kWrong_rad = rad_from_deg(3.0);

struct PairError {
  double translation_m = std::numeric_limits<double>::infinity();
  double rotation_rad = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_within(double limit_m, double limit_rad) const {
    return translation_m <= limit_m && rotation_rad <= limit_rad;
  }
};

PairError error_of(const MatchResult& result, const Pose2& truth) {
  if (!result.T_reference_current) return {};
  const Pose2 error = truth.inverse() * *result.T_reference_current;
  return {std::hypot(error.x_m, error.y_m), std::abs(error.theta_rad)};
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Counts of one class of pairs.
struct Tally {
  std::size_t num_pairs = 0;
  std::size_t num_success = 0;
  std::size_t num_tight = 0;
  std::size_t num_matched = 0;
  std::size_t num_wrong = 0;
  std::vector<double> translation_m;
  std::vector<double> rotation_rad;
  std::vector<double> elapsed_us;

  void add(const PairOutcome& outcome, const PairError& error) {
    ++num_pairs;
    num_success += error.is_within(kSuccess_m, kSuccess_rad);
    num_tight += error.is_within(kTight_m, kTight_rad);
    const bool is_matched = outcome.result.status == MatchStatus::kMatched;
    num_matched += is_matched;
    num_wrong += is_matched && !error.is_within(kWrong_m, kWrong_rad);
    translation_m.push_back(error.translation_m);
    rotation_rad.push_back(error.rotation_rad);
    elapsed_us.push_back(outcome.elapsed_us);
  }
};

std::string row(const char* name, const Tally& tally) {
  if (tally.num_pairs == 0) return {};
  const auto percent = [&](std::size_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(tally.num_pairs);
  };
  char line[200];
  std::snprintf(line,
                sizeof line,
                "%-15s %6zu %8.1f%% %6.1f%% %8.1f%% %6zu %8.4f m %7.3f deg %9.1f us\n",
                name,
                tally.num_pairs,
                percent(tally.num_success),
                percent(tally.num_tight),
                percent(tally.num_matched),
                tally.num_wrong,
                median(tally.translation_m),
                deg_from_rad(median(tally.rotation_rad)),
                median(tally.elapsed_us));
  return line;
}

}  // namespace

std::string match_summary(const std::vector<Relation>& relations,
                          const std::vector<PairOverlap>& overlaps,
                          const std::vector<PairOutcome>& outcomes) {
  Tally all;
  Tally high;
  Tally middle;
  Tally low;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const PairError error = error_of(outcomes[i].result, relations[i].T_reference_current);
    all.add(outcomes[i], error);
    if (overlaps.empty()) continue;
    const double overlap = overlaps[i].overlap;
    (overlap >= 0.45 ? high : overlap >= 0.20 ? middle : low).add(outcomes[i], error);
  }
  return "pairs            number  success   tight   matched  wrong    median error            "
         "median time\n" +
         row("all", all) + row("overlap >= 45 %", high) + row("overlap 20-45 %", middle) +
         row("overlap < 20 %", low);
}

}  // namespace setsquare::app
