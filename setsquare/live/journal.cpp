// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/journal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/ros/builtin_definitions.hpp"

namespace setsquare {
namespace {

constexpr const char* kLatchedTopic = "/tf_static";
constexpr std::size_t kMaxLatched = 1000;
constexpr std::size_t kNumDigits = 8;

/// "00000012.mcap" is 12; 0 where the name is another.
std::uint64_t number_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const bool is_ours = file.extension() == ".mcap" && stem.size() == kNumDigits &&
                       stem.find_first_not_of("0123456789") == std::string::npos;
  return is_ours ? std::stoull(stem) : 0;
}

/// As recordings write it: "sensor_msgs/msg/LaserScan".
std::string full_type_name(const std::string& type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string::npos || type.find('/', slash + 1) != std::string::npos) return type;
  return type.substr(0, slash) + "/msg" + type.substr(slash);
}

}  // namespace

Journal::Journal(std::string folder,
                 std::function<void(const std::string&)> on_failure,
                 double period_s)
    : folder_(std::move(folder)), on_failure_(std::move(on_failure)), period_(period_s) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw FileError(folder_, "cannot be made: " + error.message());
  if (const auto files = files_of(folder_); !files.empty()) {
    next_file_ = number_of(files.back()) + 1;
  }
  writer_ = std::thread([this] { write_until_end(); });
}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  is_called_.notify_one();
  writer_.join();
}

std::vector<std::string> Journal::files_of(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (number_of(entry.path()) > 0) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void Journal::add(const MessageTopic& topic, const Message& message) {
  Kept kept{.topic = topic.name,
            .type = full_type_name(topic.type),
            .definition = topic.definition,
            .log_time = message.log_time,
            .data = std::string(message.data)};
  const std::lock_guard lock(mutex_);
  if (topic.name == kLatchedTopic && latched_.size() < kMaxLatched) latched_.push_back(kept);
  messages_.push_back(std::move(kept));
}

void Journal::clear() {
  const std::lock_guard lock(mutex_);
  messages_ = latched_;
  must_clear_ = true;
  is_called_.notify_one();
}

void Journal::write_until_end() {
  std::unique_lock lock(mutex_);
  for (bool is_last = false; !is_last;) {
    is_called_.wait_for(lock, period_, [this] { return is_ending_ || must_clear_; });
    is_last = is_ending_;
    const bool must_clear = std::exchange(must_clear_, false);
    const std::vector<Kept> messages = std::exchange(messages_, {});
    lock.unlock();
    if (must_clear) remove_files();
    if (!messages.empty()) write(messages);
    lock.lock();
  }
}

void Journal::remove_files() {
  std::error_code ignored;
  // The last first: what a kill leaves over is the beginning of what was.
  std::vector<std::string> files = files_of(folder_);
  std::reverse(files.begin(), files.end());
  for (const std::string& file : files) std::filesystem::remove(file, ignored);
}

void Journal::write(const std::vector<Kept>& messages) {
  std::string bytes;
  McapWriter bag([&](std::string_view piece) { bytes += piece; });
  std::map<std::string, McapWriter::Channel> channels;
  for (const Kept& kept : messages) {
    const auto [entry, is_new] = channels.try_emplace(kept.topic);
    if (is_new) {
      const std::string definition =
          kept.definition.empty()
              ? ros::builtin_definition(plain_type_name(kept.type), MessageEncoding::kCdr)
              : kept.definition;
      entry->second =
          bag.add_channel(kept.topic, kept.type, definition, kept.topic == kLatchedTopic);
    }
    bag.write(entry->second, kept.log_time, kept.data);
  }
  bag.finish();
  try {
    save_file(fmt::format("{}/{:08}.mcap", folder_, next_file_), bytes);
    ++next_file_;
    has_failed_ = false;
  } catch (const FileError& error) {
    if (!std::exchange(has_failed_, true)) on_failure_(error.what());
  }
}

}  // namespace setsquare
