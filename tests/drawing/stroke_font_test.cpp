// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/stroke_font.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace setsquare::stroke_font_test {

/// The strokes as text, to compare glyphs.
std::string described(char character) {
  std::string text;
  for (const Stroke& stroke : strokes_of_text(std::string(1, character))) {
    for (const Eigen::Vector2d& point : stroke) {
      text += std::to_string(point.x()) + "," + std::to_string(point.y()) + " ";
    }
    text += "/ ";
  }
  return text;
}

TEST(StrokeFont, EveryPrintableCharacterHasItsOwnGlyph) {
  std::set<std::string> glyphs = {described('\x7f')};  // the box of what has no glyph
  for (char character = '!'; character <= '~'; ++character) {
    EXPECT_TRUE(glyphs.insert(described(character)).second) << character;
  }
}

TEST(StrokeFont, LettersStayBetweenDescenderAndAscender) {
  for (char character = '!'; character <= '~'; ++character) {
    for (const Stroke& stroke : strokes_of_text(std::string(1, character))) {
      ASSERT_FALSE(stroke.empty());
      for (const Eigen::Vector2d& point : stroke) {
        EXPECT_GE(point.x(), 0.0) << character;
        EXPECT_LE(point.x(), 5.0 / 6.0) << character;
        EXPECT_GE(point.y(), -2.0 / 6.0) << character;
        EXPECT_LE(point.y(), 1.0) << character;
      }
    }
  }
}

TEST(StrokeFont, WidthGrowsWithTheText) {
  EXPECT_EQ(text_width(""), 0.0);
  EXPECT_GT(text_width("10 m"), text_width("10"));
  EXPECT_EQ(strokes_of_text("   ").size(), 0U);
}

TEST(StrokeFont, AnOIsClosedAndRound) {
  const std::vector<Stroke> strokes = strokes_of_text("O");
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(strokes[0].front(), strokes[0].back());
  EXPECT_GT(strokes[0].size(), 16U);
}

}  // namespace setsquare::stroke_font_test
