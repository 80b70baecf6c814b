// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/trace.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// The bins of the offset, a circle.
struct Bins {
  explicit Bins(const HeadingTraceParams& params)
      : num(static_cast<std::size_t>(std::lround(params.period_rad / params.bin_rad))),
        width_rad(params.period_rad / static_cast<double>(num)) {}

  double center_rad(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_rad; }
  /// Bins from a to b, the shorter way around.
  std::ptrdiff_t steps(std::size_t a, std::size_t b) const {
    const auto n = static_cast<std::ptrdiff_t>(num);
    const std::ptrdiff_t ahead =
        (static_cast<std::ptrdiff_t>(b + num) - static_cast<std::ptrdiff_t>(a)) % n;
    return ahead > n / 2 ? ahead - n : ahead;
  }

  std::size_t num;
  double width_rad;
};

/// How far the walls' offset drifts in a step.
double drift_sigma_rad(const HeadingEvidence& keyframe, const HeadingTraceParams& params) {
  return std::max(
      keyframe.step_sigma_rad,
      keyframe.is_step_confirmed ? params.min_confirmed_sigma_rad : params.min_step_sigma_rad);
}

/// Cost of drifting by one bin between a keyframe and the one before.
double bin_cost(const HeadingEvidence& keyframe,
                const HeadingTraceParams& params,
                const Bins& bins) {
  return params.drift_cost * bins.width_rad / drift_sigma_rad(keyframe, params);
}

/// Cheapest costs after a step, and the bins they came from: drift, the lower envelope of one cone
/// per bin (two rounds forward, two back), or a change from the cheapest bin of all.
void advance(double cost_per_bin,
             double change_cost,
             std::vector<double>& costs,
             std::vector<std::uint16_t>& came_from) {
  const std::size_t n = costs.size();
  for (std::size_t bin = 0; bin < n; ++bin) came_from[bin] = static_cast<std::uint16_t>(bin);
  const auto cheapest = std::min_element(costs.begin(), costs.end());
  const auto cheapest_bin = static_cast<std::uint16_t>(cheapest - costs.begin());
  const double changed_cost = *cheapest + change_cost;
  const auto relax = [&](std::size_t from, std::size_t to) {
    const double cost = costs[from] + cost_per_bin;
    if (cost >= costs[to]) return;
    costs[to] = cost;
    came_from[to] = came_from[from];
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t bin = 0; bin < n; ++bin) relax(bin, bin + 1 < n ? bin + 1 : 0);
    for (std::size_t bin = n; bin-- > 0;) relax(bin, bin > 0 ? bin - 1 : n - 1);
  }
  for (std::size_t bin = 0; bin < n; ++bin) {
    if (costs[bin] <= changed_cost) continue;
    costs[bin] = changed_cost;
    came_from[bin] = cheapest_bin;
  }
}

/// Whether a move of the walls' offset is a change of frame; else it is drift.
bool is_change_of_frame(const HeadingEvidence& keyframe,
                        double move_rad,
                        const HeadingTraceParams& params) {
  const double sigma_rad = drift_sigma_rad(keyframe, params);
  if (params.drift_cost * move_rad / sigma_rad > params.change_cost) return true;
  return move_rad > std::max(params.max_drift_sigmas * sigma_rad, params.min_change_rad);
}

/// The path back from the cheapest end.
HeadingTrace follow_back(const std::vector<HeadingEvidence>& keyframes,
                         const HeadingTraceParams& params,
                         const Bins& bins,
                         const std::vector<std::uint16_t>& came_from,
                         std::size_t last_bin) {
  const std::size_t n = keyframes.size();
  HeadingTrace trace{std::vector<double>(n), std::vector<bool>(n, false)};
  std::size_t bin = last_bin;
  double unwrapped_rad = bins.center_rad(bin);
  for (std::size_t k = n; k-- > 0;) {
    trace.offset_rad[k] = unwrapped_rad;
    if (k == 0) break;
    const std::size_t before = came_from[k * bins.num + bin];
    const std::ptrdiff_t shift = bins.steps(bin, before);
    const double shift_rad = static_cast<double>(shift) * bins.width_rad;
    trace.is_change[k] = is_change_of_frame(keyframes[k], std::abs(shift_rad), params);
    unwrapped_rad += shift_rad;
    bin = before;
  }
  return trace;
}

}  // namespace

void HeadingTraceParams::validate() const {
  if (!(period_rad > 0.0)) throw ParameterError("period_rad", "must be positive");
  if (!(bin_rad > 0.0) || bin_rad > period_rad / 4.0 || bin_rad < period_rad / 10000.0) {
    throw ParameterError("bin_rad", "must lie between 1/10000 and 1/4 of the period");
  }
  if (!(inlier_rad > 0.0)) throw ParameterError("inlier_rad", "must be positive");
  if (!(drift_cost >= 0.0)) throw ParameterError("drift_cost", "must not be negative");
  if (!(min_step_sigma_rad > 0.0)) throw ParameterError("min_step_sigma_rad", "must be positive");
  if (!(min_confirmed_sigma_rad > 0.0)) {
    throw ParameterError("min_confirmed_sigma_rad", "must be positive");
  }
  if (!(max_drift_sigmas > 0.0)) throw ParameterError("max_drift_sigmas", "must be positive");
  if (!(min_change_rad >= 0.0)) throw ParameterError("min_change_rad", "must not be negative");
  if (!(change_cost > 0.0)) throw ParameterError("change_cost", "must be positive");
}

double passing_cost(const HeadingEvidence& keyframe,
                    double offset_rad,
                    const HeadingTraceParams& params) {
  double belief = 0.0;
  double best_gain = 0.0;
  for (const HeadingProposal& proposal : keyframe.proposals) {
    const double miss_rad = wrap_to_period(
        proposal.heading_rad - keyframe.tracked_heading_rad - offset_rad, params.period_rad);
    const double miss = miss_rad / params.inlier_rad;
    best_gain = std::max(best_gain, proposal.confidence * (1.0 - std::min(1.0, miss * miss)));
    belief = std::max(belief, proposal.confidence);
  }
  return belief - best_gain;
}

HeadingTrace trace_headings(const std::vector<HeadingEvidence>& keyframes,
                            const HeadingTraceParams& params) {
  if (keyframes.empty()) return {};
  const Bins bins(params);
  std::vector<double> costs(bins.num, 0.0);
  std::vector<std::uint16_t> came_from(keyframes.size() * bins.num);
  std::vector<std::uint16_t> origins(bins.num);
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    if (k > 0) {
      advance(bin_cost(keyframes[k], params, bins), params.change_cost, costs, origins);
      std::copy(origins.begin(),
                origins.end(),
                came_from.begin() + static_cast<std::ptrdiff_t>(k * bins.num));
    }
    if (keyframes[k].proposals.empty()) continue;
    for (std::size_t bin = 0; bin < bins.num; ++bin) {
      costs[bin] += passing_cost(keyframes[k], bins.center_rad(bin), params);
    }
  }
  const auto last_bin =
      static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  HeadingTrace trace = follow_back(keyframes, params, bins, came_from, last_bin);
  const double start_rad = wrap_to_period(trace.offset_rad.front(), params.period_rad);
  const double turns_rad = trace.offset_rad.front() - start_rad;
  for (double& offset_rad : trace.offset_rad) offset_rad -= turns_rad;
  return trace;
}

}  // namespace setsquare
