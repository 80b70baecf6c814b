// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/bags/packed_message.hpp"
#include "setsquare/io/bags/recording_files.hpp"

namespace setsquare {

/// A recording of rosbag2 as its recorder leaves it: a folder with metadata.yaml and one file or
/// several, which are read one after another as if they were one. find_recording_files() says which
/// files these are.
///
/// A file that is missing or cannot be read is counted in problems(), and the others are read.
/// Places in problems() begin with the file's name; a message's position counts on from that of the
/// last message in the file before. Messages packed one by one are unpacked whatever the files'
/// format (PackedMessage). At the end a remark tells where metadata.yaml announced other numbers of
/// messages.
class RecordingFolder final : public MessageSource {
 public:
  /// Opens one file of a recording, whatever its format; throws FileError and FormatError.
  using OpenFile = std::function<std::unique_ptr<MessageSource>(const std::string& path)>;

  /// `path` is the folder, or the metadata.yaml in it. Throws FileError; FormatError where there is
  /// no recording, or none of its files can be opened.
  RecordingFolder(const std::string& path, OpenFile open_file);
  RecordingFolder(const RecordingFolder&) = delete;
  RecordingFolder& operator=(const RecordingFolder&) = delete;

  [[nodiscard]] bool read(Message& message) override;

  /// That of the first file that could be opened.
  [[nodiscard]] std::string format() const override { return format_; }
  [[nodiscard]] std::optional<double> fraction_read() const override;

 private:
  /// The file that is being read.
  struct OpenedFile {
    std::unique_ptr<MessageSource> messages;
    std::string name;
    std::vector<std::size_t> our_topic;      ///< Of each of the file's topics.
    std::vector<std::uint64_t> num_counted;  ///< Messages of each that were handed on.
    std::size_t num_problems_taken = 0;      ///< Of those that it keeps.
    std::size_t num_remarks_taken = 0;
    std::uint64_t num_damaged_taken = 0;
  };

  [[nodiscard]] bool open_next();
  void open(const std::string& path);
  [[nodiscard]] bool read_from_file(Message& message);
  void close();
  void take_problems();
  void remark_on_counts();

  /// Messages of a topic, where all were counted.
  [[nodiscard]] std::optional<std::uint64_t> num_read(
      const RecordingMetadata::TopicCount& announced) const;

  RecordingFiles recording_;
  OpenFile open_file_;
  std::string format_;
  std::vector<double> bytes_before_;  ///< Sizes of the files before each, and of all.
  std::size_t num_begun_ = 0;
  std::optional<OpenedFile> file_;
  std::uint64_t position_before_file_ = 0;
  std::uint64_t last_position_ = 0;
  bool is_at_end_ = false;
  PackedMessage packed_message_;
};

}  // namespace setsquare
