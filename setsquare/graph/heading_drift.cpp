// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/heading_drift.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// Cost of missing each bin's drift, for one keyframe.
void add_misses(const HeadingEvidence& keyframe,
                const HeadingDriftParams& params,
                std::vector<double>& costs) {
  const double bin_rad = params.period_rad / static_cast<double>(costs.size());
  for (std::size_t bin = 0; bin < costs.size(); ++bin) {
    const double drift_rad = (static_cast<double>(bin) + 0.5) * bin_rad;
    // Missing every proposal costs the belief that one of them is right.
    double cost = 0.0;
    double best_gain = 0.0;
    for (const HeadingProposal& proposal : keyframe.proposals) {
      const double miss_rad = wrap_to_period(
          proposal.heading_rad - keyframe.tracked_heading_rad - drift_rad, params.period_rad);
      const double miss = miss_rad / params.inlier_rad;
      best_gain = std::max(best_gain, proposal.confidence * (1.0 - std::min(1.0, miss * miss)));
      cost = std::max(cost, proposal.confidence);
    }
    costs[bin] += cost - best_gain;
  }
}

/// One step of the chain: the cheapest way into each bin, and how many bins it came from.
class Step {
 public:
  Step(double step_sigma_rad, const HeadingDriftParams& params, std::size_t num_bins) {
    const double looseness = std::max(1.0, step_sigma_rad / params.certain_step_rad);
    bin_cost_ = params.step_cost / looseness;
    const double reach = std::ceil(static_cast<double>(params.max_step_bins) * looseness);
    reach_ = std::min(static_cast<std::int64_t>(reach), static_cast<std::int64_t>(num_bins / 2));
  }

  void advance(const std::vector<double>& before,
               std::vector<double>& after,
               std::vector<std::int16_t>& came_from) const {
    const auto n = static_cast<std::int64_t>(before.size());
    for (std::int64_t bin = 0; bin < n; ++bin) {
      double best = before[bin];
      std::int64_t best_shift = 0;
      for (std::int64_t shift = -reach_; shift <= reach_; ++shift) {
        const double cost =
            before[(bin + shift + n) % n] + bin_cost_ * static_cast<double>(std::abs(shift));
        if (cost >= best) continue;
        best = cost;
        best_shift = shift;
      }
      after[bin] = best;
      came_from[bin] = static_cast<std::int16_t>(best_shift);
    }
  }

 private:
  double bin_cost_ = 0.0;
  std::int64_t reach_ = 0;
};

}  // namespace

void HeadingDriftParams::validate() const {
  if (!(period_rad > 0.0)) throw ParameterError("period_rad", "must be positive");
  if (!(bin_rad > 0.0) || bin_rad > period_rad / 4.0 || bin_rad < period_rad / 10000.0) {
    throw ParameterError("bin_rad", "must lie between 1/10000 and 1/4 of the period");
  }
  if (!(inlier_rad > 0.0)) throw ParameterError("inlier_rad", "must be positive");
  if (!(step_cost >= 0.0)) throw ParameterError("step_cost", "must not be negative");
  if (!(certain_step_rad > 0.0)) throw ParameterError("certain_step_rad", "must be positive");
}

std::vector<double> trace_heading_drift(const std::vector<HeadingEvidence>& keyframes,
                                        const HeadingDriftParams& params) {
  const auto num_bins = static_cast<std::size_t>(std::lround(params.period_rad / params.bin_rad));
  const double bin_rad = params.period_rad / static_cast<double>(num_bins);
  std::vector<double> costs(num_bins, 0.0);
  std::vector<double> next_costs(num_bins, 0.0);
  std::vector<std::vector<std::int16_t>> came_from(keyframes.size(),
                                                   std::vector<std::int16_t>(num_bins, 0));
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    if (k > 0) {
      Step(keyframes[k].step_sigma_rad, params, num_bins).advance(costs, next_costs, came_from[k]);
      costs.swap(next_costs);
    }
    add_misses(keyframes[k], params, costs);
  }

  std::vector<double> drift_rad(keyframes.size());
  auto bin = std::min_element(costs.begin(), costs.end()) - costs.begin();
  double unwrapped_rad = (static_cast<double>(bin) + 0.5) * bin_rad;
  for (std::size_t k = keyframes.size(); k-- > 0;) {
    drift_rad[k] = unwrapped_rad;
    const std::int64_t shift = came_from[k][bin];
    bin = (bin + shift + static_cast<std::int64_t>(num_bins)) % static_cast<std::int64_t>(num_bins);
    unwrapped_rad += static_cast<double>(shift) * bin_rad;
  }
  if (drift_rad.empty()) return drift_rad;
  const double start_rad = wrap_to_period(drift_rad.front(), params.period_rad);
  const double turns_rad = drift_rad.front() - start_rad;
  for (double& drift : drift_rad) drift -= turns_rad;
  return drift_rad;
}

}  // namespace setsquare
