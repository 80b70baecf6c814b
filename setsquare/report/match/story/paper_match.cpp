// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/story/paper_match.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "setsquare/drawing/text.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/report/match/story/words.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare {
namespace {

Pose2 pose_at_peaks(const OffsetSearch& search,
                    std::size_t offset,
                    const PaperEvidence& looked_at) {
  const double theta_rad = looked_at.reference.dominant.theta_rad;
  const double along_m = looked_at.shifts.shift_m(search.x.peak);
  const double across_m = looked_at.shifts.shift_m(search.y.peak);
  const double s = std::sin(theta_rad);
  const double c = std::cos(theta_rad);
  const double turned_rad =
      looked_at.current.dominant.theta_rad + static_cast<double>(offset) * 0.5 * kPi - theta_rad;
  return {
      along_m * s + across_m * c, along_m * c - across_m * s, wrap_to_pi(turned_rad)};  // Eq. (8)
}

/// The offsets by falling E of Algorithm 3; of equal ones the earlier first, as there.
std::array<std::size_t, 4> offsets_by_merit(const RelativePoseTrace& trace) {
  std::array<std::size_t, 4> offsets{};
  std::iota(offsets.begin(), offsets.end(), std::size_t{0});
  std::stable_sort(offsets.begin(), offsets.end(), [&](std::size_t a, std::size_t b) {
    return trace[a].product() > trace[b].product();
  });
  return offsets;
}

StoryProposal proposal_at(std::size_t offset,
                          const RelativePoseTrace& trace,
                          std::int64_t best_product,
                          bool is_answer,
                          const PaperEvidence& looked_at) {
  const OffsetSearch& search = trace[offset];
  const double share =
      best_product > 0 ? static_cast<double>(search.product()) / static_cast<double>(best_product)
                       : 0.0;
  return {pose_at_peaks(search, offset, looked_at),
          {fmt::format("offset {} deg", 90 * offset),
           std::to_string(search.x.peak_value()),
           std::to_string(search.y.peak_value()),
           fixed(share, 3)},
          is_answer ? "the answer: the largest product E"
                    : fmt::format("E is {} % of the answer's", fixed(100.0 * share, 0))};
}

PaperRotation rotation_at(std::size_t offset,
                          const OffsetSearch& search,
                          const ShiftSearch& shifts) {
  return {fmt::format("offset {} deg", 90 * offset),
          search.x.correlation,
          search.y.correlation,
          shifts.shift_m(search.x.peak),
          shifts.shift_m(search.y.peak)};
}

}  // namespace

PaperScan paper_scan(const PointSet& points, const PaperParams& params) {
  PaperScan scan;
  scan.thinned = thin(points, params.min_spacing_m);
  const auto num_directions =
      static_cast<std::size_t>(std::lround(kPi / params.direction_step_rad));
  scan.directions = {0.0, params.direction_step_rad, num_directions};
  scan.moments = direction_curve(scan.thinned, scan.directions, params.bins());
  scan.dominant = dominant_direction(scan.thinned, params.direction());
  const double theta_rad = scan.dominant.theta_rad;
  scan.along = projected_profile(scan.thinned, theta_rad, params.bins());
  scan.across = projected_profile(scan.thinned, theta_rad + 0.5 * kPi, params.bins());
  scan.off = projected_profile(scan.thinned, theta_rad + kOffDirection_rad, params.bins());
  return scan;
}

MatchStory tell_paper_match(const Scan& reference,
                            const Scan& current,
                            const StoryNames& names,
                            const PaperParams& params) {
  MatchStory story;
  story.names = names;
  story.preset = "paper";
  story.reference = {reference, points_from_scan(reference)};
  story.current = {current, points_from_scan(current)};
  PaperEvidence looked_at = {.reference = paper_scan(story.reference.points, params),
                             .current = paper_scan(story.current.points, params),
                             .shifts = params.shifts(),
                             .rotations = {}};
  RelativePoseTrace trace;
  story.result = match_paper(reference, current, params, &trace);
  story.evidence = evidence_in_words(story.result, params);
  story.measure_names = {"theta offset", "Corr x' max", "Corr y' max", "E / E max"};
  story.remark =
      "Algorithm 3 tries four offsets and keeps the one with the largest product E of the two "
      "axes' largest correlations.";
  if (story.result.T_reference_current) {
    const std::array<std::size_t, 4> offsets = offsets_by_merit(trace);
    const std::int64_t best_product = trace[offsets[0]].product();
    for (const std::size_t offset : offsets) {
      const bool is_answer = offset == offsets[0];
      looked_at.rotations.push_back(rotation_at(offset, trace[offset], looked_at.shifts));
      story.proposals.push_back(proposal_at(offset, trace, best_product, is_answer, looked_at));
    }
  }
  story.looked_at = std::move(looked_at);
  return story;
}

}  // namespace setsquare
