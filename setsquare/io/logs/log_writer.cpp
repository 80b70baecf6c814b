// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_writer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/logs/bag/mcap_log_writer.hpp"
#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/logs/csv/writer.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare {
namespace {

class CarmenLogWriter final : public LogWriter {
 public:
  explicit CarmenLogWriter(Sink sink) : sink_(std::move(sink)) {}

  void write(const LogRecord& record) override {
    line_.clear();
    if (record.kind == RecordKind::kScan) {
      Scan scan = record.scan;
      if (!std::isfinite(scan.max_range_m)) scan.max_range_m = kNoLimit_m;
      append_carmen_scan(line_, scan, {.T_odom_base = record.T_odom_base.value_or(Pose2{})});
    } else if (record.kind == RecordKind::kTruePose) {
      append_carmen_true_pose(
          line_, record.stamp, *record.T_map_base, record.T_odom_base.value_or(Pose2{}));
    } else {
      return leave_out();
    }
    sink_(line_);
  }

 private:
  /// CARMEN logs state a reach; no scanner has a longer one.
  static constexpr double kNoLimit_m = 1000.0;

  Sink sink_;
  std::string line_;
};

class CsvLogWriter final : public LogWriter {
 public:
  explicit CsvLogWriter(Sink sink) : sink_(std::move(sink)) { append_csv_header(line_); }

  void write(const LogRecord& record) override {
    if (record.kind != RecordKind::kScan) return leave_out();
    append_csv_scan(line_, record);
    sink_(line_);
    line_.clear();
  }

 private:
  Sink sink_;
  std::string line_;
};

class JsonLinesWriter final : public LogWriter {
 public:
  explicit JsonLinesWriter(Sink sink) : sink_(std::move(sink)) {}

  void write(const LogRecord& record) override {
    line_.clear();
    append_json_record(line_, record);
    sink_(line_);
  }

 private:
  Sink sink_;
  std::string line_;
};

class TumWriter final : public LogWriter {
 public:
  explicit TumWriter(Sink sink) : sink_(std::move(sink)) {}

  void write(const LogRecord& record) override {
    if (record.T_map_base) {
      reference_.push_back({record.stamp, *record.T_map_base});
    } else if (record.T_odom_base) {
      odometry_.push_back({record.stamp, *record.T_odom_base});
    } else {
      leave_out();
    }
  }

  void finish() override {
    sink_(tum_from_trajectory(reference_.empty() ? odometry_ : reference_));
  }

 private:
  Sink sink_;
  Trajectory reference_;
  Trajectory odometry_;
};

constexpr std::pair<std::string_view, LogFormat> kEndings[] = {{".clf", LogFormat::kCarmen},
                                                               {".log", LogFormat::kCarmen},
                                                               {".csv", LogFormat::kCsv},
                                                               {".jsonl", LogFormat::kJsonLines},
                                                               {".ndjson", LogFormat::kJsonLines},
                                                               {".mcap", LogFormat::kMcap},
                                                               {".tum", LogFormat::kTum}};

}  // namespace

std::optional<LogFormat> log_format_of(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  for (const auto& [ending, format] : kEndings) {
    if (lower.ends_with(ending)) return format;
  }
  return std::nullopt;
}

std::unique_ptr<LogWriter> make_log_writer(LogFormat format,
                                           LogWriter::Sink sink,
                                           ChunkPacking packing) {
  switch (format) {
    case LogFormat::kCarmen:
      return std::make_unique<CarmenLogWriter>(std::move(sink));
    case LogFormat::kCsv:
      return std::make_unique<CsvLogWriter>(std::move(sink));
    case LogFormat::kJsonLines:
      return std::make_unique<JsonLinesWriter>(std::move(sink));
    case LogFormat::kMcap:
      return std::make_unique<McapLogWriter>(std::move(sink), packing);
    case LogFormat::kTum:
      break;
  }
  return std::make_unique<TumWriter>(std::move(sink));
}

}  // namespace setsquare
