// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/recording_metadata.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {
namespace {

constexpr const char* kRootKey = "rosbag2_bagfile_information";

/// A recording has some hundred topics and files; longer lists are damage.
constexpr std::size_t kMaxEntries = 100000;

/// The text of an entry; empty where there is none.
std::string text_of(const YAML::Node& parent, const char* key) {
  if (!parent.IsMap()) return {};
  const YAML::Node node = parent[key];
  return node && node.IsScalar() ? node.Scalar() : std::string();
}

std::optional<std::uint64_t> count_of(const YAML::Node& parent, const char* key) {
  const std::string text = text_of(parent, key);
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  if (text.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

/// Calls `take` with each entry of a list, if it is one.
template <typename Take>
void for_each_entry(const YAML::Node& parent, const char* key, Take take) {
  const YAML::Node list = parent[key];
  if (!list || !list.IsSequence()) return;
  std::size_t num_entries = 0;
  for (const YAML::Node& entry : list) {
    if (++num_entries > kMaxEntries) return;
    take(entry);
  }
}

RecordingMetadata metadata_from(const YAML::Node& root) {
  RecordingMetadata metadata;
  metadata.compression_format = text_of(root, "compression_format");
  metadata.compression_mode = text_of(root, "compression_mode");
  for_each_entry(root, "relative_file_paths", [&](const YAML::Node& path) {
    if (path.IsScalar() && !path.Scalar().empty()) metadata.files.push_back(path.Scalar());
  });
  for_each_entry(root, "topics_with_message_count", [&](const YAML::Node& entry) {
    const std::optional<std::uint64_t> num_messages = count_of(entry, "message_count");
    if (!num_messages) return;
    const YAML::Node topic = entry[static_cast<const char*>("topic_metadata")];
    if (!topic) return;
    metadata.topics.push_back(
        {text_of(topic, "name"), plain_type_name(text_of(topic, "type")), *num_messages});
  });
  return metadata;
}

}  // namespace

bool is_recording_metadata(std::string_view beginning) {
  return beginning.starts_with(kRootKey) || beginning.starts_with("---\nrosbag2_bagfile_");
}

RecordingMetadata recording_metadata_from_text(const std::string& text, const std::string& name) {
  try {
    const YAML::Node document = YAML::Load(text);
    const YAML::Node root = document.IsMap() ? document[kRootKey] : YAML::Node();
    if (!root || !root.IsMap()) {
      throw FormatError(name, "", fmt::format("not of a ROS 2 recording: no {}", kRootKey));
    }
    return metadata_from(root);
  } catch (const YAML::Exception& error) {
    const std::string line =
        error.mark.is_null() ? "" : fmt::format("line {}", error.mark.line + 1);
    throw FormatError(name, line, error.msg);
  }
}

}  // namespace setsquare
