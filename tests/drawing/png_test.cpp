// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare::png_test {

/// What libpng itself reads from the bytes, as RGB.
std::vector<std::uint8_t> decoded(const std::string& file, png_image& header) {
  header = {};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, file.data(), file.size()), 0);
  const bool is_grey = header.format == PNG_FORMAT_GRAY;
  EXPECT_TRUE(is_grey || header.format == PNG_FORMAT_RGB);
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(header));
  EXPECT_NE(png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr), 0);
  return bytes;
}

TEST(Png, ComesBackThroughLibpngAsItWas) {
  Image image(5, 3, color(0x102030));
  image.set(0, 0, color(0xff0000));
  image.set(4, 0, color(0x00ff00));
  image.set(2, 2, color(0x0000ff));
  png_image header;
  const std::vector<std::uint8_t> bytes = decoded(png_from_image(image), header);
  ASSERT_EQ(header.width, 5U);
  ASSERT_EQ(header.height, 3U);
  ASSERT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 5; ++column) {
      const std::uint8_t* pixel = &bytes[static_cast<std::size_t>(3 * (5 * row + column))];
      EXPECT_EQ((Color{pixel[0], pixel[1], pixel[2]}), image.at(column, row));
    }
  }
}

TEST(Png, ImageOfGreysNeedsOneByteAPixel) {
  Image image(2, 1, color(0x808080));
  image.set(1, 0, color(0x0a0a0a));
  png_image header;
  const std::vector<std::uint8_t> bytes = decoded(png_from_image(image), header);
  EXPECT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_GRAY));
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x80, 0x0a}));
}

TEST(Png, SameImageSameBytes) {
  Image image(64, 64, color(0xfefefe));
  image.set(10, 20, color(0x123456));
  EXPECT_EQ(png_from_image(image), png_from_image(Image(image)));
}

}  // namespace setsquare::png_test
