// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// What a message says that must go on from what the last ones of its kind said.
struct CourseMessage {
  Timestamp stamp;
  Timestamp log_time;
  std::string frames;      ///< Of what it speaks: "odom base_link"; "laser".
  bool is_placed = false;  ///< Its frames are known to belong to the robot: others may be, too.
  /// Of a pose that moves.
  std::optional<Eigen::Isometry3d> pose = std::nullopt;
};

/// Whether the messages of one topic, or of one frame, go on from one to the next, so that what a
/// broken or a second node says between them can be left out.
///
/// Of two that follow each other the later one has a stamp that is not more than 1 s earlier, and
/// not more than 1 s later, unless as much time passed between their coming (1000 s in a recording
/// whose log times have not shown to be those of their coming); it names the same frames; and a
/// pose moved no faster than robots do. What does not go on is left out until it goes on by itself:
/// 3 messages and half a second long, with nothing between that goes on from before. So a clock
/// that was set, an odometry that began again or a node in place of another is believed after half
/// a second, while two that speak in turns are one that counts and one that does not.
class MessageCourse {
 public:
  /// `has_arrival_times`: log times say when messages came, as those of a robot do. Those of a
  /// recording may mean nothing: then all messages are taken until some have gone on.
  explicit MessageCourse(bool has_arrival_times) : has_arrival_times_(has_arrival_times) {}

  /// Why the message is to be left out; empty where it goes on.
  [[nodiscard]] std::string_view fault_of(CourseMessage message);

 private:
  /// Messages that go on from each other.
  struct Line {
    CourseMessage first;
    CourseMessage last;
    std::uint64_t num = 1;
  };
  static constexpr std::size_t kMaxOthers = 64;

  [[nodiscard]] std::string_view break_between(const CourseMessage& before,
                                               const CourseMessage& after) const;
  [[nodiscard]] double longest_jump_ahead_s() const;
  [[nodiscard]] bool may_take_over(const Line& other) const;
  void add_other(CourseMessage message);

  bool has_arrival_times_ = false;
  std::optional<Line> taken_;
  std::vector<Line> others_;  ///< Since the last message that was taken; the latest last.
};

}  // namespace setsquare
