// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "setsquare/io/logs/bag/topic_reader.hpp"

namespace setsquare {

/// Of several publishers of a topic the first is heard, as long as it speaks: scans and odometry
/// come from one. What cannot be used is no speech: a broken publisher neither takes the topic nor
/// keeps it.
class OnePublisher {
 public:
  using Clock = std::chrono::steady_clock;
  /// One that says nothing for so long is gone.
  static constexpr std::chrono::seconds kSilence{2};

  explicit OnePublisher(const MessageTopic& topic) : reader_(topic) {}

  /// Whether a message is to be heard. One that cannot be used is, where nobody else speaks: so it
  /// is counted as what it is.
  [[nodiscard]] bool hears(std::uint64_t publisher, std::string_view data, Clock::time_point now);
  /// Messages of others, which were not heard.
  [[nodiscard]] std::uint64_t num_of_others() const { return num_of_others_; }

 private:
  [[nodiscard]] bool is_usable(std::string_view data);

  TopicReader reader_;
  std::uint64_t publisher_ = 0;  ///< Who is heard; 0: nobody yet.
  Clock::time_point last_;
  std::uint64_t num_of_others_ = 0;
};

}  // namespace setsquare
