// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/palette.hpp"
#include "setsquare/report/plot_panel.hpp"

namespace setsquare {
namespace {

/// A third of a row: it fits a phone without becoming too small to read.
constexpr double kPanelSide_px = kFigureWidth_px / 3.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<Eigen::Vector2d> places_of(const std::vector<float>& x_m,
                                       const std::vector<float>& y_m,
                                       std::size_t count) {
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < count; ++i) places.emplace_back(x_m[i], y_m[i]);
  return places;
}

/// The surfaces as one line, broken where the scan does not join neighbours.
std::vector<Eigen::Vector2d> joined_surfaces(const SurfacePoints& points) {
  std::vector<Eigen::Vector2d> line;
  for (std::size_t i = 0; i < points.size(); ++i) {
    line.emplace_back(points.x_m[i], points.y_m[i]);
    if (points.joined[i] == 0) line.emplace_back(kNaN, kNaN);
  }
  return line;
}

std::vector<Eigen::Vector2d> points_without_line(const SurfacePoints& points) {
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.normal_x[i] != 0.0F || points.normal_y[i] != 0.0F) continue;
    places.emplace_back(points.x_m[i], points.y_m[i]);
  }
  return places;
}

SvgCanvas surface_panel(const PreparedScan& scan, const char* name, Color value) {
  const Eigen::Vector2d size(kPanelSide_px, kPanelSide_px);
  SvgCanvas canvas(size.x(), size.y());
  const SurfacePoints& points = scan.points();
  const double wall_m = std::accumulate(points.weight_m.begin(), points.weight_m.end(), 0.0);
  const EqualRanges ranges = equal_ranges(places_of(points.x_m, points.y_m, points.size()), size);
  PlotPanel panel(
      canvas,
      {0.0, 0.0},
      size,
      ranges.x,
      ranges.y,
      {fmt::format("{}: {} returns on {} m of wall", name, points.size(), fixed(wall_m, 1)),
       "x [m]",
       "y [m]"});
  const auto loose = points_without_line(points);
  const auto samples = places_of(scan.coarse.x_m, scan.coarse.y_m, scan.coarse.size());
  panel.curve(joined_surfaces(points), value, 2.0);
  panel.dots(loose, palette::kFaintInk, 1.6);
  panel.dots(samples, palette::kInk, 2.2, 0.6);
  panel.sensor({0.0, 0.0}, 0.0, palette::kInk);
  panel.remark("surfaces", value, 0);
  panel.remark(fmt::format("{} returns without a line", loose.size()), palette::kFaintInk, 1);
  panel.remark(fmt::format("{} coarse samples", samples.size()), palette::kInk, 2);
  return canvas;
}

std::vector<Eigen::Vector2d> histogram_curve(const AngleHistogram& histogram) {
  std::vector<Eigen::Vector2d> curve;
  for (int bin = 0; bin < AngleHistogram::kNumBins; ++bin) {
    curve.emplace_back(deg_from_rad(AngleHistogram::direction_rad(bin)), histogram.length_m[bin]);
  }
  return curve;
}

/// The circular correlation of the histograms over the rotation, normalised as the proposals are.
std::vector<Eigen::Vector2d> rotation_curve(const AngleHistogram& reference,
                                            const AngleHistogram& current) {
  constexpr int kNumBins = AngleHistogram::kNumBins;
  const auto dot_at = [](const AngleHistogram& a, const AngleHistogram& b, int lag) {
    double sum = 0.0;
    for (int i = 0; i < kNumBins; ++i) {
      sum += static_cast<double>(a.length_m[(i + lag) % kNumBins]) * b.length_m[i];
    }
    return sum;
  };
  const double energy = std::sqrt(dot_at(reference, reference, 0) * dot_at(current, current, 0));
  std::vector<Eigen::Vector2d> curve;
  for (int lag = -kNumBins / 2; lag <= kNumBins / 2; ++lag) {
    const double value = dot_at(reference, current, (lag + kNumBins) % kNumBins);
    curve.emplace_back(lag * 360.0 / kNumBins, energy > 0.0 ? value / energy : 0.0);
  }
  return curve;
}

double highest_in(const std::vector<Eigen::Vector2d>& curve) {
  double value = 0.1;
  for (const Eigen::Vector2d& point : curve) value = std::max(value, point.y());
  return value;
}

SvgCanvas histogram_panel(const SurfaceEvidence& looked_at) {
  const Eigen::Vector2d size(kPanelSide_px, 280.0);
  SvgCanvas canvas(size.x(), size.y());
  const auto reference = histogram_curve(looked_at.reference.histogram);
  const auto current = histogram_curve(looked_at.current.histogram);
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  {-180.0, 180.0},
                  {0.0, 1.25 * std::max(highest_in(reference), highest_in(current))},
                  {"Wall by the direction that it faces", "direction [deg]", "wall per bin [m]"});
  panel.curve(reference, palette::kReference, 1.6);
  panel.curve(current, palette::kCurrent, 1.6);
  panel.remark("reference", palette::kReference, 0);
  panel.remark("current", palette::kCurrent, 1);
  return canvas;
}

SvgCanvas correlation_panel(const MatchStory& story, const SurfaceEvidence& looked_at) {
  const Eigen::Vector2d size(kPanelSide_px, 280.0);
  SvgCanvas canvas(size.x(), size.y());
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  {-180.0, 180.0},
                  {0.0, 1.3},
                  {"Correlation of the two histograms", "rotation [deg]", "correlation"});
  panel.curve(rotation_curve(looked_at.reference.histogram, looked_at.current.histogram),
              palette::kFaintInk,
              1.4);
  for (const RotationProposal& proposal : looked_at.trace.rotations) {
    panel.ring(deg_from_rad(proposal.rotation_rad), proposal.correlation, palette::kRunnerUp);
  }
  if (story.result.T_reference_current) {
    const double rotation_deg = deg_from_rad(story.result.T_reference_current->theta_rad);
    panel.vertical(
        rotation_deg, palette::kAnswer, fmt::format("answer {} deg", fixed(rotation_deg, 1)), 2);
  }
  panel.remark(fmt::format("{} rotations proposed", looked_at.trace.rotations.size()),
               palette::kRunnerUp,
               0);
  if (looked_at.trace.was_thorough) {
    panel.remark(fmt::format("then all {} of the circle", looked_at.params.thorough.num_rotations),
                 palette::kInk,
                 1);
  }
  return canvas;
}

struct FateStyle {
  CandidateFate fate;
  Color value;
  const char* words;
};

// The last is drawn on top.
constexpr std::array<FateStyle, 5> kFateStyles = {
    {{CandidateFate::kDroppedEarly, color(0xa3acb5), "dropped by the coarse samples"},
     {CandidateFate::kSameAsBetter, color(0x5b7fb0), "in the basin of a better one"},
     {CandidateFate::kOutscored, color(0x8a6d1f), "outscored by the fine samples"},
     {CandidateFate::kRunnerUp, palette::kRunnerUp, "runner-up"},
     {CandidateFate::kAnswer, palette::kAnswer, "answer"}}};

std::vector<Candidate> candidates_of(const MatchTrace& trace, CandidateFate fate) {
  std::vector<Candidate> candidates;
  for (const TracedCandidate& traced : trace.candidates) {
    if (traced.fate == fate) candidates.push_back(traced.candidate);
  }
  return candidates;
}

SvgCanvas translation_panel(const MatchTrace& trace) {
  const Eigen::Vector2d size(kPanelSide_px, kPanelSide_px);
  SvgCanvas canvas(size.x(), size.y());
  std::vector<Eigen::Vector2d> all;
  for (const TracedCandidate& traced : trace.candidates) {
    all.push_back(traced.candidate.T_proposed.translation());
    all.push_back(traced.candidate.T_reference_current.translation());
  }
  const EqualRanges ranges = equal_ranges(all, size);
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  ranges.x,
                  ranges.y,
                  {"From the proposed translation to the refined one", "x [m]", "y [m]"});
  panel.sensor({0.0, 0.0}, 0.0, palette::kReference);
  for (const FateStyle& style : kFateStyles) {
    std::vector<Eigen::Vector2d> ways;
    std::vector<Eigen::Vector2d> ends;
    for (const Candidate& candidate : candidates_of(trace, style.fate)) {
      ways.push_back(candidate.T_proposed.translation());
      ways.push_back(candidate.T_reference_current.translation());
      ways.emplace_back(kNaN, kNaN);
      ends.push_back(candidate.T_reference_current.translation());
    }
    panel.curve(ways, style.value, 1.0, 0.7);
    panel.dots(ends, style.value, style.fate == CandidateFate::kAnswer ? 5.0 : 3.0);
  }
  return canvas;
}

SvgCanvas score_panel(const MatchTrace& trace) {
  const Eigen::Vector2d size(kPanelSide_px, kPanelSide_px);
  SvgCanvas canvas(size.x(), size.y());
  double lowest = 0.0;
  double most = 1.0;
  for (const TracedCandidate& traced : trace.candidates) {
    lowest = std::min(lowest, traced.candidate.score);
    most = std::max<double>(most, traced.candidate.correlation);
  }
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  {0.0, 1.05 * most},
                  {lowest - 0.05, 1.3},
                  {"Correlation of each proposal against its score", "correlation", "score"});
  int line = static_cast<int>(kFateStyles.size());
  for (const FateStyle& style : kFateStyles) {
    std::vector<Eigen::Vector2d> places;
    for (const Candidate& candidate : candidates_of(trace, style.fate)) {
      places.emplace_back(candidate.correlation, candidate.score);
    }
    panel.dots(places, style.value, style.fate == CandidateFate::kAnswer ? 5.0 : 3.0);
    panel.remark(fmt::format("{}: {}", style.words, places.size()), style.value, --line);
  }
  return canvas;
}

}  // namespace

Figure surface_figure(const SurfaceEvidence& looked_at) {
  return {surface_panel(looked_at.reference, "Reference", palette::kReference),
          surface_panel(looked_at.current, "Current", palette::kCurrent)};
}

Figure rotation_figure(const MatchStory& story, const SurfaceEvidence& looked_at) {
  return {histogram_panel(looked_at), correlation_panel(story, looked_at)};
}

Figure search_figure(const SurfaceEvidence& looked_at) {
  return {translation_panel(looked_at.trace), score_panel(looked_at.trace)};
}

}  // namespace setsquare
