// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/status_color.hpp"
#include "setsquare/report/match/report.hpp"
#include "setsquare/report/match/sections.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kMargin_px = 40.0;
constexpr double kSentence_px = 20.0;
constexpr double kSectionHead_px = 58.0;
constexpr double kGap_px = 26.0;

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
  double height_px = head_height_px(story) + kMargin_px;
  for (const MatchSection& section : sections) {
    height_px += kSectionHead_px + section.figure.height_px() + kGap_px;
  }
  SvgCanvas canvas(kFigureWidth_px + 2.0 * kMargin_px, height_px);
  canvas.rectangle({0.0, 0.0}, {canvas.width_px(), height_px}, {.fill = palette::kPaper});
  draw_head(canvas, story);
  double top_px = head_height_px(story) + kGap_px;
  for (const MatchSection& section : sections) {
    canvas.text({kMargin_px, top_px + 20.0},
                section.title,
                {.size_px = 18.0, .fill = palette::kInk, .is_bold = true});
    canvas.text({kMargin_px, top_px + 42.0},
                section.caption,
                {.size_px = 12.5, .fill = palette::kFaintInk});
    canvas.place(section.figure, {kMargin_px, top_px + kSectionHead_px});
    top_px += kSectionHead_px + section.figure.height_px() + kGap_px;
  }
  return canvas.document();
}

}  // namespace setsquare
