// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace setsquare {

/// What the file metadata.yaml of a rosbag2 recording tells, as far as a reader needs it. Its
/// versions 1 to 9 differ in what else they tell.
struct RecordingMetadata {
  struct TopicCount {
    std::string name;
    std::string type;  ///< Without "/msg/".
    std::uint64_t num_messages = 0;
  };

  std::vector<std::string> files;  ///< Paths as written, in order of recording.
  std::string compression_format;  ///< "zstd"; empty for none.
  std::string compression_mode;    ///< "FILE", "MESSAGE"; empty or "NONE" for none.
  std::vector<TopicCount> topics;
};

/// Whether a file that begins so is such a metadata.yaml.
[[nodiscard]] bool is_recording_metadata(std::string_view beginning);

/// Reads such a file's text. What is missing is left empty, counts that are none are left out.
/// Throws FormatError where it is no yaml or not of a recording. `name` stands in messages for the
/// path.
[[nodiscard]] RecordingMetadata recording_metadata_from_text(const std::string& text,
                                                             const std::string& name);

}  // namespace setsquare
