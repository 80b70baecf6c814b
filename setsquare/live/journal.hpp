// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {

/// What has come so far, kept in a folder so that a run outlives a kill: every few seconds a file
/// of its own (00000001.mcap, ...), a whole ROS 2 bag each, or none. What comes is read on where
/// they end (ResumedMessages); `setsquare map FOLDER/*.mcap` maps the same.
///
/// A thread of its own packs and writes, so that nobody waits for the disk. Where it cannot be
/// written, that is told once, and mapping goes on.
class Journal {
 public:
  static constexpr double kPeriod_s = 15.0;

  /// Makes the folder where it is absent. `on_failure`: on the journal's thread. Throws FileError.
  explicit Journal(std::string folder,
                   std::function<void(const std::string&)> on_failure,
                   double period_s = kPeriod_s);
  /// Writes what is left.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The files of a folder in their order; none where there is no such folder.
  [[nodiscard]] static std::vector<std::string> files_of(const std::string& folder);

  /// A message that was read. Messages of /tf_static are kept beyond clear(): they come only once.
  void add(const MessageTopic& topic, const Message& message);
  /// Forgets all: the files go.
  void clear();

 private:
  struct Kept {
    std::string topic;
    std::string type;
    std::string definition;
    Timestamp log_time;
    std::string data;
  };

  void write_until_end();
  void write(const std::vector<Kept>& messages);
  void remove_files();

  const std::string folder_;
  const std::function<void(const std::string&)> on_failure_;
  const std::chrono::duration<double> period_;
  std::uint64_t next_file_ = 1;  ///< Of the writing thread.
  bool has_failed_ = false;      ///< Of the writing thread.

  std::mutex mutex_;  ///< All below.
  std::condition_variable is_called_;
  std::vector<Kept> messages_;
  std::vector<Kept> latched_;
  bool must_clear_ = false;
  bool is_ending_ = false;

  std::thread writer_;
};

}  // namespace setsquare
