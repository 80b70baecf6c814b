// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/paint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace setsquare::paint_test {

constexpr Color kWhite = color(0xffffff);
constexpr Color kBlack = color(0x000000);

/// How much ink an image holds, in fully black pixels.
double ink(const Image& image) {
  double sum = 0.0;
  for (const Color pixel : image.pixels()) sum += (255.0 - pixel.red) / 255.0;
  return sum;
}

TEST(Color, MixesEndToEnd) {
  EXPECT_EQ(color(0x1a2b3c), (Color{0x1a, 0x2b, 0x3c}));
  EXPECT_EQ(mix(kBlack, kWhite, 0.0), kBlack);
  EXPECT_EQ(mix(kBlack, kWhite, 1.0), kWhite);
  EXPECT_EQ(mix(color(0x000064), color(0x640000), 0.5), color(0x320032));
}

TEST(Paint, LineAlongAPixelRowFillsExactlyThatRow) {
  Image image(9, 5, kWhite);
  const std::array<PixelPoint, 2> line = {PixelPoint(1.5, 2.5), PixelPoint(7.5, 2.5)};
  draw_polyline(image, line, 1.0, kBlack);
  for (int column = 1; column <= 7; ++column) EXPECT_EQ(image.at(column, 2), kBlack) << column;
  for (int column = 0; column < 9; ++column) {
    EXPECT_EQ(image.at(column, 1), kWhite);
    EXPECT_EQ(image.at(column, 3), kWhite);
  }
  EXPECT_EQ(image.at(0, 2), kWhite);
  EXPECT_EQ(image.at(8, 2), kWhite);
}

TEST(Paint, InkOfALineIsItsAreaAtAnyAngle) {
  for (const double angle : {0.0, 0.3, 0.7854, 1.2, 1.5708}) {
    Image image(200, 200, kWhite);
    const PixelPoint half = 60.0 * PixelPoint(std::cos(angle), std::sin(angle));
    const PixelPoint middle(100.3, 99.6);
    const std::array<PixelPoint, 2> line = {middle - half, middle + half};
    draw_polyline(image, line, 4.0, kBlack);
    const double area = 120.0 * 4.0 + 3.14159 * 4.0;
    EXPECT_NEAR(ink(image), area, 0.02 * area) << "at " << angle << " rad";
  }
}

TEST(Paint, DiscHasItsArea) {
  Image image(60, 60, kWhite);
  fill_disc(image, {30.0, 30.0}, 20.0, kBlack);
  EXPECT_NEAR(ink(image), 3.14159 * 400.0, 10.0);
  EXPECT_EQ(image.at(30, 30), kBlack);
  EXPECT_EQ(image.at(30, 51), kWhite);
}

TEST(Paint, ManySmallPiecesDrawTheSameLineAsOne) {
  Image whole(50, 50, kWhite);
  Image pieces(50, 50, kWhite);
  const PixelPoint from(5.2, 7.9);
  const PixelPoint to(44.1, 38.3);
  draw_polyline(whole, std::array<PixelPoint, 2>{from, to}, 2.5, kBlack);
  std::vector<PixelPoint> points;
  for (int i = 0; i <= 400; ++i) points.emplace_back(from + (to - from) * i / 400.0);
  draw_polyline(pieces, points, 2.5, kBlack);
  for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
    EXPECT_NEAR(whole.pixels()[i].red, pieces.pixels()[i].red, 1);
  }
}

TEST(Paint, GapsBreakALineAndTheOutsideIsCutOff) {
  Image image(20, 20, kWhite);
  const PixelPoint gap = PixelPoint::Constant(std::nan(""));
  const std::vector<PixelPoint> points = {
      {-1e12, 3.5}, {5.5, 3.5}, gap, {14.5, 3.5}, {1e12, 3.5}, gap, gap};
  draw_polyline(image, points, 1.0, kBlack);
  EXPECT_EQ(image.at(0, 3), kBlack);
  EXPECT_EQ(image.at(5, 3), kBlack);
  EXPECT_EQ(image.at(10, 3), kWhite);
  EXPECT_EQ(image.at(19, 3), kBlack);
  fill_disc(image, {-50.0, 500.0}, 3.0, kBlack);
  fill_rectangle(image, {-10, 15}, {100, 16}, kBlack);
  EXPECT_EQ(image.at(19, 15), kBlack);
  EXPECT_EQ(image.at(19, 16), kWhite);
}

TEST(Paint, TextIsAnchored) {
  const auto first_and_last_column = [](TextAnchor anchor) {
    Image image(200, 40, kWhite);
    draw_text(image, {100.0, 30.0}, "10 m", 20.0, kBlack, anchor);
    int first = 200;
    int last = -1;
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 200; ++column) {
        if (image.at(column, row).red > 128) continue;
        first = std::min(first, column);
        last = std::max(last, column);
      }
    }
    return std::pair(first, last);
  };
  EXPECT_NEAR(first_and_last_column(TextAnchor::kStart).first, 100, 2);
  EXPECT_NEAR(first_and_last_column(TextAnchor::kEnd).second, 100, 2);
  const auto [first, last] = first_and_last_column(TextAnchor::kMiddle);
  EXPECT_NEAR(0.5 * (first + last), 100, 2);
  EXPECT_GT(last - first, 40);
}

}  // namespace setsquare::paint_test
