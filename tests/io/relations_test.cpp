// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/relations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare::relations_test {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(read_relations(make_memory_source(text), "x.relations"));
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(Relations, KeepsStampsPoseOrderAndRepetitions) {
  const std::string line = "976052857.337530 976052957.5 1.5 -0.25 0.0 0.0 0.0 1.57\n";
  const auto relations =
      read_relations(make_memory_source("# comment\n\n" + line + "2 1 0 0 9 9 9 -3\n" + line), "x");
  ASSERT_THAT(relations, SizeIs(3));
  EXPECT_EQ(to_string(relations[0].reference_stamp), "976052857.337530");
  EXPECT_EQ(to_string(relations[0].current_stamp), "976052957.500000");
  EXPECT_EQ(relations[0].T_reference_current, (Pose2{1.5, -0.25, 1.57}));
  EXPECT_EQ(relations[1].T_reference_current, (Pose2{0.0, 0.0, -3.0}));
}

TEST(Relations, ADamagedLineIsNamed) {
  const std::string good = "1 2 3 4 5 6 7 8\n";
  EXPECT_THAT(error_of(good + "1 2 3 4 5 6 7\n"), HasSubstr("x.relations, line 2: expected"));
  EXPECT_THAT(error_of(good + good + "1 2 3 4 5 6 7 8 9\n"), HasSubstr("line 3"));
  EXPECT_THAT(error_of("1 2 nan 4 5 6 7 8\n"), HasSubstr("line 1"));
  EXPECT_THAT(error_of("# nothing\n"), HasSubstr("no line"));
  EXPECT_THAT(error_of(""), HasSubstr("no line"));
}

TEST(Relations, CutAtEveryOffsetIsAnErrorOrShorter) {
  const std::string text = "1.5 2.5 3 4 5 6 7 8.25\n2.5 3.5 3 4 5 6 7 8.25\n";
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    try {
      const auto relations = read_relations(make_memory_source(cut), "x");
      EXPECT_FALSE(relations.empty());
      EXPECT_LE(relations.size(), 2U);
    } catch (const FormatError&) {
      continue;
    }
  }
}

TEST(Overlaps, StampsAndShare) {
  const auto overlaps = read_overlaps(make_memory_source("# header\n1.5 2.5 0.404\n"), "x");
  ASSERT_THAT(overlaps, SizeIs(1));
  EXPECT_EQ(to_string(overlaps[0].reference_stamp), "1.500000");
  EXPECT_EQ(overlaps[0].overlap, 0.404);
}

TEST(Relations, AMissingFileIsNamed) {
  EXPECT_THROW(static_cast<void>(read_relations("/no/such.relations")), FileError);
}

}  // namespace setsquare::relations_test
