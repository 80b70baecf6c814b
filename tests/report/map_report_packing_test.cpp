// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/report/map/page_data.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::map_report_packing_test {

/// The plain twin of the page's reader: bytes from base64, letter by letter.
std::string bytes_from_base64(std::string_view text) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int num_bits = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<std::uint32_t>(kLetters.find(letter));
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    bytes += static_cast<char>(bits >> num_bits & 255U);
  }
  return bytes;
}

std::vector<std::int64_t> unpacked(const std::string& text) {
  std::vector<std::int64_t> values;
  std::int64_t value = 0;
  std::uint64_t folded = 0;
  int shift = 0;
  for (const char letter : bytes_from_base64(text)) {
    const auto byte = static_cast<unsigned char>(letter);
    folded |= static_cast<std::uint64_t>(byte & 127U) << shift;
    shift += 7;
    if (byte >= 128) continue;
    const auto half = static_cast<std::int64_t>(folded >> 1);
    value += (folded & 1U) != 0 ? -half - 1 : half;
    values.push_back(value);
    folded = 0;
    shift = 0;
  }
  return values;
}

TEST(Base64, HasTheValuesOfItsStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Packed, ComesBackAsItWas) {
  std::mt19937_64 generator = testing::make_generator();
  constexpr std::int64_t kLargest = std::int64_t{1} << 50;
  std::vector<std::int64_t> values = {0, -1, 1, 63, -64, 64, -65, kLargest, -kLargest, 0, 0};
  for (int i = 0; i < 1000; ++i) {
    const double size = std::pow(2.0, testing::uniform(generator, 0.0, 50.0));
    values.push_back(std::llround(testing::uniform(generator, -size, size)));
  }
  EXPECT_EQ(unpacked(packed(values)), values) << "seed " << testing::test_seed();
  EXPECT_EQ(packed({}), "");
}

TEST(Packed, TakesOneByteForASmallStep) {
  std::vector<std::int64_t> values;
  for (std::int64_t i = 0; i < 300; ++i) values.push_back(50 + 60 * (i % 2));
  EXPECT_EQ(packed(values).size(), 400U);
}

TEST(Quantised, RoundsAndStandsWhatIsNoNumber) {
  EXPECT_EQ(quantised(1.2346, 1e-3), 1235);
  EXPECT_EQ(quantised(-1.2346, 1e-3), -1235);
  EXPECT_EQ(quantised(std::nan(""), 1e-3), 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantised(kInfinity, 1e-3), std::int64_t{1} << 50);
  EXPECT_EQ(quantised(-kInfinity, 1e-3), -(std::int64_t{1} << 50));
}

}  // namespace setsquare::map_report_packing_test
