// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

/// What every format has in common: reads the log's head (its first scans) to choose the front
/// laser and to settle each laser's mounting, then hands the records on.
class SelectingLogReader final : public LogReader {
 public:
  SelectingLogReader(std::unique_ptr<RecordStream> stream,
                     std::string name,
                     const LogOptions& options);

  const LogRecord* next() override;
  const LogProblems& problems() const override { return stream_->problems(); }
  std::string front_sensor() const override { return front_sensor_; }
  std::string format() const override { return stream_->format(); }
  std::optional<double> fraction_read() const override { return stream_->fraction_read(); }
  RecordingOverview overview() const override { return stream_->overview(); }

 private:
  struct Mounting {
    Pose2 T_base_sensor;
    double rounding = 0.0;
    bool is_varying = false;
  };

  void read_head();
  void settle_mountings(const std::map<std::string, std::vector<Pose2>>& measured,
                        const std::map<std::string, double>& rounding);
  [[nodiscard]] bool is_wanted(const LogRecord& record) const;
  void apply_mounting(LogRecord& record);
  void remark_varying(Mounting& mounting, const LogRecord& record);
  [[nodiscard]] const LogRecord* finish();

  std::unique_ptr<RecordStream> stream_;
  std::string name_;
  LogOptions options_;
  bool is_head_read_ = false;
  bool is_end_reported_ = false;
  std::deque<LogRecord> head_;
  LogRecord current_;
  std::map<std::string, Mounting> mountings_;
  std::string front_sensor_;
  std::uint64_t num_scans_handed_on_ = 0;
};

}  // namespace setsquare
