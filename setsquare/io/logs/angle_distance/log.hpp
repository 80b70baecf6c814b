// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/logs/angle_distance/revolution.hpp"
#include "setsquare/io/logs/angle_distance/row.hpp"
#include "setsquare/io/logs/line_log.hpp"

namespace setsquare {

/// The scans of rows of angles and distances: one per revolution, its beams evenly spaced by
/// resample(). Where a line is one beam, a revolution begins at the mark "S" or, in a text without
/// marks, where the angle falls back by more than half of what the revolution has swept, and by 5
/// degrees at least. Lines before the first row are passed over.
class AngleDistanceLog final : public LineLog {
 public:
  AngleDistanceLog(std::unique_ptr<InputBuffer> input, const AngleDistanceOptions& options);

  double mounting_rounding() const override { return 0.0; }
  std::string format() const override { return "rows of angles and distances"; }

 protected:
  LineOutcome read_line(std::string_view line, LogRecord& record) override;
  std::string reason(std::string_view) const override { return std::string(reason_); }
  bool read_end(LogRecord& record) override;

 private:
  [[nodiscard]] LineOutcome add_beam(LogRecord& record);
  [[nodiscard]] LineOutcome finish_revolution(LogRecord& record);
  [[nodiscard]] bool starts_revolution(double angle_rad);
  [[nodiscard]] double radians(double angle) const;
  void add(double angle_rad, double distance);
  LineOutcome fail(std::string_view reason);

  AngleDistanceOptions options_;
  AngleDistanceRow row_;
  std::vector<BearingRange> beams_;  ///< Of the revolution that is being read.
  std::uint64_t num_revolutions_ = 0;
  bool has_rows_ = false;
  bool has_marks_ = false;
  double previous_rad_ = 0.0;  ///< The angle before, as written.
  double smallest_rad_ = 0.0;  ///< Of this revolution, as written.
  double largest_rad_ = 0.0;   ///< Of this revolution, as written.
  int num_steps_up_ = 0;       ///< Steps to larger angles less those to smaller ones.
  std::string_view reason_;    ///< Static text.
};

}  // namespace setsquare
