// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/fusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/robust_weight.hpp"
#include "setsquare/headings/equations.hpp"

namespace setsquare {
namespace {

using Measurements = std::vector<AssignedProposal>;

/// What is known of a frame's offset apart from the chain.
struct ToldOffset {
  std::size_t frame = 0;
  double offset_rad = 0.0;
  double sigma_rad = 0.0;
};

/// Prior of a frame's offset: it is only known to lie within the period, but where more is told.
void bind_offsets(const HeadingFrames& found,
                  const std::vector<ToldOffset>& told,
                  double period_rad,
                  HeadingEquations& equations) {
  for (std::size_t f = 1; f < found.frames.size(); ++f) {
    equations.bind_offset(f, found.frames[f].offset_rad, 1.0 / (period_rad * period_rad));
  }
  for (const ToldOffset& offset : told) {
    equations.bind_offset(
        offset.frame, offset.offset_rad, 1.0 / (offset.sigma_rad * offset.sigma_rad));
  }
}

HeadingEquations chain_equations(const HeadingFrames& found,
                                 const Measurements& measurements,
                                 const std::vector<double>& weight,
                                 const std::vector<ToldOffset>& told,
                                 double period_rad) {
  const std::size_t n = found.drift_rad.size();
  HeadingEquations equations(n, found.frames.size());
  for (std::size_t m = 0; m < measurements.size(); ++m) {
    const AssignedProposal& measurement = measurements[m];
    equations.bind(measurement.keyframe,
                   measurement.frame,
                   measurement.offset_rad,
                   weight[m] * measurement.information);
  }
  for (std::size_t k = 1; k < n; ++k) {
    const double sigma_rad = found.step_sigma_rad[k];
    equations.bind_step(k - 1, 1.0 / (sigma_rad * sigma_rad));
  }
  bind_offsets(found, told, period_rad, equations);
  return equations;
}

/// How far a measurement is from what the drifts and offsets say.
double residual_rad(const AssignedProposal& measurement, const HeadingFrames& found) {
  return measurement.offset_rad - found.drift_rad[measurement.keyframe] -
         found.frames[measurement.frame].offset_rad;
}

/// Step 4 of fuse_headings: drifts and offsets in `found` become exact. Returns the weights.
std::vector<double> solve_robustly(const Measurements& measurements,
                                   const std::vector<ToldOffset>& told,
                                   const HeadingFusionParams& params,
                                   HeadingFrames& found) {
  std::vector<double> weight(measurements.size(), 1.0);
  double scale_rad = 16.0 * params.inlier_rad;
  for (int iteration = 0; iteration < params.num_iterations; ++iteration) {
    HeadingSolution solution =
        chain_equations(found, measurements, weight, told, params.trace.period_rad).solve();
    found.drift_rad = std::move(solution.drift_rad);
    for (std::size_t f = 1; f < found.frames.size(); ++f) {
      found.frames[f].offset_rad = solution.offset_rad(static_cast<Eigen::Index>(f - 1));
    }
    for (std::size_t m = 0; m < measurements.size(); ++m) {
      weight[m] = geman_mcclure_weight(residual_rad(measurements[m], found), scale_rad);
    }
    scale_rad = std::max(params.inlier_rad, 0.7 * scale_rad);
  }
  return weight;
}

/// Standard deviations of the headings and of the frames' offsets.
void add_sigmas(const Measurements& measurements,
                std::vector<double> weight,
                const std::vector<ToldOffset>& told,
                const HeadingFusionParams& params,
                HeadingFrames& found,
                FusedHeadings& fused) {
  for (double& w : weight) w /= params.num_alike;
  const HeadingVariances variances =
      chain_equations(found, measurements, weight, told, params.trace.period_rad).variances();
  for (std::size_t k = 0; k < variances.drift_rad2.size(); ++k) {
    fused.heading_sigma_rad[k] = std::sqrt(variances.drift_rad2[k]);
  }
  for (std::size_t f = 1; f < found.frames.size(); ++f) {
    found.frames[f].sigma_rad = std::sqrt(variances.offset_rad2(static_cast<Eigen::Index>(f - 1)));
  }
}

/// The weighted mean of each keyframe's measurements.
void add_measured(const Measurements& measurements,
                  const std::vector<double>& weight,
                  const HeadingFrames& found,
                  FusedHeadings& fused) {
  constexpr double kMinWeight = 0.05;  // A smaller weight is ignored.
  for (std::size_t m = 0; m < measurements.size(); ++m) {
    const AssignedProposal& measurement = measurements[m];
    const std::size_t k = measurement.keyframe;
    if (weight[m] > fused.weight[k]) {
      fused.weight[k] = weight[m];
      if (weight[m] >= kMinWeight) fused.frame[k] = static_cast<int>(measurement.frame);
    }
    const double information = weight[m] * measurement.information;
    fused.measured_information[k] += information;
    if (!(fused.measured_information[k] > 0.0)) continue;
    const double heading_rad = fused.heading_rad[k] + residual_rad(measurement, found);
    fused.measured_heading_rad[k] +=
        (heading_rad - fused.measured_heading_rad[k]) * information / fused.measured_information[k];
  }
}

/// The frame whose walls stand at this offset: a new one where none is near.
std::size_t frame_at(double offset_rad,
                     double sigma_rad,
                     double period_rad,
                     HeadingFrames& found,
                     std::vector<ToldOffset>& told) {
  constexpr double kSame_rad = rad_from_deg(1.0);
  constexpr double kSameSigmas = 2.0;
  std::size_t nearest = found.frames.size();
  double least_rad = std::max(kSame_rad, kSameSigmas * sigma_rad);
  for (std::size_t f = 0; f < found.frames.size(); ++f) {
    const double miss_rad =
        std::abs(wrap_to_period(offset_rad - found.frames[f].offset_rad, period_rad));
    if (miss_rad >= least_rad) continue;
    least_rad = miss_rad;
    nearest = f;
  }
  if (nearest == found.frames.size()) {
    const double wrapped_rad = wrap_to_period(offset_rad, period_rad);
    found.frames.push_back({.offset_rad = wrapped_rad});
    told.push_back({nearest, wrapped_rad, sigma_rad});
  }
  return nearest;
}

/// The tracked rotation to a keyframe binds as it was stated, unless it slipped.
void restate_step(const std::vector<HeadingEvidence>& keyframes,
                  std::size_t k,
                  HeadingFrames& found) {
  constexpr double kMaxSigmas = 4.0;
  if (k == 0 || k >= keyframes.size()) return;
  const double turned_rad = std::abs(found.drift_rad[k] - found.drift_rad[k - 1]);
  const double sigma_rad = std::max(keyframes[k].step_sigma_rad, rad_from_deg(0.01));
  found.step_sigma_rad[k] = turned_rad > kMaxSigmas * sigma_rad ? turned_rad : sigma_rad;
}

/// Step 5 of fuse_headings, of one stretch: its measurements are of other frames, and its drift is
/// what follows.
void turn_walls(const std::vector<HeadingEvidence>& keyframes,
                const TurnedWalls& turned,
                double period_rad,
                Measurements& measurements,
                HeadingFrames& found,
                std::vector<ToldOffset>& told) {
  std::map<std::size_t, std::size_t> frames;  // What each frame is there.
  for (std::size_t k = turned.first; k < turned.end; ++k) found.drift_rad[k] += turned.turn_rad;
  for (AssignedProposal& measurement : measurements) {
    const std::size_t k = measurement.keyframe;
    if (k < turned.first || k >= turned.end) continue;
    const auto [frame, is_new] = frames.try_emplace(measurement.frame, 0);
    if (is_new) {
      const double offset_rad = found.frames[measurement.frame].offset_rad - turned.turn_rad;
      frame->second = frame_at(offset_rad, turned.sigma_rad, period_rad, found, told);
    }
    const double support =
        std::min(keyframes[k].share_of_place, found.frames[measurement.frame].support);
    found.frames[measurement.frame].support -= support;
    measurement.frame = frame->second;
    found.frames[measurement.frame].support += support;
    const double rough_rad = found.drift_rad[k] + found.frames[measurement.frame].offset_rad;
    measurement.offset_rad =
        rough_rad + wrap_to_period(measurement.offset_rad - rough_rad, period_rad);
  }
  restate_step(keyframes, turned.first, found);
  restate_step(keyframes, turned.end, found);
}

}  // namespace

std::vector<AssignedProposal> assign_heading_proposals(
    const std::vector<HeadingEvidence>& keyframes,
    const HeadingFrames& found,
    double period_rad,
    double gate_rad,
    double building_sigma_rad) {
  const double trust = found.share * found.share;
  std::vector<AssignedProposal> measurements;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    for (const HeadingProposal& proposal : keyframes[k].proposals) {
      const double variance_rad2 =
          proposal.sigma_rad * proposal.sigma_rad + building_sigma_rad * building_sigma_rad;
      AssignedProposal measurement{.keyframe = k};
      double least_rad = gate_rad;
      for (std::size_t f = 0; f < found.frames.size(); ++f) {
        const double rough_rad = found.drift_rad[k] + found.frames[f].offset_rad;
        const double miss_rad = wrap_to_period(
            proposal.heading_rad - keyframes[k].tracked_heading_rad - rough_rad, period_rad);
        if (std::abs(miss_rad) >= least_rad) continue;
        least_rad = std::abs(miss_rad);
        measurement = {k, f, rough_rad + miss_rad, trust * proposal.confidence / variance_rad2};
      }
      if (measurement.information > 0.0) measurements.push_back(measurement);
    }
  }
  return measurements;
}

void HeadingFusionParams::validate() const {
  trace.validate();
  frames.validate();
  doubt.validate();
  if (!(building_sigma_rad > 0.0)) throw ParameterError("building_sigma_rad", "must be positive");
  if (!(inlier_rad > 0.0)) throw ParameterError("inlier_rad", "must be positive");
  if (num_iterations < 1) throw ParameterError("num_iterations", "must be at least 1");
  if (!(num_alike >= 1.0)) throw ParameterError("num_alike", "must be at least 1");
}

FusedHeadings fuse_headings(const std::vector<HeadingEvidence>& keyframes,
                            const HeadingFusionParams& params,
                            std::span<const TurnedWalls> turned) {
  const std::size_t n = keyframes.size();
  const double infinite = std::numeric_limits<double>::infinity();
  FusedHeadings fused{.heading_rad = std::vector<double>(n),
                      .drift_rad = std::vector<double>(n, 0.0),
                      .weight = std::vector<double>(n, 0.0),
                      .heading_sigma_rad = std::vector<double>(n, infinite),
                      .measured_heading_rad = {},
                      .measured_information = std::vector<double>(n, 0.0),
                      .frame = std::vector<int>(n, -1),
                      .frames = {},
                      .doubted = {}};
  const HeadingTrace trace = trace_headings(keyframes, params.trace);
  HeadingFrames found = find_heading_frames(keyframes, trace, params.trace, params.frames);
  fused.doubted = without_settled(
      doubted_turns(keyframes, trace, found.drift_rad, params.trace, params.doubt), turned);
  Measurements measurements = assign_heading_proposals(keyframes,
                                                       found,
                                                       params.trace.period_rad,
                                                       2.0 * params.trace.inlier_rad,
                                                       params.building_sigma_rad);
  std::vector<double> weight;
  if (!measurements.empty()) {  // Else no wall was seen: the tracked headings stay.
    std::vector<ToldOffset> told;
    weight = solve_robustly(measurements, told, params, found);
    for (const TurnedWalls& walls : turned) {
      turn_walls(keyframes, walls, params.trace.period_rad, measurements, found, told);
    }
    if (!turned.empty()) weight = solve_robustly(measurements, told, params, found);
    add_sigmas(measurements, weight, told, params, found, fused);
    fused.drift_rad = found.drift_rad;
  }
  for (std::size_t k = 0; k < n; ++k) {
    fused.heading_rad[k] = keyframes[k].tracked_heading_rad + fused.drift_rad[k];
  }
  fused.measured_heading_rad = fused.heading_rad;
  add_measured(measurements, weight, found, fused);
  fused.frames = std::move(found.frames);
  return fused;
}

}  // namespace setsquare
