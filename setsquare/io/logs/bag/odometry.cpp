// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/odometry.hpp"

#include <tuple>

#include "setsquare/io/logs/bag/topic_role.hpp"

namespace setsquare {
namespace {

auto preference(const std::string& topic) {
  return std::tuple(topic == BagOdometry::kTransforms, odometry_rank(topic), topic);
}

}  // namespace

void BagOdometry::add(const std::string& topic,
                      Timestamp stamp,
                      const Pose2& T_odom_base,
                      const std::string& base_frame) {
  const auto [entry, is_new] = candidates_.try_emplace(topic);
  entry->second.base_frame = base_frame;
  entry->second.poses.add(stamp, T_odom_base);
  if (is_new && !is_settled_) choose();
}

void BagOdometry::choose() {
  chosen_.clear();
  for (const auto& [topic, candidate] : candidates_) {
    if (!wanted_topic_.empty() && topic != wanted_topic_) continue;
    if (chosen_.empty() || preference(topic) < preference(chosen_)) chosen_ = topic;
  }
}

std::vector<std::string> BagOdometry::others() const {
  std::vector<std::string> topics;
  for (const auto& [topic, candidate] : candidates_) {
    if (topic != chosen_ && topic != kTransforms) topics.push_back(topic);
  }
  return topics;
}

const BagOdometry::Candidate* BagOdometry::taken() const {
  const auto found = candidates_.find(chosen_);
  return found == candidates_.end() ? nullptr : &found->second;
}

std::string BagOdometry::base_frame() const {
  const Candidate* candidate = taken();
  return candidate == nullptr ? std::string() : candidate->base_frame;
}

std::optional<Pose2> BagOdometry::at(Timestamp stamp) const {
  const Candidate* candidate = taken();
  return candidate == nullptr ? std::nullopt : candidate->poses.at(stamp);
}

bool BagOdometry::reaches(Timestamp stamp) const {
  const Candidate* candidate = taken();
  return candidate != nullptr && candidate->poses.reaches(stamp);
}

}  // namespace setsquare
