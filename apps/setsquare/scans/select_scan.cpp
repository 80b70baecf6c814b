// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/select_scan.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::app {
namespace {

/// What was wrong with the log, in brackets; empty where nothing was.
std::string words_of(const LogProblems& problems) {
  std::string words = summary(problems);
  for (const std::string& remark : problems.remarks) words += (words.empty() ? "" : "; ") + remark;
  return words.empty() ? words : fmt::format(" ({})", words);
}

/// What one text asks for: an index or a stamp.
class Wanted {
 public:
  Wanted(const std::string& log_path, const std::string& text) : log_path_(log_path), text_(text) {
    if (text.find('.') != std::string::npos) {
      stamp_ = timestamp_from_decimal(text);
      if (!stamp_) complain("is neither an index nor a stamp");
      return;
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index_);
    if (error != std::errc{} || end != text.data() + text.size() || text.empty()) {
      complain("is neither an index (0, 1, ...) nor a stamp with a decimal point");
    }
  }

  [[nodiscard]] bool is_met_by(const Scan& scan, std::size_t index) const {
    constexpr double kHalfMicrosecond_s = 0.5000001e-6;
    if (!stamp_) return index == index_;
    return std::abs(seconds_between(*stamp_, scan.stamp)) <= kHalfMicrosecond_s;
  }

  [[noreturn]] void complain_of_absence(std::size_t num_scans, const LogProblems& problems) const {
    const std::string damage = words_of(problems);
    if (stamp_) complain(fmt::format("is the stamp of none of its {} scans{}", num_scans, damage));
    complain(
        fmt::format("is beyond the last of its {} scans, numbered from 0{}", num_scans, damage));
  }

 private:
  [[noreturn]] void complain(const std::string& reason) const {
    throw Error(fmt::format("{}: scan {} {}", log_path_, text_, reason));
  }

  std::string log_path_;
  std::string text_;
  std::optional<Timestamp> stamp_;
  std::size_t index_ = 0;
};

}  // namespace

std::vector<SelectedScan> select_scans(const std::string& log_path,
                                       std::span<const std::string> wanted,
                                       const LogOptions& options) {
  std::vector<Wanted> wishes;
  wishes.reserve(wanted.size());
  for (const std::string& text : wanted) wishes.emplace_back(log_path, text);
  std::vector<std::optional<SelectedScan>> found(wanted.size());
  std::size_t num_missing = found.size();
  std::size_t index = 0;
  const std::unique_ptr<LogReader> reader = open_log(log_path, options);
  while (num_missing > 0) {
    const LogRecord* const record = reader->next();
    if (record == nullptr) break;
    if (record->kind != RecordKind::kScan) continue;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (found[i] || !wishes[i].is_met_by(record->scan, index)) continue;
      found[i] = SelectedScan{record->scan, index};
      --num_missing;
    }
    ++index;
  }
  std::vector<SelectedScan> selected;
  selected.reserve(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) wishes[i].complain_of_absence(index, reader->problems());
    selected.push_back(std::move(*found[i]));
  }
  tell_problems(log_path, reader->problems());
  return selected;
}

}  // namespace setsquare::app
