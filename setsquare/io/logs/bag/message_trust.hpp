// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Which messages of a recording are believed, and what was left out. Apart from bag_log, which says
// what is to be judged: what is remembered for it is a matter of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/logs/bag/message_course.hpp"

namespace setsquare {

/// Bounded: of very many names the course that was silent for the longest time is forgotten.
class MessageTrust {
 public:
  static constexpr std::size_t kMaxCourses = 256;

  /// As MessageCourse.
  explicit MessageTrust(bool has_arrival_times) : has_arrival_times_(has_arrival_times) {}

  /// Why a message is to be left out by what others of its name said before; empty where it is
  /// believed. `name`: a topic, or a frame.
  [[nodiscard]] std::string_view fault_of(const std::string& name, CourseMessage message);

  /// Counts a message that was left out.
  void count(const std::string& topic, std::string_view reason);
  /// How many were, and why, a sentence for each topic.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  struct Known {
    MessageCourse course;
    Timestamp last;
  };
  void forget_oldest();

  bool has_arrival_times_ = false;
  std::map<std::string, Known> courses_;
  std::map<std::string, std::map<std::string, std::uint64_t, std::less<>>> num_left_out_;
};

}  // namespace setsquare
