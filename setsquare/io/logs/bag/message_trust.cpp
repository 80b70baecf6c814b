// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/message_trust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "setsquare/core/joined.hpp"

namespace setsquare {

std::string_view MessageTrust::fault_of(const std::string& name, CourseMessage message) {
  auto found = courses_.find(name);
  if (found == courses_.end()) {
    if (courses_.size() == kMaxCourses) forget_oldest();
    found = courses_.emplace(name, Known{MessageCourse(has_arrival_times_), {}}).first;
  }
  found->second.last = message.log_time;
  return found->second.course.fault_of(std::move(message));
}

void MessageTrust::forget_oldest() {
  courses_.erase(
      std::min_element(courses_.begin(), courses_.end(), [](const auto& a, const auto& b) {
        return a.second.last < b.second.last;
      }));
}

void MessageTrust::count(const std::string& topic, std::string_view reason) {
  auto& reasons = num_left_out_[topic];
  const auto found = reasons.find(reason);
  if (found != reasons.end()) {
    ++found->second;
  } else {
    reasons.emplace(reason, 1);
  }
}

std::vector<std::string> MessageTrust::remarks() const {
  std::vector<std::string> sentences;
  for (const auto& [topic, reasons] : num_left_out_) {
    std::uint64_t num = 0;
    std::vector<std::string> parts;
    for (const auto& [reason, count] : reasons) {
      num += count;
      parts.push_back(fmt::format("{} ({})", reason, count));
    }
    sentences.push_back(fmt::format("{}: {} left out: {}", topic, num, joined(parts)));
  }
  return sentences;
}

}  // namespace setsquare
