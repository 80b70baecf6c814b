// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "setsquare/io/log_problems.hpp"
#include "setsquare/io/log_record.hpp"

namespace setsquare {

/// What to read of a log, and what the log itself does not tell.
struct LogOptions {
  /// Which laser's scans: its name in the log, "all", or empty for the front one (the laser whose
  /// mounting looks most nearly forward; of equal ones the first by name).
  std::string sensor;
  bool scans_only = true;  ///< Leave out the records of kinds other than kScan.
  /// Angles of a message that carries none (FLASER, RLASER): the sweep is symmetric about straight
  /// ahead. By default 180 degrees, whose step is field of view / n for an even number of beams n
  /// (180, 360) and field of view / (n - 1) for an odd one (181, 361). Where only the step is
  /// given, the field of view is step * (n - 1).
  std::optional<double> field_of_view_rad;
  std::optional<double> bearing_step_rad;
  /// Ranges at or above it are no-returns. By default what the log states, else 50 m (the lowest
  /// code that logs of SICK scanners use for "nothing seen").
  std::optional<double> max_range_m;

  /// Throws ParameterError naming the field that is out of its domain.
  void validate() const;
};

/// Reads a log record by record, in file order, in bounded memory.
///
///   auto reader = open_log(path);
///   while (const LogRecord* record = reader->next()) mapper.add(record->scan);
class LogReader {
 public:
  virtual ~LogReader() = default;

  /// The next record, or null at the end. It stays valid until the next call; its vectors are used
  /// again. Damaged records are skipped and counted. Throws FileError where the file cannot be
  /// read further, FormatError at the end of a log that held no scan of the wanted sensor.
  [[nodiscard]] virtual const LogRecord* next() = 0;

  /// What was wrong so far.
  [[nodiscard]] virtual const LogProblems& problems() const = 0;

  /// The laser that LogOptions::sensor means when it is empty; empty before the first next().
  [[nodiscard]] virtual std::string front_sensor() const = 0;

  /// "CARMEN log" or "MRPT rawlog".
  [[nodiscard]] virtual std::string format() const = 0;

  /// How much of the file has been read, 0 to 1; nothing where the size is unknown (a pipe).
  [[nodiscard]] virtual std::optional<double> fraction_read() const = 0;
};

}  // namespace setsquare
