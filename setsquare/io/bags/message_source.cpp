// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/message_source.hpp"

#include <algorithm>

namespace setsquare {

std::size_t MessageSource::add_topic(MessageTopic topic) {
  topic.type = plain_type_name(topic.type);
  const auto same = [&topic](const MessageTopic& other) {
    return other.name == topic.name && other.type == topic.type && other.encoding == topic.encoding;
  };
  const auto found = std::find_if(topics_.begin(), topics_.end(), same);
  if (found != topics_.end()) {
    if (found->definition.empty()) found->definition = std::move(topic.definition);
    return static_cast<std::size_t>(found - topics_.begin());
  }
  wanted_.push_back(!is_wanted_ || is_wanted_(topic));
  num_messages_.push_back(0);
  topics_.push_back(std::move(topic));
  return topics_.size() - 1;
}

std::string plain_type_name(std::string_view type) {
  constexpr std::string_view kMiddle = "/msg/";
  const std::size_t middle = type.find(kMiddle);
  if (middle == std::string_view::npos) return std::string(type);
  return std::string(type.substr(0, middle + 1)).append(type.substr(middle + kMiddle.size()));
}

}  // namespace setsquare
