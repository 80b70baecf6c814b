// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_chain.hpp"

#include <cstdint>
#include <map>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/logs/time_window.hpp"

namespace setsquare {
namespace {

class LogChain final : public LogReader {
 public:
  LogChain(std::vector<std::string> paths, const LogOptions& options)
      : paths_(std::move(paths)), options_(options), reader_(open_log(paths_.front(), options)) {}

  const LogRecord* next() override {
    while (reader_ != nullptr) {
      if (const LogRecord* record = next_of_current()) return record;
      open_next();
    }
    return nullptr;
  }

  const LogProblems& problems() const override {
    all_problems_ = ended_problems_;
    if (reader_ != nullptr) add_problems(all_problems_);
    return all_problems_;
  }
  std::string front_sensor() const override { return front_sensor_; }
  std::string format() const override { return reader_ == nullptr ? format_ : reader_->format(); }
  RecordingOverview overview() const override {
    return reader_ == nullptr ? overview_ : reader_->overview();
  }

  std::optional<double> fraction_read() const override {
    const double within = reader_ == nullptr ? 0.0 : reader_->fraction_read().value_or(0.0);
    return (static_cast<double>(current_) + within) / static_cast<double>(paths_.size());
  }

 private:
  const LogRecord* next_of_current() {
    try {
      const LogRecord* record = reader_->next();
      if (front_sensor_.empty()) front_sensor_ = reader_->front_sensor();
      is_any_read_ = is_any_read_ || record != nullptr;
      return numbered(record);
    } catch (const Error& error) {
      const bool is_last = current_ + 1 == paths_.size();
      if (!is_any_read_ && is_last) throw;
      ended_problems_.remarks.emplace_back(error.what());
      return nullptr;
    }
  }

  /// Each log numbers its scanners as they come in it; of the run, a name has one number.
  const LogRecord* numbered(const LogRecord* record) {
    if (record == nullptr || record->kind != RecordKind::kScan) return record;
    const auto next_number = static_cast<std::uint32_t>(numbers_.size());
    const std::uint32_t number = numbers_.try_emplace(record->sensor, next_number).first->second;
    if (record->scan.scanner == number) return record;
    renumbered_ = *record;
    renumbered_.scan.scanner = number;
    return &renumbered_;
  }

  void open_next() {
    add_problems(ended_problems_);
    overview_ = reader_->overview();
    format_ = reader_->format();
    reader_.reset();
    while (++current_ < paths_.size() && reader_ == nullptr) {
      try {
        reader_ = open_log(paths_[current_], options_);
        return;
      } catch (const Error& error) {
        ended_problems_.remarks.emplace_back(error.what());
      }
    }
  }

  void add_problems(LogProblems& sum) const {
    const LogProblems& problems = reader_->problems();
    const std::string& path = paths_[current_];
    sum.num_damaged += problems.num_damaged;
    for (const LogProblem& problem : problems.first) {
      if (sum.first.size() == LogProblems::kMaxKept) break;
      sum.first.push_back({path + ", " + problem.location, problem.reason});
    }
    for (const std::string& remark : problems.remarks) sum.remarks.push_back(path + ": " + remark);
  }

  std::vector<std::string> paths_;
  LogOptions options_;
  std::size_t current_ = 0;
  std::unique_ptr<LogReader> reader_;  ///< Of the current log; null behind the last.
  LogProblems ended_problems_;         ///< Of the logs before the current one.
  mutable LogProblems all_problems_;
  RecordingOverview overview_;
  std::string front_sensor_;
  std::string format_;
  bool is_any_read_ = false;
  std::map<std::string, std::uint32_t> numbers_;  ///< Of scanners, by name.
  LogRecord renumbered_;                          ///< The last record that another number was due.
};

}  // namespace

std::unique_ptr<LogReader> open_logs(const std::vector<std::string>& paths,
                                     const LogOptions& options) {
  if (paths.empty()) throw ParameterError("paths", "must name a log");
  if (paths.size() == 1) return open_log(paths.front(), options);
  LogOptions of_each = options;
  of_each.window = {};
  return within(options.window, std::make_unique<LogChain>(paths, of_each), paths.front());
}

}  // namespace setsquare
