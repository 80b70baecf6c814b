// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/report.hpp"
#include "setsquare/report/match/sections.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kMargin_px = 40.0;
constexpr double kSentence_px = 20.0;
constexpr double kSectionHead_px = 58.0;
constexpr double kGap_px = 26.0;

/// Green for an answer that stands, red for none, amber for an open one.
Color status_color(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return palette::kAnswer;
    case MatchStatus::kAmbiguous:
    case MatchStatus::kDegenerate:
      return color(0xb26a00);
    default:
      return palette::kLost;
  }
}

/// The panels in rows as wide as a figure.
SvgCanvas in_rows(const Figure& figure) {
  constexpr double kSlack_px = 0.5;  // Thirds do not sum exactly.
  std::vector<Eigen::Vector2d> corners;
  Eigen::Vector2d corner(0.0, 0.0);
  double row_px = 0.0;
  for (const SvgCanvas& panel : figure) {
    if (corner.x() > 0.0 && corner.x() + panel.width_px() > kFigureWidth_px + kSlack_px) {
      corner = {0.0, corner.y() + row_px};
      row_px = 0.0;
    }
    corners.push_back(corner);
    corner.x() += panel.width_px();
    row_px = std::max(row_px, panel.height_px());
  }
  SvgCanvas rows(kFigureWidth_px, corner.y() + row_px);
  for (std::size_t i = 0; i < figure.size(); ++i) rows.place(figure[i], corners[i]);
  return rows;
}

double head_height_px(const MatchStory& story) {
  return 92.0 + kSentence_px * static_cast<double>(story.evidence.size());
}

void draw_head(SvgCanvas& canvas, const MatchStory& story) {
  canvas.text({kMargin_px, 52.0},
              "How two scans were matched",
              {.size_px = 26.0, .fill = palette::kInk, .is_bold = true});
  canvas.text(
      {kMargin_px, 78.0}, match_subtitle(story), {.size_px = 14.0, .fill = palette::kFaintInk});
  double baseline_px = 112.0;
  for (const std::string& sentence : story.evidence) {
    const bool is_status = &sentence == &story.evidence.front();
    canvas.text({kMargin_px, baseline_px},
                sentence,
                {.size_px = is_status ? 16.0 : 14.0,
                 .fill = is_status ? status_color(story.result.status) : palette::kInk,
                 .is_bold = is_status});
    baseline_px += kSentence_px;
  }
}

}  // namespace

std::string match_report_svg(const MatchStory& story) {
  const std::vector<MatchSection> sections = match_sections(story);
  std::vector<SvgCanvas> figures;
  double height_px = head_height_px(story) + kMargin_px;
  for (const MatchSection& section : sections) {
    figures.push_back(in_rows(section.figure));
    height_px += kSectionHead_px + figures.back().height_px() + kGap_px;
  }
  SvgCanvas canvas(kFigureWidth_px + 2.0 * kMargin_px, height_px);
  canvas.rectangle({0.0, 0.0}, {canvas.width_px(), height_px}, {.fill = palette::kPaper});
  draw_head(canvas, story);
  double top_px = head_height_px(story) + kGap_px;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const MatchSection& section = sections[i];
    canvas.text({kMargin_px, top_px + 20.0},
                section.title,
                {.size_px = 18.0, .fill = palette::kInk, .is_bold = true});
    canvas.text({kMargin_px, top_px + 42.0},
                section.caption,
                {.size_px = 12.5, .fill = palette::kFaintInk});
    canvas.place(figures[i], {kMargin_px, top_px + kSectionHead_px});
    top_px += kSectionHead_px + figures[i].height_px() + kGap_px;
  }
  return canvas.document();
}

}  // namespace setsquare
