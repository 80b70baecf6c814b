// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace setsquare {

/// Sensor time of a scan's first beam: nanoseconds since the log's epoch, exact as the log wrote
/// it.
struct Timestamp {
  std::int64_t ns = 0;  ///< Nanoseconds since the log's epoch.

  /// In seconds: to 0.2 us only, where stamps count from 1970.
  [[nodiscard]] double seconds() const { return static_cast<double>(ns) * 1e-9; }

  /// Earlier stamps are less.
  auto operator<=>(const Timestamp&) const = default;
};

/// later - earlier, in seconds; exact where a difference of two large doubles is not.
[[nodiscard]] inline double seconds_between(Timestamp earlier, Timestamp later) {
  return static_cast<double>(later.ns - earlier.ns) * 1e-9;
}

/// Reads decimal seconds such as "976052857.337530"; digits beyond the ninth decimal are rounded.
/// Nothing where the text is not a plain decimal number or does not fit.
[[nodiscard]] std::optional<Timestamp> timestamp_from_decimal(std::string_view text);

/// What a stamp written as a number counts: so many digits behind the point of the seconds.
enum class StampUnit {
  kSeconds = 0,       ///< s
  kMilliseconds = 3,  ///< ms
  kMicroseconds = 6,  ///< us
  kNanoseconds = 9,   ///< ns
};

/// The same for a number of the unit: "976052857337.530" milliseconds.
[[nodiscard]] std::optional<Timestamp> timestamp_from_decimal(std::string_view text,
                                                              StampUnit unit);

/// Nearest nanosecond of a time in seconds.
[[nodiscard]] Timestamp timestamp_from_seconds(double seconds);

/// Decimal seconds with six decimals, rounded to the nearest microsecond: "976052857.337530".
[[nodiscard]] std::string to_string(Timestamp stamp);

}  // namespace setsquare
