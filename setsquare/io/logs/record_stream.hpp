// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// The records of one format as they stand in the file: every laser, each mounting as its own
/// record gives it. What LogReader adds is the same for every format.
class RecordStream {
 public:
  virtual ~RecordStream() = default;

  /// Reads the next record into `record`, whose vectors are used again; false at the end. Skips
  /// damaged records and counts them in problems(). Throws FileError.
  [[nodiscard]] virtual bool read(LogRecord& record) = 0;

  /// The unit to which the poses behind the last scan's mounting were rounded (m and rad); 0 where
  /// the log states the mounting itself.
  [[nodiscard]] virtual double mounting_rounding() const = 0;

  /// Whether odometry is summed up from increments, so that it began at the identity with the
  /// first scan.
  [[nodiscard]] virtual bool is_odometry_summed() const { return false; }

  [[nodiscard]] virtual std::string format() const = 0;

  /// How much has been read, 0 to 1; nothing where the size is unknown.
  [[nodiscard]] virtual std::optional<double> fraction_read() const = 0;

  /// Why the bytes ended before their time; empty if they did not.
  [[nodiscard]] virtual std::string damage() const { return {}; }

  /// What else is in a recording of messages; empty for other logs.
  [[nodiscard]] virtual RecordingOverview overview() const { return {}; }

  [[nodiscard]] const LogProblems& problems() const { return problems_; }
  [[nodiscard]] LogProblems& problems() { return problems_; }

 private:
  LogProblems problems_;
};

/// More beams than any scanner has: such a record is damaged.
inline constexpr std::uint32_t kMaxBeams = 65536;

/// From a scan's first beam to its last: no scanner takes longer.
inline constexpr double kLongestSweep_s = 10.0;

/// Stamps beyond this (the year 2112) are damaged; below, differences of two cannot overflow.
inline constexpr std::int64_t kMaxStamp_ns = 4'500'000'000'000'000'000;

/// The range from which beams are no-returns where neither log nor options say: the lowest code of
/// SICK scanners for "nothing seen" (81.83 and 81.91 elsewhere).
inline constexpr double kUnstatedMaxRange_m = 50.0;

/// Whether a stamp is within kMaxStamp_ns.
[[nodiscard]] inline bool is_possible(Timestamp stamp) {
  return stamp.ns <= kMaxStamp_ns && stamp.ns >= -kMaxStamp_ns;
}

/// Whether Scan::validate() accepts the scan.
[[nodiscard]] bool has_valid_geometry(const Scan& scan);

/// Makes a record that was used before into an empty one of a sensor; its ranges keep their memory.
void start_record(LogRecord& record, std::string_view sensor);

}  // namespace setsquare
