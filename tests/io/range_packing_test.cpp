// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/map_file/range_packing.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "setsquare/io/bytes/decimal_number.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::range_packing_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kHeadBytes = 5;  // The number of ranges and their form.

std::string packed(const std::vector<double>& ranges_m) {
  ByteWriter bytes;
  map_file::append_packed_ranges(bytes, ranges_m);
  return bytes.take();
}

void expect_same_bits_again(const std::vector<double>& ranges_m) {
  const std::string bytes = packed(ranges_m);
  ByteCursor cursor(bytes);
  std::vector<double> read = {1.0, 2.0};
  ASSERT_TRUE(map_file::read_packed_ranges(cursor, read));
  EXPECT_EQ(cursor.position(), bytes.size());
  ASSERT_EQ(read.size(), ranges_m.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(ranges_m[i]))
        << ranges_m[i];
  }
}

/// As a log's text gives it.
double decimal(std::uint64_t number, int num_decimals) {
  std::string text = std::to_string(number);
  text.insert(0, std::string(static_cast<std::size_t>(num_decimals), '0'));
  text.insert(text.size() - static_cast<std::size_t>(num_decimals), ".");
  return decimal_from_text(text).value();
}

TEST(RangePacking, DecimalsOfLogsTakeTwoBytesEach) {
  for (int num_decimals = 0; num_decimals <= 4; ++num_decimals) {
    std::vector<double> ranges_m;
    for (std::uint64_t number = 0; number < 65534; ++number) {
      ranges_m.push_back(decimal(number, num_decimals));
    }
    expect_same_bits_again(ranges_m);
    EXPECT_EQ(packed(ranges_m).size(), kHeadBytes + 1 + 2 * ranges_m.size());
  }
}

TEST(RangePacking, LongerDecimalsAndFloatsTakeFourBytesEach) {
  auto generator = testing::make_generator();
  std::vector<double> millimetres;
  std::vector<double> floats;
  for (int i = 0; i < 10000; ++i) {
    millimetres.push_back(decimal(generator() % 100'000'000, 3));
    floats.push_back(double{static_cast<float>(testing::uniform(generator, 0.0, 100.0))});
  }
  for (const auto& ranges_m : {millimetres, floats}) {
    expect_same_bits_again(ranges_m);
    EXPECT_LE(packed(ranges_m).size(), kHeadBytes + 1 + 4 * ranges_m.size());
  }
}

TEST(RangePacking, CodesAndOddNumbersComeBackBitForBit) {
  expect_same_bits_again({});
  for (const double odd : {kInfinity,
                           -kInfinity,
                           kNan,
                           -kNan,
                           std::bit_cast<double>(std::uint64_t{0x7ff0000000000001}),
                           std::bit_cast<double>(std::uint64_t{0x7ff8000000000123}),
                           0.0,
                           -0.0,
                           -1.0,
                           655.33,
                           655.34,
                           655.35,
                           6.5534,
                           4294967294.0,
                           4294967295.0,
                           1e300,
                           -1e300,
                           3.5e38,
                           std::numeric_limits<double>::denorm_min(),
                           double{std::numeric_limits<float>::max()},
                           std::nextafter(1.23, 2.0)}) {
    expect_same_bits_again({odd});
    expect_same_bits_again({1.23, odd, 4.56});
    expect_same_bits_again({0.123456789, odd});
  }
  EXPECT_EQ(packed({1.23, kInfinity, kNan}).size(), kHeadBytes + 1 + 2 * 3) << "as in 16 bits";
}

TEST(RangePacking, AnyBitsComeBack) {
  auto generator = testing::make_generator();
  for (int i = 0; i < 20000; ++i) {
    expect_same_bits_again({std::bit_cast<double>(std::uint64_t{generator()})});
  }
}

TEST(RangePacking, WhatIsCutShortOrNoFormIsRefused) {
  for (const std::vector<double>& ranges_m :
       {std::vector{1.23, 4.56}, std::vector{0.1234567, 3.0}, std::vector{1.5, 1000.25}}) {
    const std::string bytes = packed(ranges_m);
    std::vector<double> read;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      ByteCursor cursor(std::string_view(bytes).substr(0, length));
      const bool is_read = map_file::read_packed_ranges(cursor, read);
      EXPECT_TRUE(!is_read || cursor.is_short()) << length;
    }
    std::string other = bytes;
    other[4] = 9;
    ByteCursor cursor(other);
    EXPECT_FALSE(map_file::read_packed_ranges(cursor, read));
  }
}

}  // namespace setsquare::range_packing_test
