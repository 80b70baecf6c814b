// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/decoding_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "setsquare/io/ros/cdr_writer.hpp"

namespace setsquare::decoding_plan_test {

using ros::CdrWriter;
using ros::DecodingPlan;
using ros::FieldColumns;
using ros::FieldKind;
using ros::parse_message_definition;
using ros::WantedField;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kLine = std::string(80, '=') + "\nMSG: ";

DecodingPlan plan(const std::string& definition,
                  const std::vector<WantedField>& wanted,
                  MessageEncoding encoding = MessageEncoding::kCdr) {
  return {parse_message_definition("a/B", definition), encoding, wanted};
}

std::string fault(const std::string& definition, const std::vector<WantedField>& wanted) {
  return plan(definition, wanted).fault();
}

/// Fields of every kind before, between and behind those that are wanted.
const std::string kMixture =
    "uint8 a\nfloat64 b\nstring c\nPart[] parts\nfloat32[] ranges\nwstring w\nuint16[3] d\n"
    "string[2] e\nEmpty f\nEmpty[] g\nbuiltin_interfaces/Time[] times\nint8 last\n" +
    kLine + "a/Part\nint64 skipped\nstring name\nint16 x\n" + kLine + "a/Empty\n";

std::string mixture(bool has_parts) {
  CdrWriter writer;
  writer.write<std::uint8_t>(1);
  writer.write<double>(2.5);
  writer.write_text("hello");
  writer.write_count(has_parts ? 2 : 0);
  for (int i = 0; has_parts && i < 2; ++i) {
    writer.write<std::int64_t>(99);
    writer.write_text(i == 0 ? "first" : "second one");
    writer.write<std::int16_t>(static_cast<std::int16_t>(i - 5));
  }
  writer.write_sequence<float>(std::vector<float>{1.5F, -2.5F});
  writer.write_sequence<std::uint32_t>(std::vector<std::uint32_t>{'a', 'b', 'c'});
  for (int i = 0; i < 3; ++i) writer.write<std::uint16_t>(7);
  writer.write_text("");
  writer.write_text("xyz");
  writer.write<std::uint8_t>(0);
  writer.write_sequence<std::uint8_t>(std::vector<std::uint8_t>{0, 0, 0});
  writer.write_count(2);
  for (int i = 0; i < 2; ++i) {
    writer.write<std::int32_t>(i == 0 ? -1 : 5);
    writer.write<std::uint32_t>(1'500'000'000);
  }
  writer.write<std::int8_t>(-3);
  return writer.message();
}

const std::vector<WantedField> kWanted = {{"last", FieldKind::kNumber},
                                          {"parts.x", FieldKind::kNumber},
                                          {"parts.name", FieldKind::kText},
                                          {"ranges", FieldKind::kArray},
                                          {"b", FieldKind::kNumber},
                                          {"times", FieldKind::kTime}};

TEST(DecodingPlan, TakesTheWantedFieldsAndStepsOverTheOthers) {
  const DecodingPlan mixed = plan(kMixture, kWanted);
  ASSERT_THAT(mixed.fault(), IsEmpty());
  FieldColumns columns;
  const std::string message = mixture(true);
  ASSERT_EQ(mixed.run(message, columns), "");
  EXPECT_THAT(columns[0].numbers, ElementsAre(-3.0));
  EXPECT_THAT(columns[1].numbers, ElementsAre(-5.0, -4.0));
  EXPECT_THAT(columns[2].texts, ElementsAre("first", "second one"));
  ASSERT_EQ(columns[3].arrays.size(), 1U);
  std::vector<double> ranges;
  columns[3].arrays[0].copy_to(ranges);
  EXPECT_THAT(ranges, ElementsAre(1.5, -2.5));
  EXPECT_THAT(columns[4].numbers, ElementsAre(2.5));
  EXPECT_THAT(columns[5].times, ElementsAre(Timestamp{500'000'000}, Timestamp{6'500'000'000}));
}

TEST(DecodingPlan, ColumnsHoldOneMessageOnly) {
  const DecodingPlan mixed = plan(kMixture, kWanted);
  FieldColumns columns;
  ASSERT_EQ(mixed.run(mixture(true), columns), "");
  ASSERT_EQ(mixed.run(mixture(false), columns), "");
  EXPECT_THAT(columns[0].numbers, ElementsAre(-3.0));
  EXPECT_THAT(columns[1].numbers, IsEmpty());
}

TEST(DecodingPlan, NothingWantedStillWalksTheWholeMessage) {
  const DecodingPlan none = plan(kMixture, {});
  FieldColumns columns;
  const std::string message = mixture(true);
  EXPECT_EQ(none.run(message, columns), "");
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_NE(none.run(message.substr(0, size), columns), "") << size;
  }
}

TEST(DecodingPlan, DefinitionsThatLackWhatIsWantedAreToldByReason) {
  const std::vector<WantedField> x = {{"part.x", FieldKind::kNumber}};
  EXPECT_THAT(fault("float32 y", x), HasSubstr("a/B has no field part.x"));
  EXPECT_THAT(fault("float32 part", x), HasSubstr("no field part.x"));
  EXPECT_THAT(fault("Part part", x), HasSubstr("lacks that of its part Part"));
  EXPECT_THAT(fault("Part part\n" + kLine + "a/Part\nstring x", x), HasSubstr("of another kind"));
  EXPECT_THAT(fault("Part part\n" + kLine + "a/Part\nint8[] x", x), HasSubstr("of another kind"));
  EXPECT_THAT(fault("Part part\n" + kLine + "a/Part\nint8 x", x), IsEmpty());
  EXPECT_THAT(fault("float32", x), HasSubstr("a line that is no field"));
}

TEST(DecodingPlan, DefinitionsWithoutEndAreRefused) {
  EXPECT_THAT(fault("a/B again", {}), HasSubstr("contains itself"));
  EXPECT_THAT(fault("a/B[] again", {}), HasSubstr("contains itself"));
  std::string tower = "T0 t\n";
  for (int i = 0; i < 20; ++i) {
    tower += kLine + "a/T" + std::to_string(i) + "\n";
    for (int k = 0; k < 10; ++k) {
      tower += "T" + std::to_string(i + 1) + "[9] t" + std::to_string(k) + "\n";
    }
  }
  EXPECT_THAT(fault(tower + kLine + "a/T20\nint8 x", {}), HasSubstr("too many fields"));
}

TEST(DecodingPlan, CountsThatLieCostNothing) {
  const std::string nested = "A[4294967295] a\nuint8[0] none\n" + kLine + "a/A\nC[4294967295] c\n" +
                             kLine + "a/C\nint8[4294967295] x\n";
  FieldColumns columns;
  EXPECT_THAT(std::string(plan(nested, {}).run(std::string("\0\1\0\0abcd", 8), columns)),
              HasSubstr("before the last element"));
  // Elements without a byte: as many as the message says, without reading one.
  const std::string empties = "Empty[] a\nEmpty[4294967295] b\nint8 x\n" + kLine + "a/Empty\n";
  const DecodingPlan ros1 = plan(empties, {{"x", FieldKind::kNumber}}, MessageEncoding::kRos1);
  ASSERT_THAT(ros1.fault(), IsEmpty());
  EXPECT_EQ(ros1.run("\xff\xff\xff\xff\x07", columns), "");
  EXPECT_THAT(columns[0].numbers, ElementsAre(7.0));
}

}  // namespace setsquare::decoding_plan_test
