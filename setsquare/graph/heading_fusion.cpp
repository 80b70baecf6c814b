// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/heading_fusion.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/tridiagonal.hpp"

namespace setsquare {
namespace {

/// The proposal that the traced drift means, as a measured drift.
struct MeasuredDrift {
  double drift_rad = 0.0;
  double weight_per_rad2 = 0.0;  ///< 0 where there is no proposal.
};

MeasuredDrift nearest_proposal(const HeadingEvidence& keyframe,
                               double traced_drift_rad,
                               const HeadingFusionParams& params) {
  MeasuredDrift nearest;
  double least_rad = params.drift.period_rad;
  for (const HeadingProposal& proposal : keyframe.proposals) {
    const double miss_rad =
        wrap_to_period(proposal.heading_rad - keyframe.tracked_heading_rad - traced_drift_rad,
                       params.drift.period_rad);
    if (std::abs(miss_rad) >= least_rad) continue;
    least_rad = std::abs(miss_rad);
    const double variance_rad2 = proposal.sigma_rad * proposal.sigma_rad +
                                 params.building_sigma_rad * params.building_sigma_rad;
    nearest = {traced_drift_rad + miss_rad, proposal.confidence / variance_rad2};
  }
  return nearest;
}

/// Geman-McClure: 1 for a proposal that fits, 1/4 at the scale.
double robust_weight(double residual_rad, double scale_rad) {
  const double ratio = residual_rad / scale_rad;
  const double root = 1.0 / (1.0 + ratio * ratio);
  return root * root;
}

constexpr double kMinStepSigma_rad = 1e-6;

std::vector<double> solve_drift(const std::vector<HeadingEvidence>& keyframes,
                                const std::vector<MeasuredDrift>& measured,
                                const std::vector<double>& weight) {
  TridiagonalSystem system(keyframes.size());
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    system.bind(k, measured[k].drift_rad, weight[k] * measured[k].weight_per_rad2);
    if (k == 0) continue;
    const double sigma_rad = std::max(keyframes[k].step_sigma_rad, kMinStepSigma_rad);
    system.bind_step(k - 1, 0.0, 1.0 / (sigma_rad * sigma_rad));
  }
  return solve(std::move(system));
}

}  // namespace

void HeadingFusionParams::validate() const {
  drift.validate();
  if (!(building_sigma_rad > 0.0)) throw ParameterError("building_sigma_rad", "must be positive");
  if (!(inlier_rad > 0.0)) throw ParameterError("inlier_rad", "must be positive");
  if (num_iterations < 1) throw ParameterError("num_iterations", "must be at least 1");
}

FusedHeadings fuse_headings(const std::vector<HeadingEvidence>& keyframes,
                            const HeadingFusionParams& params) {
  const std::size_t n = keyframes.size();
  FusedHeadings fused{.heading_rad = std::vector<double>(n),
                      .drift_rad = std::vector<double>(n, 0.0),
                      .weight = std::vector<double>(n, 1.0)};
  if (n == 0) return fused;

  const std::vector<double> traced_rad = trace_heading_drift(keyframes, params.drift);
  std::vector<MeasuredDrift> measured(n);
  for (std::size_t k = 0; k < n; ++k) {
    measured[k] = nearest_proposal(keyframes[k], traced_rad[k], params);
    // A proposal that the trace passed by is an outlier from the start.
    const bool is_passed =
        std::abs(measured[k].drift_rad - traced_rad[k]) > 2.0 * params.drift.inlier_rad;
    if (is_passed || measured[k].weight_per_rad2 == 0.0) measured[k] = {};
  }

  const bool is_bound = std::any_of(measured.begin(), measured.end(), [](const MeasuredDrift& m) {
    return m.weight_per_rad2 > 0.0;
  });
  // Where no wall was seen the tracked headings stay.
  const int num_iterations = is_bound ? params.num_iterations : 0;
  double scale_rad = 16.0 * params.inlier_rad;
  for (int iteration = 0; iteration < num_iterations; ++iteration) {
    fused.drift_rad = solve_drift(keyframes, measured, fused.weight);
    for (std::size_t k = 0; k < n; ++k) {
      const bool is_used = measured[k].weight_per_rad2 > 0.0;
      fused.weight[k] =
          is_used ? robust_weight(measured[k].drift_rad - fused.drift_rad[k], scale_rad) : 0.0;
    }
    scale_rad = std::max(params.inlier_rad, 0.7 * scale_rad);
  }
  for (std::size_t k = 0; k < n; ++k) {
    fused.heading_rad[k] = keyframes[k].tracked_heading_rad + fused.drift_rad[k];
  }
  return fused;
}

}  // namespace setsquare
