// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/map_file/range_packing.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace setsquare::map_file {
namespace {

/// How a scan's ranges are stored. For whole numbers the number of decimals follows as a byte.
enum class RangeForm : std::uint8_t { kDouble, kFloat, kWhole16, kWhole32 };

/// By the number of decimals.
constexpr std::array kUnitsPerMetre = {1.0, 10.0, 100.0, 1e3, 1e4};

bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <typename Whole>
double range_from(Whole number, double units_per_m) {
  constexpr Whole kInfinity = std::numeric_limits<Whole>::max();
  constexpr Whole kNan = kInfinity - 1;
  if (number == kInfinity) return std::numeric_limits<double>::infinity();
  if (number == kNan) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(number) / units_per_m;  // Rounded as the decimals were when read.
}

/// Nothing where no such number gives the range again.
template <typename Whole>
std::optional<Whole> whole_from(double range_m, double units_per_m) {
  constexpr Whole kInfinity = std::numeric_limits<Whole>::max();
  constexpr Whole kNan = kInfinity - 1;
  const double number = std::round(range_m * units_per_m);
  const auto whole = std::isnan(range_m)     ? kNan
                     : !(number >= 0.0)      ? Whole{0}
                     : number < double{kNan} ? static_cast<Whole>(number)
                                             : kInfinity;
  if (!is_same(range_from(whole, units_per_m), range_m)) return std::nullopt;
  return whole;
}

template <typename Value>
void append_values(ByteWriter& bytes, const std::vector<Value>& values) {
  bytes.append({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

/// Appends nothing and returns false where a range is none of the form.
template <typename Whole>
bool append_whole(ByteWriter& bytes, RangeForm form, const std::vector<double>& ranges_m) {
  std::vector<Whole> numbers;
  numbers.reserve(ranges_m.size());
  for (std::size_t decimals = 0; decimals < kUnitsPerMetre.size(); ++decimals) {
    numbers.clear();
    for (const double range_m : ranges_m) {
      const auto whole = whole_from<Whole>(range_m, kUnitsPerMetre[decimals]);
      if (!whole) break;
      numbers.push_back(*whole);
    }
    if (numbers.size() < ranges_m.size()) continue;
    bytes.write(static_cast<std::uint8_t>(form));
    bytes.write(static_cast<std::uint8_t>(decimals));
    append_values(bytes, numbers);
    return true;
  }
  return false;
}

bool append_floats(ByteWriter& bytes, const std::vector<double>& ranges_m) {
  std::vector<float> floats;
  floats.reserve(ranges_m.size());
  for (const double range_m : ranges_m) {
    const bool fits =
        !(std::abs(range_m) > double{std::numeric_limits<float>::max()}) || std::isinf(range_m);
    if (!fits || !is_same(double{static_cast<float>(range_m)}, range_m)) return false;
    floats.push_back(static_cast<float>(range_m));
  }
  bytes.write(static_cast<std::uint8_t>(RangeForm::kFloat));
  append_values(bytes, floats);
  return true;
}

/// Reads as many numbers as there are ranges, each made one by `range_of`.
template <typename Value, typename RangeOf>
bool read_values(ByteCursor& bytes,
                 std::size_t num_ranges,
                 std::vector<double>& ranges_m,
                 RangeOf range_of) {
  const std::string_view raw = bytes.take(num_ranges * sizeof(Value));
  if (bytes.is_short()) return false;
  ranges_m.resize(num_ranges);
  for (std::size_t i = 0; i < num_ranges; ++i) {
    Value value{};
    std::memcpy(&value, raw.data() + i * sizeof(Value), sizeof(Value));
    ranges_m[i] = range_of(value);
  }
  return true;
}

template <typename Whole>
bool read_whole(ByteCursor& bytes, std::size_t num_ranges, std::vector<double>& ranges_m) {
  const auto decimals = bytes.read<std::uint8_t>();
  if (decimals >= kUnitsPerMetre.size()) return false;
  return read_values<Whole>(bytes, num_ranges, ranges_m, [&](Whole number) {
    return range_from(number, kUnitsPerMetre[decimals]);
  });
}

}  // namespace

void append_packed_ranges(ByteWriter& bytes, const std::vector<double>& ranges_m) {
  bytes.write(static_cast<std::uint32_t>(ranges_m.size()));
  if (append_whole<std::uint16_t>(bytes, RangeForm::kWhole16, ranges_m)) return;
  if (append_floats(bytes, ranges_m)) return;
  if (append_whole<std::uint32_t>(bytes, RangeForm::kWhole32, ranges_m)) return;
  bytes.write(static_cast<std::uint8_t>(RangeForm::kDouble));
  append_values(bytes, ranges_m);
}

bool read_packed_ranges(ByteCursor& bytes, std::vector<double>& ranges_m) {
  const auto num_ranges = bytes.read<std::uint32_t>();
  switch (static_cast<RangeForm>(bytes.read<std::uint8_t>())) {
    case RangeForm::kDouble:
      return read_values<double>(bytes, num_ranges, ranges_m, [](double range) { return range; });
    case RangeForm::kFloat:
      return read_values<float>(bytes, num_ranges, ranges_m, [](float range) { return range; });
    case RangeForm::kWhole16:
      return read_whole<std::uint16_t>(bytes, num_ranges, ranges_m);
    case RangeForm::kWhole32:
      return read_whole<std::uint32_t>(bytes, num_ranges, ranges_m);
  }
  return false;
}

}  // namespace setsquare::map_file
