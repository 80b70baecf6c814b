// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Which files a rosbag2 recording consists of; what is in them is RecordingFolder's subject.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bags/recording_metadata.hpp"

namespace setsquare {

struct RecordingFiles {
  std::vector<std::filesystem::path> files;  ///< All there, in order of recording.
  std::vector<std::string> missing;          ///< As metadata.yaml has them.
  std::vector<std::string> remarks;          ///< One sentence each.
  std::optional<RecordingMetadata> metadata;
};

/// Finds the files of the recording in a folder, or beside a metadata.yaml.
///
/// 1. The files that metadata.yaml names. Old versions put the folder's name before, and some tools
///    the whole path on another machine: then the name alone counts. A file may have been packed or
///    unpacked since (".zstd").
/// 2. Where there is no metadata.yaml (a recorder that was killed writes none), where it is damaged
///    or names no file that is there: the .db3 and .mcap files in the folder, in the order of their
///    numbers, with a remark.
///
/// Throws FileError; FormatError where there is no file, or where they belong to several
/// recordings.
[[nodiscard]] RecordingFiles find_recording_files(const std::string& path);

/// Whether `left` comes before `right` where numbers in names count as numbers: "x_2" before
/// "x_10".
[[nodiscard]] bool is_before_by_number(std::string_view left, std::string_view right);

}  // namespace setsquare
