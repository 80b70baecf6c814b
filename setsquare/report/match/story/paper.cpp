// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "setsquare/drawing/text.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/report/match/story/scan.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/report/match/story/words.hpp"

namespace setsquare {
namespace {

Pose2 pose_at_peaks(const OffsetSearch& search, std::size_t offset, const MatchStory& story) {
  const double theta_rad = story.reference.dominant.theta_rad;
  const double along_m = story.shifts.shift_m(search.x.peak);
  const double across_m = story.shifts.shift_m(search.y.peak);
  const double s = std::sin(theta_rad);
  const double c = std::cos(theta_rad);
  const double turned_rad =
      story.current.dominant.theta_rad + static_cast<double>(offset) * 0.5 * kPi - theta_rad;
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

void tell_offset(std::size_t offset,
                 const OffsetSearch& search,
                 std::int64_t best_product,
                 MatchStory& story) {
  const std::string name = joined({"offset ", std::to_string(90 * offset), " deg"});
  const Pose2 T_reference_current = pose_at_peaks(search, offset, story);
  story.rotations.push_back({T_reference_current.theta_rad,
                             name,
                             search.x.correlation,
                             search.y.correlation,
                             story.shifts.shift_m(search.x.peak),
                             story.shifts.shift_m(search.y.peak)});
  const double share =
      best_product > 0 ? static_cast<double>(search.product()) / static_cast<double>(best_product)
                       : 0.0;
  const bool is_answer = story.proposals.empty();
  story.proposals.push_back(
      {T_reference_current,
       {name,
        std::to_string(search.x.peak_value()),
        std::to_string(search.y.peak_value()),
        fixed(share, 3)},
       is_answer ? "the answer: the largest product E"
                 : joined({"E is ", fixed(100.0 * share, 0), " % of the answer's"})});
}

}  // namespace

MatchStory tell_paper_match(const Scan& reference,
                            const Scan& current,
                            const StoryNames& names,
                            const PaperParams& params) {
  MatchStory story;
  story.names = names;
  story.preset = "paper";
  story.reference = story_scan(reference, params);
  story.current = story_scan(current, params);
  story.shifts = params.shifts();
  RelativePoseTrace trace;
  story.result = match_paper(reference, current, params, &trace);
  story.evidence = evidence_in_words(story.result, params);
  story.measure_names = {"theta offset", "Corr x' max", "Corr y' max", "E / E max"};
  story.remark =
      "Algorithm 3 tries four offsets and keeps the one with the largest product E of the two "
      "axes' largest correlations.";
  if (!story.result.T_reference_current) return story;
  const std::array<std::size_t, 4> offsets = offsets_by_merit(trace);
  const std::int64_t best_product = trace[offsets[0]].product();
  for (const std::size_t offset : offsets) {
    tell_offset(offset, trace[offset], best_product, story);
  }
  return story;
}

}  // namespace setsquare
