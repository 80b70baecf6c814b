// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "setsquare/io/bytes/line_reader.hpp"
#include "setsquare/io/logs/carmen/line.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// The records of a CARMEN log: one message per line (read_carmen_line).
class CarmenLog final : public RecordStream {
 public:
  CarmenLog(std::unique_ptr<InputBuffer> input, const LogOptions& options);

  bool read(LogRecord& record) override;
  double mounting_rounding() const override { return state_.pose_rounding; }
  std::string format() const override { return "CARMEN log"; }
  std::optional<double> fraction_read() const override { return input_->source().fraction_read(); }
  std::string damage() const override { return input_->source().damage(); }

 private:
  std::unique_ptr<InputBuffer> input_;
  LineReader lines_;
  CarmenState state_;
};

}  // namespace setsquare
