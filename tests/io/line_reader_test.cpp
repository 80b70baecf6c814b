// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/line_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/io/read_all.hpp"

namespace setsquare::line_reader_test {

using ::testing::ElementsAre;

std::vector<std::string> lines_of(const std::string& text, std::size_t num_bytes_at_once) {
  InputBuffer input(std::make_unique<testing::TricklingSource>(text, num_bytes_at_once));
  LineReader reader(input);
  std::vector<std::string> lines;
  while (const auto line = reader.next()) lines.emplace_back(*line);
  return lines;
}

TEST(LineReader, LinesDoNotDependOnHowBytesArrive) {
  for (const std::size_t at_once : {1, 2, 3, 7, 1000}) {
    EXPECT_THAT(lines_of("one\ntwo\r\n\nlast", at_once), ElementsAre("one", "two", "", "last"));
    EXPECT_THAT(lines_of("one\n", at_once), ElementsAre("one"));
    EXPECT_THAT(lines_of("", at_once), ElementsAre());
    EXPECT_THAT(lines_of("\n", at_once), ElementsAre(""));
  }
}

TEST(LineReader, CountsLinesFromOne) {
  InputBuffer input(make_memory_source("a\nb\n"));
  LineReader reader(input);
  static_cast<void>(reader.next());
  EXPECT_EQ(reader.line_number(), 1U);
  static_cast<void>(reader.next());
  EXPECT_EQ(reader.line_number(), 2U);
}

TEST(LineReader, AnEndlessLineIsCutMarkedAndPassedOver) {
  for (const std::size_t length : {LineReader::kMaxLineBytes + 1, 3 * LineReader::kMaxLineBytes}) {
    InputBuffer input(make_memory_source("a\n" + std::string(length, 'x') + "\nb\n"));
    LineReader reader(input);
    EXPECT_EQ(reader.next(), "a");
    EXPECT_EQ(reader.next()->size(), LineReader::kMaxLineBytes);
    EXPECT_TRUE(reader.is_too_long());
    EXPECT_EQ(reader.next(), "b");
    EXPECT_FALSE(reader.is_too_long());
    EXPECT_EQ(reader.line_number(), 3U);
    EXPECT_FALSE(reader.next());
  }
}

TEST(LineReader, TheLongestLineIsWhole) {
  const std::string longest(LineReader::kMaxLineBytes, 'x');
  InputBuffer input(make_memory_source(longest + "\nb"));
  LineReader reader(input);
  EXPECT_EQ(reader.next(), longest);
  EXPECT_FALSE(reader.is_too_long());
  EXPECT_EQ(reader.next(), "b");
}

}  // namespace setsquare::line_reader_test
