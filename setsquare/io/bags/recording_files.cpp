// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/recording_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadataName = "metadata.yaml";
constexpr std::size_t kMaxMetadataBytes = 1 << 24;
constexpr std::size_t kMaxNamed = 5;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string enumerated(std::vector<std::string> names) {
  const bool are_all_named = names.size() <= kMaxNamed;
  if (!are_all_named) names.resize(kMaxNamed);
  return joined(names) + (are_all_named ? "" : " ...");
}

/// "run_12.db3.zstd" in its parts.
struct RecordingName {
  std::string recording;  ///< "run", what all files of a recording share.
  std::string unpacked;   ///< "run_12.db3".
};

/// The parts of a file's name; nothing where it is none of a recording.
std::optional<RecordingName> recording_name(const fs::path& file) {
  fs::path name = file.filename();
  if (name.extension() == ".zstd" || name.extension() == ".zst") name = name.stem();
  if (name.extension() != ".db3" && name.extension() != ".mcap") return std::nullopt;
  std::string recording = name.stem().string();
  const std::size_t underscore = recording.find_last_not_of("0123456789");
  if (underscore != std::string::npos && recording[underscore] == '_') recording.resize(underscore);
  return RecordingName{std::move(recording), name.string()};
}

/// The recording files in a folder, by number; of a file that is there packed and unpacked only the
/// latter.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::map<std::string, fs::path> file_of_name;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::optional<RecordingName> name = recording_name(entry.path());
    if (!name || !is_file(entry.path())) continue;
    fs::path& file = file_of_name[name->unpacked];
    if (file.empty() || entry.path().filename() == name->unpacked) file = entry.path();
  }
  std::vector<fs::path> files;
  for (const auto& [name, file] : file_of_name) files.push_back(file);
  std::sort(files.begin(), files.end(), [](const fs::path& left, const fs::path& right) {
    return is_before_by_number(left.filename().string(), right.filename().string());
  });
  return files;
}

/// A file, or the same packed or unpacked, where either is there.
std::optional<fs::path> present(const fs::path& path) {
  if (is_file(path)) return path;
  fs::path other = path;
  if (path.extension() == ".zstd") {
    other.replace_extension();
  } else {
    other += ".zstd";
  }
  if (is_file(other)) return other;
  return std::nullopt;
}

/// The file that metadata.yaml means with `written`, where it is there.
std::optional<fs::path> resolved(const fs::path& folder, const fs::path& written) {
  if (written.is_relative()) {
    if (auto file = present(folder / written)) return file;
  }
  if (auto file = present(folder / written.filename())) return file;
  return present(written.is_relative() ? folder / ".." / written : written);
}

std::string read_metadata_text(const fs::path& path) {
  InputBuffer input(open_file_source(path.string()));
  input.ensure(kMaxMetadataBytes);
  return std::string(input.available());
}

/// Takes the files that metadata.yaml names; what is wrong with it is remarked.
void take_named_files(const fs::path& folder, const fs::path& metadata, RecordingFiles& recording) {
  const std::string name = metadata.string();
  try {
    recording.metadata = recording_metadata_from_text(read_metadata_text(metadata), name);
  } catch (const FormatError& error) {
    recording.remarks.push_back(error.what());
    return;
  }
  for (const std::string& written : recording.metadata->files) {
    const std::optional<fs::path> file = resolved(folder, written);
    std::vector<fs::path>& files = recording.files;
    if (!file) {
      recording.missing.push_back(written);
    } else if (std::find(files.begin(), files.end(), *file) == files.end()) {
      files.push_back(*file);
    }
  }
}

/// Recordings that have their files, or folders of their own, in a folder.
[[noreturn]] void complain_of_no_recording(const fs::path& folder) {
  std::vector<std::string> inner;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_file(entry.path() / kMetadataName)) inner.push_back(entry.path().filename().string());
  }
  std::sort(inner.begin(), inner.end(), is_before_by_number);
  throw FormatError(
      folder.string(),
      "",
      inner.empty()
          ? std::string("a folder without a recording: no metadata.yaml, .db3 or .mcap in it")
          : fmt::format("a folder of recordings; name one of them: {}",
                        enumerated(std::move(inner))));
}

void require_one_recording(const fs::path& folder, const std::vector<fs::path>& files) {
  std::set<std::string> recordings;
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    recordings.insert(recording_name(file)->recording);
    names.push_back(file.filename().string());
  }
  if (recordings.size() <= 1) return;
  throw FormatError(folder.string(),
                    "",
                    fmt::format("files of several recordings, and no metadata.yaml; name one of "
                                "them: {}",
                                enumerated(std::move(names))));
}

/// Takes all files of the folder, for want of a metadata.yaml that names them.
void take_all_files(const fs::path& folder, RecordingFiles& recording) {
  const std::string missing = enumerated(std::exchange(recording.missing, {}));
  recording.files = files_in(folder);
  if (recording.files.empty() && missing.empty()) complain_of_no_recording(folder);
  if (recording.files.empty()) {
    throw FormatError(folder.string(), "", "no file that metadata.yaml names is there: " + missing);
  }
  require_one_recording(folder, recording.files);
  const std::string why = missing.empty()
                              ? "there is no usable metadata.yaml, as when a recorder is killed"
                              : "metadata.yaml names files that are not there: " + missing;
  recording.remarks.push_back(why + "; the folder's files are read in the order of their numbers");
}

void remark_on_unnamed_files(const fs::path& folder, RecordingFiles& recording) {
  std::set<std::string> named;
  for (const fs::path& file : recording.files) {
    if (const auto name = recording_name(file)) named.insert(name->unpacked);
  }
  std::vector<std::string> unnamed;
  for (const fs::path& file : files_in(folder)) {
    if (named.contains(recording_name(file)->unpacked)) continue;
    unnamed.push_back(file.filename().string());
  }
  if (unnamed.empty()) return;
  recording.remarks.push_back(fmt::format("metadata.yaml does not name {}, which is not read",
                                          enumerated(std::move(unnamed))));
}

}  // namespace

bool is_before_by_number(std::string_view left, std::string_view right) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto take_number = [&is_digit](std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size());
    return digits.substr(first);
  };
  while (!left.empty() && !right.empty()) {
    if (is_digit(left.front()) && is_digit(right.front())) {
      const std::string_view left_number = take_number(left);
      const std::string_view right_number = take_number(right);
      if (left_number.size() != right_number.size()) {
        return left_number.size() < right_number.size();
      }
      if (left_number != right_number) return left_number < right_number;
    } else {
      if (left.front() != right.front()) return left.front() < right.front();
      left.remove_prefix(1);
      right.remove_prefix(1);
    }
  }
  return left.size() < right.size();
}

RecordingFiles find_recording_files(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const bool is_folder = fs::is_directory(status);
  if (!is_folder && !fs::is_regular_file(status)) {
    throw FileError(path, error ? error.message() : "neither a folder nor a file");
  }
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = is_folder ? fs::path(path) : parent.empty() ? fs::path(".") : parent;
  const fs::path metadata = is_folder ? folder / kMetadataName : fs::path(path);
  RecordingFiles recording;
  try {
    if (is_file(metadata)) take_named_files(folder, metadata, recording);
    if (recording.files.empty()) {
      take_all_files(folder, recording);
    } else {
      remark_on_unnamed_files(folder, recording);
    }
  } catch (const fs::filesystem_error& failure) {
    throw FileError(folder.string(), failure.code().message());
  }
  return recording;
}

}  // namespace setsquare
