// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/wire_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "setsquare/io/ros/cdr_writer.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::wire_reader_test {

using ros::CdrWriter;
using ros::WireReader;
using ::testing::HasSubstr;

const std::string kLittleEndian("\0\1\0\0", 4);

TEST(WireReader, CdrValuesBeginAtMultiplesOfTheirSize) {
  CdrWriter writer;
  writer.write<std::uint8_t>(7);
  writer.write<double>(2.5);
  writer.write_text("abc");
  writer.write<std::uint16_t>(9);
  writer.write_sequence<float>(std::array{1.0F, 2.0F});
  writer.write_sequence<double>({});
  writer.write<std::uint8_t>(8);
  const std::string body = std::string("\7\0\0\0\0\0\0\0", 8) +
                           std::string("\0\0\0\0\0\0\4\x40", 8) +
                           std::string("\4\0\0\0abc\0\x09\0\0\0\2\0\0\0", 16) +
                           std::string("\0\0\x80\x3f\0\0\0\x40\0\0\0\0\x08", 13);
  EXPECT_EQ(writer.message(), kLittleEndian + body);
  WireReader reader(writer.message(), MessageEncoding::kCdr);
  EXPECT_EQ(reader.read<std::uint8_t>(), 7);
  EXPECT_EQ(reader.read<double>(), 2.5);
  EXPECT_EQ(reader.read_text(), "abc");
  EXPECT_EQ(reader.read<std::uint16_t>(), 9);
  EXPECT_EQ(reader.read_array(reader.read_count(4), 4), body.substr(32, 8));
  EXPECT_EQ(reader.read_count(8), 0U);
  EXPECT_EQ(reader.read_array(0, 8), "");
  EXPECT_EQ(reader.read<std::uint8_t>(), 8);
  EXPECT_FALSE(reader.has_failed());
  EXPECT_EQ(reader.num_left(), 0U);
}

TEST(WireReader, BigEndianCdrIsReadToo) {
  const std::string message = std::string("\0\0\0\0", 4) + std::string("\1\2\0\0", 4) +
                              std::string("\0\0\0\3ab\0\0", 8) +
                              std::string("\x3f\xc0\0\0\0\0\0\0", 8);
  WireReader reader(message, MessageEncoding::kCdr);
  EXPECT_EQ(reader.read<std::uint16_t>(), 0x0102);
  EXPECT_EQ(reader.read_text(), "ab");
  EXPECT_EQ(reader.read<float>(), 1.5F);
  EXPECT_TRUE(reader.is_swapped());
}

TEST(WireReader, Ros1HasNoGapsAndNoClosingZeros) {
  const std::string message("\7\1\2\2\0\0\0abc", 10);
  WireReader reader(message, MessageEncoding::kRos1);
  EXPECT_EQ(reader.read<std::uint8_t>(), 7);
  EXPECT_EQ(reader.read<std::uint16_t>(), 0x0201);
  EXPECT_EQ(reader.read_text(), "ab");
  EXPECT_EQ(reader.num_left(), 1U);
}

TEST(WireReader, OtherEncodingsAreRefusedByReason) {
  const auto failure = [](const std::string& message, MessageEncoding encoding) {
    return std::string(WireReader(message, encoding).failure());
  };
  EXPECT_THAT(failure("", MessageEncoding::kCdr), HasSubstr("shorter than the CDR header"));
  EXPECT_THAT(failure(std::string("\0\1\0", 3), MessageEncoding::kCdr), HasSubstr("shorter"));
  for (char representation = 2; representation < 12; ++representation) {
    const std::string message{'\0', representation, '\0', '\0', 'x'};
    EXPECT_THAT(failure(message, MessageEncoding::kCdr), HasSubstr("XCDR2")) << int{representation};
  }
  EXPECT_THAT(failure("{}", MessageEncoding::kOther), HasSubstr("encoding"));
  EXPECT_EQ(failure(std::string("\0\1\x12\x34", 4), MessageEncoding::kCdr), "");
}

TEST(WireReader, TheFirstFailureIsRemembered) {
  const std::string message(
      "\xff\xff\xff\xff"
      "abcdefgh",
      12);
  WireReader reader(message, MessageEncoding::kRos1);
  EXPECT_EQ(reader.read_count(1), 0U);
  EXPECT_THAT(std::string(reader.failure()), HasSubstr("sequence"));
  EXPECT_EQ(reader.read<std::uint32_t>(), 0U);
  EXPECT_EQ(reader.read_text(), "");
  EXPECT_EQ(reader.read_array(1, 1), "");
  EXPECT_THAT(std::string(reader.failure()), HasSubstr("sequence"));
}

/// One value of a random kind, written or read and compared.
struct Value {
  int kind = 0;
  double number = 0.0;
  std::string text;
  std::vector<float> floats;

  void write(CdrWriter& writer) const {
    if (kind == 0) writer.write(static_cast<std::uint8_t>(number));
    if (kind == 1) writer.write(static_cast<std::int16_t>(number));
    if (kind == 2) writer.write(static_cast<std::int32_t>(number));
    if (kind == 3) writer.write(number);
    if (kind == 4) writer.write_text(text);
    if (kind == 5) writer.write_sequence<float>(floats);
  }
  void expect_read(WireReader& reader) const {
    if (kind == 0) {
      EXPECT_EQ(reader.read<std::uint8_t>(), number);
    }
    if (kind == 1) {
      EXPECT_EQ(reader.read<std::int16_t>(), number);
    }
    if (kind == 2) {
      EXPECT_EQ(reader.read<std::int32_t>(), number);
    }
    if (kind == 3) {
      EXPECT_EQ(reader.read<double>(), number);
    }
    if (kind == 4) {
      EXPECT_EQ(reader.read_text(), text);
    }
    if (kind != 5) return;
    const std::size_t count = reader.read_count(sizeof(float));
    ASSERT_EQ(count, floats.size());
    const std::string_view bytes = reader.read_array(count, sizeof(float));
    const std::string_view expected(reinterpret_cast<const char*>(floats.data()), count * 4);
    EXPECT_EQ(bytes, expected);
  }
};

TEST(WireReader, ReadsWhatCdrWriterWrote) {
  auto generator = testing::make_generator();
  for (int round = 0; round < 100; ++round) {
    CdrWriter writer;
    std::vector<Value> values(1 + generator() % 8);
    for (Value& value : values) {
      value = {static_cast<int>(generator() % 6),
               static_cast<double>(generator() % 256),
               std::string(generator() % 6, 'x'),
               std::vector<float>(generator() % 4, 1.5F)};
      value.write(writer);
    }
    const std::string message = writer.message();
    WireReader whole(message, MessageEncoding::kCdr);
    for (const Value& value : values) value.expect_read(whole);
    EXPECT_FALSE(whole.has_failed()) << testing::test_seed();
    EXPECT_EQ(whole.num_left(), 0U);
  }
}

}  // namespace setsquare::wire_reader_test
