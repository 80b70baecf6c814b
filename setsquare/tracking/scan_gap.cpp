// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {
namespace {

constexpr double kNewest = 0.1;  ///< Weight of the newest pause in the usual one.

}  // namespace

void ScanGapParams::validate() const {
  require_positive(min_gap_s, "gap.min_gap_s");
  require_positive(min_num_periods, "gap.min_num_periods");
  require_positive(same_range_m, "gap.same_range_m");
  if (!(min_same > 0.0 && min_same <= 1.0)) {
    throw ParameterError("gap.min_same", "must be above 0, and at most 1");
  }
}

bool ScanGap::add(const Scan& scan) {
  const auto [last, is_first] = last_.try_emplace(scan.scanner);
  const Scan before = std::exchange(last->second, scan);
  const auto last_stamp = std::exchange(last_stamp_, scan.stamp);
  const Timestamp latest =
      std::exchange(latest_, last_stamp ? std::max(*last_stamp, scan.stamp) : scan.stamp);
  if (!last_stamp) return false;
  const double pause_s = seconds_between(latest, scan.stamp);
  if (pause_s <= 0.0) return false;
  if (period_s_ == 0.0) {  // the first pause may not be a usual one
    period_s_ = pause_s;
    return false;
  }
  if (pause_s < std::max(params_.min_gap_s, params_.min_num_periods * period_s_)) {
    period_s_ += kNewest * (pause_s - period_s_);
    return false;
  }
  return is_first || !is_same_view(before, scan);
}

bool ScanGap::is_same_view(const Scan& a, const Scan& b) const {
  const std::size_t num_beams = std::min(a.num_beams(), b.num_beams());
  double num_compared = 0.0;
  double num_same = 0.0;
  for (std::size_t i = 0; i < num_beams; ++i) {
    if (a.outcome(i) != BeamOutcome::kReturn || b.outcome(i) != BeamOutcome::kReturn) continue;
    num_compared += 1.0;
    num_same += std::abs(a.ranges_m[i] - b.ranges_m[i]) < params_.same_range_m ? 1.0 : 0.0;
  }
  return num_compared > 0.0 && num_same >= params_.min_same * num_compared;
}

}  // namespace setsquare
