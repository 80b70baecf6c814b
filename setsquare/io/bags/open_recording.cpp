// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/open_recording.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/mcap.hpp"
#include "setsquare/io/bags/recording_folder.hpp"
#include "setsquare/io/bags/rosbag1.hpp"
#include "setsquare/io/bags/rosbag2_sqlite.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBeginningOfRecording = 64;
constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

/// What an InputBuffer still holds, and what follows it, as a source again.
class RestOfInput final : public ByteSource {
 public:
  explicit RestOfInput(std::unique_ptr<InputBuffer> input) : input_(std::move(input)) {}

  std::size_t read(std::span<char> bytes) override {
    if (input_->available().empty() && !input_->fill()) return 0;
    const std::string_view available = input_->available().substr(0, bytes.size());
    std::copy(available.begin(), available.end(), bytes.begin());
    input_->consume(available.size());
    return available.size();
  }
  std::optional<double> fraction_read() const override { return input_->source().fraction_read(); }
  std::string damage() const override { return input_->source().damage(); }

 private:
  std::unique_ptr<InputBuffer> input_;
};

bool is_sqlite_file(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kSqliteMagic.size(), '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return file && beginning == kSqliteMagic;
}

}  // namespace

std::unique_ptr<MessageSource> open_recording_file(const std::string& path) {
  if (is_sqlite_file(path)) return std::make_unique<Rosbag2Sqlite>(path);
  auto input = std::make_unique<InputBuffer>(unpack(open_file_source(path)));
  if (auto recording = recording_in(input, path)) return recording;
  throw FormatError(path, "", "neither an SQLite file nor MCAP");
}

std::unique_ptr<MessageSource> open_recording_at(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored) || fs::path(path).filename() == "metadata.yaml") {
    return std::make_unique<RecordingFolder>(path, open_recording_file);
  }
  if (is_sqlite_file(path)) return std::make_unique<Rosbag2Sqlite>(path);
  return nullptr;
}

std::unique_ptr<MessageSource> recording_in(std::unique_ptr<InputBuffer>& input,
                                            const std::string& name) {
  input->ensure(kBeginningOfRecording);
  const std::string_view beginning = input->available();
  if (is_rosbag1(beginning)) return std::make_unique<Rosbag1>(std::move(input), name);
  if (is_mcap(beginning)) return std::make_unique<Mcap>(std::move(input));
  if (beginning.starts_with(kSqliteMagic)) {
    return std::make_unique<Rosbag2Sqlite>(std::make_unique<RestOfInput>(std::move(input)), name);
  }
  return nullptr;
}

}  // namespace setsquare
