// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/open_log.hpp"

#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/open_recording.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/text_beginning.hpp"
#include "setsquare/io/logs/bag/bag_log.hpp"
#include "setsquare/io/logs/mrpt/rawlog.hpp"
#include "setsquare/io/logs/selecting_log_reader.hpp"
#include "setsquare/io/logs/text_stream.hpp"
#include "setsquare/io/logs/time_window.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kBeginningBytes = 1 << 16;

struct OtherFormat {
  std::string_view magic;
  std::string_view name;
};

/// Formats that we recognise only to say what the file is.
constexpr OtherFormat kOtherFormats[] = {{"PK\x03\x04", "a zip archive"},
                                         {"\xfd"
                                          "7zXZ",
                                          "an xz file"}};

std::unique_ptr<RecordStream> make_stream(std::unique_ptr<InputBuffer> input,
                                          const std::string& name,
                                          const LogOptions& options) {
  begin_text(*input, name);
  input->ensure(kBeginningBytes);
  const std::string_view beginning = input->available();
  const std::string damage = input->source().damage();
  if (beginning.empty()) {
    throw FormatError(name, "", damage.empty() ? "the file is empty" : damage);
  }
  for (const OtherFormat& other : kOtherFormats) {
    if (!beginning.starts_with(other.magic)) continue;
    throw FormatError(name, "", std::string(other.name) + ", which cannot be read as a log");
  }
  if (auto recording = recording_in(input, name)) {
    return std::make_unique<BagLog>(std::move(recording), options);
  }
  // Looked at again: what is asked of the input may have moved its bytes.
  if (is_mrpt_rawlog(input->available()))
    return std::make_unique<MrptRawlog>(std::move(input), options);
  if (auto stream = open_text_stream(input, name, options)) return stream;
  throw FormatError(
      name,
      "",
      "neither a ROS bag, a CARMEN log, JSON lines, a CSV table of scans nor an MRPT rawlog");
}

std::unique_ptr<LogReader> reader_of(std::unique_ptr<RecordStream> stream,
                                     const std::string& name,
                                     const LogOptions& options) {
  return within(
      options.window, std::make_unique<SelectingLogReader>(std::move(stream), name, options), name);
}

}  // namespace

std::unique_ptr<LogReader> open_log(const std::string& path, const LogOptions& options) {
  options.validate();
  if (auto recording = open_recording_at(path)) {
    return reader_of(std::make_unique<BagLog>(std::move(recording), options), path, options);
  }
  return open_log(open_file_source(path), path == "-" ? "standard input" : path, options);
}

std::unique_ptr<LogReader> open_log(std::unique_ptr<ByteSource> source,
                                    const std::string& name,
                                    const LogOptions& options) {
  options.validate();
  auto input = std::make_unique<InputBuffer>(unpack(std::move(source)));
  return reader_of(make_stream(std::move(input), name, options), name, options);
}

}  // namespace setsquare
