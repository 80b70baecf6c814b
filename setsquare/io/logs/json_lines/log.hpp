// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "setsquare/io/logs/line_log.hpp"

namespace setsquare {

class JsonScanner;  // setsquare/io/logs/json_lines/scanner.hpp

/// Whether a text's first line begins as an object does.
[[nodiscard]] bool is_json_lines_log(std::string_view beginning);

/// The records of a log of one JSON object per line: a scan where it has "ranges", a true pose
/// where it has "true_pose", odometry where it has that, else a rate of turn (docs/formats.md).
/// Members of other names are passed over.
class JsonLinesLog final : public LineLog {
 public:
  JsonLinesLog(std::unique_ptr<InputBuffer> input, const LogOptions& options);

  double mounting_rounding() const override { return 0.0; }
  std::string format() const override { return "JSON lines"; }

 protected:
  LineOutcome read_line(std::string_view line, LogRecord& record) override;
  std::string reason(std::string_view) const override { return reason_; }

 private:
  [[nodiscard]] bool read_object(std::string_view line, LogRecord& record);
  [[nodiscard]] bool read_member(JsonScanner& json, std::string_view name, LogRecord& record);
  [[nodiscard]] bool check(LogRecord& record);
  bool fail(std::string reason);

  bool scans_only_;
  bool has_stamp_ = false;   ///< On this line.
  bool has_ranges_ = false;  ///< On this line.
  std::string reason_;
};

}  // namespace setsquare
