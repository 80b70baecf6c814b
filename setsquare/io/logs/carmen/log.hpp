// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/logs/carmen/line.hpp"
#include "setsquare/io/logs/line_log.hpp"

namespace setsquare {

/// The records of a CARMEN log: one message per line (read_carmen_line).
class CarmenLog final : public LineLog {
 public:
  CarmenLog(std::unique_ptr<InputBuffer> input, const LogOptions& options);

  double mounting_rounding() const override { return state_.pose_rounding; }
  std::string format() const override { return "CARMEN log"; }

 protected:
  LineOutcome read_line(std::string_view line, LogRecord& record) override;
  std::string reason(std::string_view line) const override;

 private:
  CarmenState state_;
};

}  // namespace setsquare
