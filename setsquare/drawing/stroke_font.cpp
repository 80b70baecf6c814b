// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/stroke_font.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace setsquare {
namespace {

/// A glyph is strokes separated by blanks; each pair of digits is a point, x then y. The baseline
/// is y = 2, small letters reach up to 6, capitals to 8. A stroke that starts with '~' is a smooth
/// curve that its points control, one that starts with 'o' a closed smooth curve.
constexpr double kBaseline = 2.0;
constexpr double kCapHeight = 6.0;
constexpr double kLetterGap = 2.2;
constexpr double kBlankWidth = 2.5;

constexpr std::string_view kUnknownGlyph = "0208484202";

// clang-format off
/// From '!' to '~'.
constexpr std::string_view kGlyphs[] = {
    "0804 0202", "0807 2827", "1218 3238 0444 0646", "~4748080545420203 2822",
    "0248 o08061618 o34324244", "~420608383604023244", "0807", "~28060421", "~08262401",
    "0446 0644 2723", "0444 2622", "1201", "0434", "0202", "0148", "o08024248", "072822",
    "~0607084846440302 0242", "~0708484525 ~2545420203", "32380444", "480805 ~050646420203",
    "~474808040303 o06024246", "084812", "o08054548 o05024245", "o08044448 ~474643420203",
    "0202 0505", "1201 1515", "460442", "0343 0545", "064402", "~070848452524 2222",
    "~4202084844 o24263634", "022842 1434", "0208 ~08484505 ~05454202", "~474808024243",
    "0208 ~08484202", "48080242 0535", "480802 0535", "~474808024244 424525", "0208 4248 0545",
    "0208", "~38320203", "0208 4804 1542", "080242", "0208244842", "02084248", "o08025258",
    "0208 ~08484404", "o08025258 3452", "0208 ~08484505 2542", "~4748080545420203", "0848 2822",
    "0804 ~04024244 4448", "082248", "0812263248", "0842 0248", "0825 482522", "08480242",
    "18080111", "0841", "08181101", "062846", "0141", "0817", "o06023236 3632", "0802 o06023236",
    "~353606023233", "3832 o06023236", "0434 ~343606023233", "~281815 1512 0626",
    "o06023236 3632 ~32300001", "0802 ~05063634 3432", "0602 0808", "1612 ~121000 1818",
    "0802 3604 1532", "0802", "0602 ~05062624 2422 ~25264644 4442", "0602 ~05063634 3432",
    "o06023236", "0600 o06023236", "3630 o06023236", "0602 ~040626", "~3536060434320203",
    "1814 ~141222 0626", "0604 ~04023234 3632", "062246", "0612253246", "0632 0236", "0622 4610",
    "06360232", "~28181505 ~05151121", "0801", "~08181525 ~25151101", "~0406264446",
};
// clang-format on
static_assert(std::size(kGlyphs) == '~' - '!' + 1);

std::string_view glyph_of(char character) {
  const bool is_known = character >= '!' && character <= '~';
  return is_known ? kGlyphs[static_cast<std::size_t>(character - '!')] : kUnknownGlyph;
}

/// Chaikin's corner cutting: tends to the quadratic B-spline of the control points; an open curve
/// keeps its ends.
Stroke smooth(const Stroke& control, bool is_closed) {
  Stroke curve = control;
  for (int round = 0; round < 3; ++round) {
    Stroke finer;
    if (!is_closed) finer.push_back(curve.front());
    const std::size_t num_edges = is_closed ? curve.size() : curve.size() - 1;
    for (std::size_t i = 0; i < num_edges; ++i) {
      const Eigen::Vector2d& a = curve[i];
      const Eigen::Vector2d& b = curve[(i + 1) % curve.size()];
      finer.emplace_back(0.75 * a + 0.25 * b);
      finer.emplace_back(0.25 * a + 0.75 * b);
    }
    if (!is_closed) finer.push_back(curve.back());
    curve = finer;
  }
  if (is_closed) curve.push_back(curve.front());
  return curve;
}

/// The stroke that a word of a glyph describes, in units of the grid, y from the baseline.
Stroke stroke_from_word(std::string_view word) {
  const bool is_closed = word.front() == 'o';
  const bool is_smooth = is_closed || word.front() == '~';
  Stroke points;
  for (std::size_t i = is_smooth ? 1 : 0; i + 1 < word.size(); i += 2) {
    points.emplace_back(word[i] - '0', word[i + 1] - '0' - kBaseline);
  }
  return is_smooth ? smooth(points, is_closed) : points;
}

std::vector<Stroke> strokes_of_glyph(std::string_view glyph) {
  std::vector<Stroke> strokes;
  while (!glyph.empty()) {
    const std::size_t end = std::min(glyph.find(' '), glyph.size());
    strokes.push_back(stroke_from_word(glyph.substr(0, end)));
    glyph.remove_prefix(std::min(end + 1, glyph.size()));
  }
  return strokes;
}

double width_of(const std::vector<Stroke>& strokes) {
  double width = 0.0;
  for (const Stroke& stroke : strokes) {
    for (const Eigen::Vector2d& point : stroke) width = std::max(width, point.x());
  }
  return width;
}

}  // namespace

std::vector<Stroke> strokes_of_text(std::string_view text) {
  std::vector<Stroke> strokes;
  double start = 0.0;
  for (const char character : text) {
    if (character == ' ') {
      start += kBlankWidth;
      continue;
    }
    std::vector<Stroke> glyph = strokes_of_glyph(glyph_of(character));
    const double width = width_of(glyph);
    for (Stroke& stroke : glyph) {
      for (Eigen::Vector2d& point : stroke)
        point = (point + Eigen::Vector2d(start, 0.0)) / kCapHeight;
      strokes.push_back(std::move(stroke));
    }
    start += width + kLetterGap;
  }
  return strokes;
}

double text_width(std::string_view text) { return width_of(strokes_of_text(text)); }

}  // namespace setsquare
