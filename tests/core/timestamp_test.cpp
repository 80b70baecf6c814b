// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/timestamp.hpp"

#include <gtest/gtest.h>

#include <string>

namespace setsquare::timestamp_test {

TEST(Timestamp, ReadsDecimalSecondsExactly) {
  EXPECT_EQ(timestamp_from_decimal("976052857.337530")->ns, 976052857337530000);
  EXPECT_EQ(timestamp_from_decimal("70")->ns, 70'000'000'000);
  EXPECT_EQ(timestamp_from_decimal("0.000000001")->ns, 1);
  EXPECT_EQ(timestamp_from_decimal("-0.5")->ns, -500'000'000);
  EXPECT_EQ(timestamp_from_decimal("1.")->ns, 1'000'000'000);
}

TEST(Timestamp, ReadsFinerUnits) {
  const auto ms = [](const char* text) {
    return timestamp_from_decimal(text, StampUnit::kMilliseconds);
  };
  EXPECT_EQ(ms("1764350400123.25")->ns, 1764350400123250000);
  EXPECT_EQ(ms("7")->ns, 7'000'000);
  EXPECT_EQ(ms("-0.5")->ns, -500'000);
  EXPECT_EQ(timestamp_from_decimal("1764350400123456", StampUnit::kMicroseconds)->ns,
            1764350400123456000);
  EXPECT_EQ(timestamp_from_decimal("1764350400123456789", StampUnit::kNanoseconds)->ns,
            1764350400123456789);
  EXPECT_EQ(timestamp_from_decimal("12", StampUnit::kNanoseconds)->ns, 12);
  for (const char* text : {"", "-", "x", ".5", "1.2.3", "1e9"}) EXPECT_FALSE(ms(text)) << text;
}

TEST(Timestamp, RoundsDigitsBeyondTheNinth) {
  EXPECT_EQ(timestamp_from_decimal("0.0000000014")->ns, 1);
  EXPECT_EQ(timestamp_from_decimal("0.0000000015")->ns, 2);
  EXPECT_EQ(timestamp_from_decimal("0.9999999999")->ns, 1'000'000'000);
}

TEST(Timestamp, RefusesWhatIsNoPlainDecimal) {
  for (const char* text : {"",
                           "-",
                           ".5",
                           "x",
                           "1.2.3",
                           "1e9",
                           " 1",
                           "1 ",
                           "nan",
                           "+1",
                           "--1",
                           "9223372036854775807",
                           "99999999999999999999"}) {
    EXPECT_FALSE(timestamp_from_decimal(text).has_value()) << '"' << text << '"';
  }
}

TEST(Timestamp, WritesSixDecimals) {
  EXPECT_EQ(to_string(Timestamp{976052857337530000}), "976052857.337530");
  EXPECT_EQ(to_string(Timestamp{1'499}), "0.000001");
  EXPECT_EQ(to_string(Timestamp{1'500}), "0.000002");
  EXPECT_EQ(to_string(Timestamp{-1'500'000'000}), "-1.500000");
  EXPECT_EQ(to_string(Timestamp{-100}), "0.000000");
}

TEST(Timestamp, WritingAndReadingRoundTrips) {
  for (const char* text : {"976053254.398669", "70.000001", "0.000000", "-3.250000"}) {
    EXPECT_EQ(to_string(*timestamp_from_decimal(text)), text);
  }
}

TEST(Timestamp, DifferencesOfLargeStampsAreExact) {
  const Timestamp earlier = *timestamp_from_decimal("976052857.337530");
  const Timestamp later = *timestamp_from_decimal("976052857.337531");
  EXPECT_DOUBLE_EQ(seconds_between(earlier, later), 1e-6);
  EXPECT_LT(earlier, later);
}

TEST(Timestamp, SecondsRoundToTheNearestNanosecond) {
  EXPECT_EQ(timestamp_from_seconds(1.25).ns, 1'250'000'000);
  EXPECT_EQ(timestamp_from_seconds(-0.25).ns, -250'000'000);
}

}  // namespace setsquare::timestamp_test
