// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxBars = 6;
constexpr double kPanelWidth_px = kFigureWidth_px / 3.0;
constexpr double kBarLeft_px = 52.0;
constexpr double kBarHeight_px = 22.0;
constexpr double kBarStep_px = 76.0;
constexpr double kLegend_px = 34.0;

struct Part {
  const char* words;
  Color value;
  double length_m;
};

/// All of the compared wall; what is left over lies near a surface, but not on it, or faces another
/// way.
std::array<Part, 5> parts_of(const Evidence& evidence) {
  const double rest_m = std::max(0.0,
                                 evidence.wall_m - evidence.agreeing_m - evidence.contradicted_m -
                                     evidence.hidden_m - evidence.outside_m);
  return {{{"agreeing", palette::kAnswer, evidence.agreeing_m},
           {"near", mix(palette::kAnswer, palette::kPaper, 0.65), rest_m},
           {"hidden", palette::kFrame, evidence.hidden_m},
           {"outside", palette::kGuide, evidence.outside_m},
           {"contradicted", palette::kLost, evidence.contradicted_m}}};
}

/// "0.712 = 0.801 agreeing - 0.010 hidden - 0.079 contradicted": the terms of score().
std::string terms_of_score(const Candidate& candidate, const ScoreParams& params) {
  const Evidence& evidence = candidate.evidence;
  const double compared_m = evidence.wall_m - params.outside_discount * evidence.outside_m;
  if (!(compared_m > 0.0)) return "0: nothing to compare";
  const double agreeing = evidence.agreeing_m / compared_m;
  const double hidden = params.hidden_weight * evidence.hidden_m / compared_m;
  const double contradicted =
      params.contradiction_weight *
      std::log1p(evidence.contradicted_m / compared_m / params.usual_contradiction);
  return fmt::format("{} = {} agreeing - {} hidden - {} contradicted",
                     fixed(candidate.score, 3),
                     fixed(agreeing, 3),
                     fixed(hidden, 3),
                     fixed(contradicted, 3));
}

std::vector<TracedCandidate> shown_candidates(const MatchTrace& trace) {
  std::vector<TracedCandidate> shown;
  for (const TracedCandidate& traced : trace.candidates) {
    const bool is_fine = traced.fate == CandidateFate::kAnswer ||
                         traced.fate == CandidateFate::kRunnerUp ||
                         traced.fate == CandidateFate::kOutscored;
    if (is_fine && shown.size() < kMaxBars) shown.push_back(traced);
  }
  return shown;
}

std::string name_of(const TracedCandidate& traced, std::size_t place) {
  if (traced.fate == CandidateFate::kAnswer) return "Answer";
  if (traced.fate == CandidateFate::kRunnerUp) return "Runner-up";
  return fmt::format("Proposal {}", place + 1);
}

void draw_legend_of(const Evidence& evidence, SvgCanvas& canvas) {
  double x_px = kBarLeft_px;
  for (const Part& part : parts_of(evidence)) {
    canvas.rectangle({x_px, 6.0}, {14.0, 14.0}, {.fill = part.value, .stroke = palette::kFrame});
    canvas.text({x_px + 20.0, 18.0}, part.words, {.fill = palette::kInk});
    constexpr double kLetter_px = 6.6;
    x_px += 30.0 + kLetter_px * static_cast<double>(std::string_view(part.words).size());
  }
}

/// The bar of one candidate: its name, its wall, the terms of its score.
void draw_bar(const std::string& name,
              const Candidate& candidate,
              const ScoreParams& params,
              double top_px,
              SvgCanvas& canvas) {
  const double wall_m = candidate.evidence.wall_m;
  const double width_px = kPanelWidth_px - kBarLeft_px - 10.0;
  canvas.text(
      {kBarLeft_px, top_px + 12.0},
      fmt::format(
          "{}: score {}, {} m of wall compared", name, fixed(candidate.score, 3), fixed(wall_m, 1)),
      {.fill = palette::kInk, .is_bold = true});
  canvas.text(
      {kBarLeft_px, top_px + 28.0}, terms_of_score(candidate, params), {.fill = palette::kInk});
  double x_px = kBarLeft_px;
  for (const Part& part : parts_of(candidate.evidence)) {
    const double part_px = wall_m > 0.0 ? width_px * part.length_m / wall_m : 0.0;
    canvas.rectangle({x_px, top_px + 34.0}, {part_px, kBarHeight_px}, {.fill = part.value});
    x_px += part_px;
  }
}

}  // namespace

Figure evidence_figure(const SurfaceEvidence& looked_at) {
  const std::vector<TracedCandidate> shown = shown_candidates(looked_at.trace);
  Figure figure;
  const std::size_t num_columns = 3;
  for (std::size_t first = 0; first < num_columns && first < shown.size(); ++first) {
    const std::size_t num_bars = (shown.size() - first + num_columns - 1) / num_columns;
    SvgCanvas canvas(kPanelWidth_px, kLegend_px + kBarStep_px * static_cast<double>(num_bars));
    draw_legend_of(shown[first].candidate.evidence, canvas);
    double top_px = kLegend_px;
    for (std::size_t i = first; i < shown.size(); i += num_columns) {
      draw_bar(name_of(shown[i], i), shown[i].candidate, looked_at.params.score, top_px, canvas);
      top_px += kBarStep_px;
    }
    figure.push_back(canvas);
  }
  if (figure.empty()) {
    figure.emplace_back(kPanelWidth_px, kLegend_px);
    figure.back().text({kBarLeft_px, 18.0}, "No proposal was scored.");
  }
  return figure;
}

}  // namespace setsquare
