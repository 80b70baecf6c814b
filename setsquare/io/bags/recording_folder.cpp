// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/recording_folder.hpp"

#include <fmt/core.h>

#include <cassert>
#include <filesystem>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxCountsNamed = 5;

/// What an error says without the path, with which it begins.
std::string reason_of(const Error& error, const std::string& path) {
  std::string reason = error.what();
  if (!reason.starts_with(path)) return reason;
  reason.erase(0, path.size());
  const std::size_t begin = reason.find_first_not_of(",: ");
  return begin == std::string::npos ? std::string() : reason.substr(begin);
}

/// Packs messages otherwise than anybody here can unpack them.
bool is_unknown_packing(const RecordingMetadata& metadata) {
  const std::string& format = metadata.compression_format;
  return metadata.compression_mode == "MESSAGE" && !format.empty() && format != "zstd";
}

std::vector<double> bytes_before_each(const std::vector<std::filesystem::path>& files) {
  std::vector<double> before = {0.0};
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    before.push_back(before.back() + (error ? 0.0 : static_cast<double>(size)));
  }
  return before;
}

}  // namespace

RecordingFolder::RecordingFolder(const std::string& path, OpenFile open_file)
    : recording_(find_recording_files(path)),
      open_file_(std::move(open_file)),
      bytes_before_(bytes_before_each(recording_.files)) {
  if (recording_.metadata && is_unknown_packing(*recording_.metadata)) {
    throw FormatError(path,
                      "",
                      fmt::format("messages packed as \"{}\", which is not known; zstd is",
                                  recording_.metadata->compression_format));
  }
  problems().remarks = recording_.remarks;
  for (const std::string& missing : recording_.missing) {
    problems().add(missing, "metadata.yaml names this file, and it is not there");
  }
  if (open_next()) return;
  const LogProblem& last = problems().first.back();
  throw FormatError(
      path, "", fmt::format("no file of it can be read; {}: {}", last.location, last.reason));
}

void RecordingFolder::open(const std::string& path) {
  OpenedFile file;
  file.name = std::filesystem::path(path).filename().string();
  file.messages = open_file_(path);
  assert(file.messages->topics().empty());  // they are met while reading
  file.messages->set_wanted([this](const MessageTopic& topic) {
    const std::size_t ours = add_topic(topic);
    file_->our_topic.push_back(ours);
    file_->num_counted.push_back(0);
    return is_wanted(ours);
  });
  if (format_.empty()) format_ = file.messages->format();
  file_ = std::move(file);
}

bool RecordingFolder::open_next() {
  while (num_begun_ < recording_.files.size()) {
    const std::string path = recording_.files[num_begun_++].string();
    try {
      open(path);
      return true;
    } catch (const Error& error) {
      problems().add(std::filesystem::path(path).filename().string(), reason_of(error, path));
    }
  }
  return false;
}

bool RecordingFolder::read(Message& message) {
  while (file_ || open_next()) {
    if (read_from_file(message)) return true;
    close();
  }
  if (!std::exchange(is_at_end_, true)) remark_on_counts();
  return false;
}

bool RecordingFolder::read_from_file(Message& message) {
  try {
    while (file_->messages->read(message)) {
      take_problems();
      const std::uint64_t position = message.position;
      last_position_ = position_before_file_ + position;
      message.position = last_position_;
      ++file_->num_counted[message.topic];
      message.topic = file_->our_topic[message.topic];
      const std::string damage = packed_message_.unpack(topics()[message.topic].encoding, message);
      if (damage.empty()) {
        count(message.topic);
        return true;
      }
      problems().add(fmt::format("{}, message at {}", file_->name, position), damage);
    }
  } catch (const Error& error) {
    if (recording_.files.size() == 1) throw;
    problems().add(file_->name, reason_of(error, recording_.files[num_begun_ - 1].string()));
  }
  return false;
}

std::optional<double> RecordingFolder::fraction_read() const {
  if (bytes_before_.back() == 0.0) return std::nullopt;
  const double fraction_of_file = file_ ? file_->messages->fraction_read().value_or(0.0) : 1.0;
  const double begin = bytes_before_[num_begun_ - 1];
  const double end = bytes_before_[num_begun_];
  return (begin + fraction_of_file * (end - begin)) / bytes_before_.back();
}

void RecordingFolder::close() {
  take_problems();
  // What it told of topics that are not wanted.
  const std::vector<std::uint64_t>& num_messages = file_->messages->num_messages();
  for (std::size_t i = 0; i < file_->our_topic.size(); ++i) {
    count(file_->our_topic[i], num_messages[i] - file_->num_counted[i]);
  }
  position_before_file_ = last_position_;
  file_.reset();
}

void RecordingFolder::take_problems() {
  const LogProblems& theirs = file_->messages->problems();
  if (theirs.num_damaged == file_->num_damaged_taken &&
      theirs.remarks.size() == file_->num_remarks_taken) {
    return;
  }
  const bool is_one_of_several = recording_.files.size() > 1;
  const std::string of_file = is_one_of_several ? file_->name + ", " : "";
  std::uint64_t num_added = 0;
  for (std::size_t& i = file_->num_problems_taken; i < theirs.first.size(); ++i, ++num_added) {
    problems().add(of_file + theirs.first[i].location, theirs.first[i].reason);
  }
  // Those that it counted, but did not keep.
  problems().num_damaged += theirs.num_damaged - file_->num_damaged_taken - num_added;
  file_->num_damaged_taken = theirs.num_damaged;
  for (std::size_t& i = file_->num_remarks_taken; i < theirs.remarks.size(); ++i) {
    problems().remarks.push_back((is_one_of_several ? file_->name + ": " : "") + theirs.remarks[i]);
  }
}

std::optional<std::uint64_t> RecordingFolder::num_read(
    const RecordingMetadata::TopicCount& announced) const {
  std::optional<std::uint64_t> num_read;
  for (std::size_t i = 0; i < topics().size(); ++i) {
    if (topics()[i].name != announced.name || topics()[i].type != announced.type) continue;
    if (!is_wanted(i)) return std::nullopt;
    num_read = num_read.value_or(0) + num_messages()[i];
  }
  return num_read;
}

void RecordingFolder::remark_on_counts() {
  if (!recording_.metadata) return;
  std::string differing;
  std::size_t num_differing = 0;
  for (const RecordingMetadata::TopicCount& announced : recording_.metadata->topics) {
    const std::optional<std::uint64_t> read = num_read(announced);
    if (!read || *read == announced.num_messages || ++num_differing > kMaxCountsNamed) continue;
    differing += fmt::format("{}{} of {}, {} there",
                             differing.empty() ? "" : "; ",
                             announced.num_messages,
                             announced.name,
                             *read);
  }
  if (num_differing == 0) return;
  problems().remarks.push_back(
      fmt::format("metadata.yaml announces other numbers of messages: {}{}",
                  differing,
                  num_differing > kMaxCountsNamed ? "; ..." : ""));
}

}  // namespace setsquare
