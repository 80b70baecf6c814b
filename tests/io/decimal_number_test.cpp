// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/decimal_number.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "tests/io/random_records.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::decimal_number_test {

/// The text in memory of exactly its size, so that a sanitizer sees a read beyond it.
void expect_like_from_chars(std::string_view text) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  if (!text.empty()) std::memcpy(exact.get(), text.data(), text.size());
  const char* const first = exact.get();
  const char* const last = first + text.size();
  double expected = 0.0;
  const auto [expected_end, error] = std::from_chars(first, last, expected);
  double number = 0.0;
  const char* const end = read_number(first, last, number);
  if (error != std::errc{}) {
    ASSERT_EQ(end, nullptr) << '"' << text << '"';
    return;
  }
  ASSERT_EQ(end, expected_end) << '"' << text << '"';
  ASSERT_EQ(testing::bits_of(number), testing::bits_of(expected)) << '"' << text << '"';
}

TEST(DecimalNumber, DecimalsOfLogsAreLikeFromChars) {
  auto generator = testing::make_generator();
  for (int i = 0; i < 1'000'000; ++i) {
    std::string text = generator() % 4 == 0 ? "-" : "";
    const auto num_whole = generator() % 10 == 0 ? generator() % 20 : generator() % 4;
    const auto num_decimals = generator() % 10 == 0 ? generator() % 20 : generator() % 7;
    for (std::uint64_t k = 0; k < num_whole; ++k) text += static_cast<char>('0' + generator() % 10);
    if (generator() % 8 != 0) text += '.';
    for (std::uint64_t k = 0; k < num_decimals; ++k)
      text += static_cast<char>('0' + generator() % 10);
    const char* const behind[] = {"", " ", " 2.5 1", ",", "\n", "e3", "E-2", "e", ".5", "x", "]"};
    expect_like_from_chars(text + behind[generator() % std::size(behind)]);
    if (HasFatalFailure()) return;
  }
}

TEST(DecimalNumber, AnyCharactersAreLikeFromChars) {
  constexpr std::string_view kCharacters =
      "0123456789012345678901234567890....--+eE nifaINF,:/\xb0\xff";
  auto generator = testing::make_generator();
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) {
    text.clear();
    const auto size = generator() % 24;
    for (std::uint64_t k = 0; k < size; ++k) text += kCharacters[generator() % kCharacters.size()];
    expect_like_from_chars(text);
    if (HasFatalFailure()) return;
  }
}

TEST(DecimalNumber, ShortestTextsOfAnyDoubleAreLikeFromChars) {
  auto generator = testing::make_generator();
  for (int i = 0; i < 200'000; ++i) {
    char text[64];
    const double number = testing::any_range(generator);
    const auto end = std::to_chars(text, text + sizeof text, number).ptr;
    expect_like_from_chars(std::string_view(text, static_cast<std::size_t>(end - text)));
    if (HasFatalFailure()) return;
  }
}

}  // namespace setsquare::decimal_number_test
