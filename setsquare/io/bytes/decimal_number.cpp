// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/decimal_number.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace setsquare {
namespace {

static_assert(std::endian::native == std::endian::little, "the first character is the lowest byte");

constexpr std::uint64_t kEachByte = 0x0101010101010101;
constexpr int kBlock = 8;

/// Powers of ten that a double holds exactly and that the digits of two blocks can need.
constexpr std::array<double, 15> kPowersOfTen = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
constexpr std::array<std::uint64_t, 8> kWholePowersOfTen = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000};

/// Eight characters at once, the first in the lowest byte.
struct CharacterBlock {
  explicit CharacterBlock(const char* first) {
    std::memcpy(&digits, first, sizeof digits);
    digits ^= kEachByte * '0';
    others = (((digits & (kEachByte * 0x7f)) + kEachByte * 0x76) | digits) & (kEachByte * 0x80);
  }

  std::uint64_t digits = 0;  ///< A byte each: 0 to 9, or more where the character is no digit.
  std::uint64_t others = 0;  ///< The highest bit of each byte that is no digit.
};

/// How many bytes lie before the first that is marked; 8 where none is.
int bytes_before(std::uint64_t marked) { return std::countr_zero(marked) / 8; }

/// The lowest `count` bytes, at most seven.
std::uint64_t lowest_bytes(int count) { return (std::uint64_t{1} << (8 * count)) - 1; }

/// The number whose digits are the lowest `count` bytes, one to eight: pairs of digits are summed,
/// then pairs of pairs, then both halves.
std::uint64_t number_of(std::uint64_t digits, int count) {
  digits <<= 64 - 8 * count;
  const std::uint64_t pairs = (digits * 10 + (digits >> 8U)) & 0x00ff'00ff'00ff'00ff;
  const std::uint64_t fours = (pairs * 100 + (pairs >> 16U)) & 0x0000'ffff'0000'ffff;
  return (fours * 10'000 + (fours >> 32U)) & 0xffff'ffff;
}

/// "12.345", with at least eight characters to look at, of at most 14 digits of which at most seven
/// stand before the point: both the digits and the power of ten are exact doubles, so their
/// quotient is the correctly rounded number (Clinger 1990). Null where the text is of another form.
const char* read_short_decimal(const char* first, const char* last, double& number) {
  if (last - first < kBlock) return nullptr;
  const CharacterBlock block(first);
  const int num_whole = bytes_before(block.others);
  if (num_whole == kBlock) return nullptr;
  int num_characters = num_whole;
  int num_digits = num_whole;
  std::uint64_t digits = block.digits;
  if (first[num_whole] == '.') {
    num_characters = bytes_before(block.others & (block.others - 1));
    num_digits = num_characters - 1;
    const std::uint64_t whole = lowest_bytes(num_whole);
    digits = (digits & whole) | ((digits >> 8U) & ~whole);
  }
  if (num_digits == 0) return nullptr;
  std::uint64_t value = number_of(digits, num_digits);
  if (num_characters == kBlock) {
    if (last - first < 2 * kBlock) return nullptr;
    const CharacterBlock rest(first + kBlock);
    const int num_more = bytes_before(rest.others);
    if (num_more == kBlock) return nullptr;
    if (num_more > 0) {
      value = value * kWholePowersOfTen[static_cast<std::size_t>(num_more)] +
              number_of(rest.digits, num_more);
    }
    num_digits += num_more;
    num_characters += num_more;
  }
  if ((first[num_characters] | 0x20) == 'e') return nullptr;
  number =
      static_cast<double>(value) / kPowersOfTen[static_cast<std::size_t>(num_digits - num_whole)];
  return first + num_characters;
}

}  // namespace

const char* read_number(const char* first, const char* last, double& number) {
  const bool is_negative = first != last && *first == '-';
  if (const char* const end = read_short_decimal(first + is_negative, last, number)) {
    if (is_negative) number = -number;
    return end;
  }
  const auto [end, error] = std::from_chars(first, last, number);
  return error == std::errc{} ? end : nullptr;
}

std::optional<double> decimal_from_text(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const char* const end = text.data() + text.size();
  return read_number(text.data(), end, number) == end ? std::optional(number) : std::nullopt;
}

}  // namespace setsquare
