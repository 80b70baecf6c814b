// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/logs/bag/pose_history.hpp"

namespace setsquare {

/// The robot's odometry in a recording: of several topics that carry one, the one that is meant.
/// The poses of tf (odom -> base) serve where no topic of nav_msgs/Odometry is there.
class BagOdometry {
 public:
  /// The name under which tf's poses go; it can be asked for as a topic.
  static constexpr const char* kTransforms = "/tf";

  /// `wanted_topic`: the one to take, or empty for the likeliest (odometry_rank).
  explicit BagOdometry(std::string wanted_topic) : wanted_topic_(std::move(wanted_topic)) {}

  /// `base_frame`: whose pose it is.
  void add(const std::string& topic,
           Timestamp stamp,
           const Pose2& T_odom_base,
           const std::string& base_frame);

  /// The topic that is taken; empty as long as there is none. A better one that comes later takes
  /// its place until settle().
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  void settle() { is_settled_ = !chosen_.empty(); }

  /// Topics that were not taken, in the order of their names; without tf, which repeats a topic.
  [[nodiscard]] std::vector<std::string> others() const;

  /// Of the topic that is taken.
  [[nodiscard]] std::string base_frame() const;
  [[nodiscard]] std::optional<Pose2> at(Timestamp stamp) const;
  [[nodiscard]] bool reaches(Timestamp stamp) const;

 private:
  struct Candidate {
    PoseHistory poses;
    std::string base_frame;
  };

  [[nodiscard]] const Candidate* taken() const;
  void choose();

  std::string wanted_topic_;
  std::string chosen_;
  bool is_settled_ = false;
  std::map<std::string, Candidate> candidates_;
};

}  // namespace setsquare
