// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

/// Formats in which logs are written.
enum class LogFormat {
  kCarmen,     ///< ".clf", ".log": one laser, ranges to the millimetre.
  kCsv,        ///< ".csv": scans only.
  kJsonLines,  ///< ".jsonl", ".ndjson": everything, exactly.
  kMcap,       ///< ".mcap": a ROS 2 bag.
  kTum,        ///< ".tum": the reference poses alone; where there are none, the odometry's.
};

/// By the end of a file's name, in any case.
[[nodiscard]] std::optional<LogFormat> log_format_of(std::string_view path);

/// Writes records of any log into one of the formats, piece by piece.
class LogWriter {
 public:
  using Sink = std::function<void(std::string_view bytes)>;

  virtual ~LogWriter() = default;

  /// Throws ParameterError where the record cannot be stated in the format at all (a scan without
  /// beams); what `sink` throws goes through.
  virtual void write(const LogRecord& record) = 0;

  /// What stands at the end of a file. Call it once, behind the last record.
  virtual void finish() {}

  /// Records of kinds that the format has no place for.
  [[nodiscard]] std::uint64_t num_left_out() const { return num_left_out_; }

 protected:
  void leave_out() { ++num_left_out_; }

 private:
  std::uint64_t num_left_out_ = 0;
};

/// `packing` is of kMcap's chunks.
[[nodiscard]] std::unique_ptr<LogWriter> make_log_writer(
    LogFormat format, LogWriter::Sink sink, ChunkPacking packing = ChunkPacking::kZstd);

}  // namespace setsquare
