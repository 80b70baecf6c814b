// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/png_image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::png_image_test {

/// A PNG file of one of libpng's formats, by libpng.
std::string png_of(std::uint32_t format,
                   std::uint32_t width,
                   std::uint32_t height,
                   const std::vector<std::uint8_t>& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&image, file.data(), &size, 0, bytes.data(), 0, nullptr), 0);
  file.resize(size);
  return file;
}

PgmImage read(const std::string& bytes) { return read_png(make_memory_source(bytes), "map.png"); }

TEST(PngImage, GreyPixelsComeBackAsTheyAre) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    const auto width = static_cast<std::uint32_t>(testing::uniform(generator, 1.0, 40.0));
    const auto height = static_cast<std::uint32_t>(testing::uniform(generator, 1.0, 40.0));
    std::vector<std::uint8_t> pixels;
    for (std::uint32_t i = 0; i < width * height; ++i) {
      pixels.push_back(static_cast<std::uint8_t>(testing::uniform(generator, 0.0, 256.0)));
    }
    const PgmImage image = read(png_of(PNG_FORMAT_GRAY, width, height, pixels));
    EXPECT_EQ(image.width, static_cast<std::int32_t>(width));
    EXPECT_EQ(image.height, static_cast<std::int32_t>(height));
    EXPECT_EQ(image.white, 255);
    EXPECT_EQ(image.values, std::vector<std::uint16_t>(pixels.begin(), pixels.end()));
  }
}

TEST(PngImage, ColoursOfGreyAreGreyAndTransparentIsWhite) {
  EXPECT_EQ(read(png_of(PNG_FORMAT_RGB, 2, 1, {205, 205, 205, 0, 0, 0})).values,
            (std::vector<std::uint16_t>{205, 0}));
  EXPECT_EQ(read(png_of(PNG_FORMAT_RGBA, 2, 1, {0, 0, 0, 0, 0, 0, 0, 255})).values,
            (std::vector<std::uint16_t>{255, 0}));
}

TEST(PngImage, DamagedFilesAreToldAtEveryLength) {
  const std::string file = png_of(PNG_FORMAT_GRAY, 30, 20, std::vector<std::uint8_t>(600, 7));
  for (std::size_t length = 0; length + 12 < file.size(); ++length) {
    EXPECT_THROW((void)read(file.substr(0, length)), FormatError) << length;
  }
  EXPECT_THROW((void)read("P5 1 1 255 x"), FormatError);
  std::string huge = file;
  for (std::size_t i = 16; i < 24; ++i) huge[i] = '\x3f';  // Width and height of 1e9.
  EXPECT_THROW((void)read(huge), FormatError);
}

TEST(PngImage, AMapWithAPngIsThatWithAPgm) {
  const testing::TemporaryFolder folder;
  const std::vector<std::uint8_t> pixels{0, 254, 205, 254, 0, 205};
  const std::string yaml =
      "resolution: 0.05\norigin: [1, 2, 0]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\nimage: ";
  folder.write("a.png", png_of(PNG_FORMAT_GRAY, 3, 2, pixels));
  folder.write("a.pgm", "P5 3 2 255\n" + std::string(pixels.begin(), pixels.end()));
  folder.write("png.yaml", yaml + "a.png\n");
  folder.write("pgm.yaml", yaml + "a.pgm\n");
  EXPECT_EQ(read_map_pgm_yaml((folder.path() / "png.yaml").string()).values(),
            read_map_pgm_yaml((folder.path() / "pgm.yaml").string()).values());
}

}  // namespace setsquare::png_image_test
