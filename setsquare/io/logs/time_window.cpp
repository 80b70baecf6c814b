// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/time_window.hpp"

#include <fmt/core.h>

#include <map>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// Seconds from here on (March 1973) are stamps, below they count from the first scan.
constexpr double kFirstStamp_s = 1e8;

class TimeWindow final : public LogReader {
 public:
  TimeWindow(const LogWindow& window, std::unique_ptr<LogReader> reader, std::string name)
      : window_(window), reader_(std::move(reader)), name_(std::move(name)) {}

  const LogRecord* next() override {
    while (const LogRecord* record = is_ended_ ? nullptr : reader_->next()) {
      const bool is_scan = record->kind == RecordKind::kScan;
      if (!begin_ && is_scan) begin_ = record->stamp;
      if (is_behind(record->stamp)) {
        is_ended_ = is_scan;
        continue;
      }
      if (is_before(record->stamp) || (is_scan && is_too_soon(*record))) continue;
      is_any_scan_ = is_any_scan_ || is_scan;
      return record;
    }
    if (is_any_scan_) return nullptr;
    throw FormatError(name_, "", "no scan lies in the span of time that was asked for");
  }

  const LogProblems& problems() const override { return reader_->problems(); }
  std::string front_sensor() const override { return reader_->front_sensor(); }
  std::string format() const override { return reader_->format(); }
  std::optional<double> fraction_read() const override { return reader_->fraction_read(); }
  RecordingOverview overview() const override { return reader_->overview(); }

 private:
  /// A limit as seconds behind the first scan; nothing before that scan is known.
  [[nodiscard]] std::optional<double> behind_begin_s(double limit_s) const {
    if (!begin_) return std::nullopt;
    return limit_s >= kFirstStamp_s ? limit_s - begin_->seconds() : limit_s;
  }

  [[nodiscard]] bool is_before(Timestamp stamp) const {
    if (!window_.from_s) return false;
    const auto limit_s = behind_begin_s(*window_.from_s);
    return !limit_s || seconds_between(*begin_, stamp) < *limit_s;
  }

  [[nodiscard]] bool is_behind(Timestamp stamp) const {
    if (!window_.to_s) return false;
    const auto limit_s = behind_begin_s(*window_.to_s);
    return limit_s && seconds_between(*begin_, stamp) > *limit_s;
  }

  /// A tenth of a period early is not too soon: clocks are not even.
  bool is_too_soon(const LogRecord& scan) {
    if (!window_.max_rate_hz) return false;
    const auto [last, is_first] = last_handed_on_.try_emplace(scan.sensor, scan.stamp);
    const double since_s = seconds_between(last->second, scan.stamp);
    if (!is_first && since_s >= 0.0 && since_s < 0.9 / *window_.max_rate_hz) return true;
    last->second = scan.stamp;
    return false;
  }

  LogWindow window_;
  std::unique_ptr<LogReader> reader_;
  std::string name_;
  std::optional<Timestamp> begin_;  ///< The first scan's stamp.
  std::map<std::string, Timestamp> last_handed_on_;
  bool is_any_scan_ = false;
  bool is_ended_ = false;
};

}  // namespace

std::unique_ptr<LogReader> within(const LogWindow& window,
                                  std::unique_ptr<LogReader> reader,
                                  const std::string& name) {
  if (window.is_open()) return reader;
  return std::make_unique<TimeWindow>(window, std::move(reader), name);
}

}  // namespace setsquare
