// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/transform_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace setsquare::ros {
namespace {

constexpr double kMaxNormError = 0.01;
constexpr double kMaxMendedNormError = 0.1;
constexpr double kFarthest_m = 1e8;

TransformFault fault_of(const TransformStamped& transform) {
  const std::string_view child = plain_frame_name(transform.child_frame_id);
  const std::string_view parent = plain_frame_name(transform.frame_id);
  if (child.empty() || parent.empty() || child == parent) return TransformFault::kNoFrame;
  return fault_of_pose(transform.translation_m, transform.rotation);
}

Eigen::Isometry3d isometry(const Eigen::Vector3d& translation_m, const Eigen::Quaterniond& q) {
  return Eigen::Translation3d(translation_m) * q;
}

/// Of two times outside of what is known the one farther out.
double farther(double a_s, double b_s) { return std::abs(a_s) >= std::abs(b_s) ? a_s : b_s; }

TransformLookup found() {
  TransformLookup lookup;
  lookup.status = LookupStatus::kFound;
  return lookup;
}

TransformLookup refused(std::string_view target,
                        std::string_view source,
                        LookupStatus status,
                        const std::string& why) {
  TransformLookup lookup;
  lookup.status = status;
  lookup.reason = fmt::format("no transform from {} to {}: {}", target, source, why);
  return lookup;
}

}  // namespace

std::string_view plain_frame_name(std::string_view frame_id) {
  if (frame_id.starts_with('/')) frame_id.remove_prefix(1);
  return frame_id;
}

std::string_view to_text(TransformFault fault) {
  switch (fault) {
    case TransformFault::kNoFrame:
      return "a frame without a name, or one that is its own parent";
    case TransformFault::kNotFinite:
      return "a number that is not finite";
    case TransformFault::kNoRotation:
      return "a quaternion of zeros";
    case TransformFault::kBadRotation:
      return "a quaternion whose length is far from 1";
    case TransformFault::kContradicts:
      return "a frame that scans were placed by, elsewhere than before";
    case TransformFault::kTooManyFrames:
      return "more frames than any robot has";
    case TransformFault::kNotNormalised:
      return "a quaternion whose length is not 1";
    case TransformFault::kParentChanged:
      return "a frame that hangs now from one parent, now from another";
    case TransformFault::kNone:
      break;
  }
  return {};
}

bool is_refused(TransformFault fault) {
  return fault != TransformFault::kNone && fault < TransformFault::kTooManyFrames;
}

TransformFault fault_of_pose(const Eigen::Vector3d& position_m,
                             const Eigen::Quaterniond& rotation) {
  const double norm = rotation.norm();
  // maxCoeff() may pass over what is no number.
  if (!position_m.allFinite() || position_m.cwiseAbs().maxCoeff() > kFarthest_m ||
      !std::isfinite(norm)) {
    return TransformFault::kNotFinite;
  }
  constexpr double kMinNorm = 1e-6;
  const double error = std::abs(norm - 1.0);
  if (norm < kMinNorm) return TransformFault::kNoRotation;
  if (error > kMaxMendedNormError) return TransformFault::kBadRotation;
  return error > kMaxNormError ? TransformFault::kNotNormalised : TransformFault::kNone;
}

TransformFault TransformTree::add_static(const TransformStamped& transform) {
  return add(transform, true);
}

TransformFault TransformTree::add(const TransformStamped& transform) {
  return add(transform, false);
}

TransformFault TransformTree::add(const TransformStamped& transform, bool is_static) {
  TransformFault fault = fault_of(transform);
  if (is_refused(fault)) return fault;
  const std::string_view child = plain_frame_name(transform.child_frame_id);
  const std::string_view parent = plain_frame_name(transform.frame_id);
  auto found = frames_.find(child);
  if (found == frames_.end()) {
    if (frames_.size() >= kMaxFrames) {
      fault = TransformFault::kTooManyFrames;
      if (!forget_oldest()) return fault;
    }
    found =
        frames_.emplace(child, Frame{.parent = std::string(parent), .is_static = is_static}).first;
  }
  Frame& frame = found->second;
  if (frame.is_held && contradicts(frame, transform, is_static)) {
    return TransformFault::kContradicts;
  }
  if (frame.is_held && (frame.is_static || is_static)) return fault;  // Said again.
  if (frame.parent != parent) {
    frame.parent = parent;
    frame.samples.clear();
    fault = TransformFault::kParentChanged;
  }
  if (is_static || frame.is_static != is_static) frame.samples.clear();
  frame.is_static = is_static;
  ++frame.num_added;
  frame.last_added = ++num_added_;
  insert(frame, {transform.stamp, transform.translation_m, transform.rotation.normalized()});
  return fault;
}

bool TransformTree::contradicts(const Frame& frame,
                                const TransformStamped& transform,
                                bool is_static) {
  constexpr double kSame_m = 1e-3;
  constexpr double kSame_rad = 1e-3;
  if (frame.parent != plain_frame_name(transform.frame_id)) return true;
  if (!frame.is_static && !is_static) return false;
  const Sample& held = frame.samples.back();
  return (held.translation_m - transform.translation_m).norm() > kSame_m ||
         held.rotation.angularDistance(transform.rotation.normalized()) > kSame_rad;
}

bool TransformTree::forget_oldest() {
  auto oldest = frames_.end();
  for (auto frame = frames_.begin(); frame != frames_.end(); ++frame) {
    if (frame->second.is_held) continue;
    if (oldest == frames_.end() || frame->second.last_added < oldest->second.last_added) {
      oldest = frame;
    }
  }
  if (oldest == frames_.end()) return false;
  frames_.erase(oldest);
  return true;
}

void TransformTree::hold(std::string_view target, std::string_view source) {
  Way from_target;
  Way from_source;
  target = plain_frame_name(target);
  source = plain_frame_name(source);
  if (!find_ways(target, source, from_target, from_source).is_found()) return;
  for (const Way& way : {from_target, from_source}) {
    for (const auto* link : way) frames_.find(link->first)->second.is_held = true;
  }
}

bool TransformTree::is_held(std::string_view child) const {
  const auto found = frames_.find(plain_frame_name(child));
  return found != frames_.end() && found->second.is_held;
}

void TransformTree::insert(Frame& frame, const Sample& sample) {
  std::deque<Sample>& samples = frame.samples;
  if (!samples.empty() && seconds_between(sample.stamp, samples.back().stamp) > kHistory_s) {
    samples.clear();  // The clock was set back.
  }
  const auto place = std::lower_bound(
      samples.begin(), samples.end(), sample, [](const Sample& a, const Sample& b) {
        return a.stamp < b.stamp;
      });
  if (place != samples.end() && place->stamp == sample.stamp) {
    *place = sample;
    return;
  }
  samples.insert(place, sample);
  while (samples.size() > kMaxKept ||
         seconds_between(samples.front().stamp, samples.back().stamp) > kHistory_s) {
    samples.pop_front();
  }
}

std::string_view TransformTree::parent_of(std::string_view child) const {
  const auto found = frames_.find(child);
  return found == frames_.end() ? std::string_view() : std::string_view(found->second.parent);
}

std::vector<TransformTree::Link> TransformTree::links() const {
  std::vector<Link> links;
  links.reserve(frames_.size());
  for (const auto& [child, frame] : frames_) {
    links.push_back({frame.parent, child, frame.is_static, frame.num_added});
  }
  return links;
}

bool TransformTree::is_known(std::string_view name) const {
  return frames_.contains(name) ||
         std::any_of(frames_.begin(), frames_.end(), [name](const auto& frame) {
           return frame.second.parent == name;
         });
}

bool TransformTree::find_way_up(std::string_view name, Way& way) const {
  for (auto frame = frames_.find(name); frame != frames_.end();
       frame = frames_.find(frame->second.parent)) {
    if (way.size() > frames_.size()) return false;
    way.push_back(&*frame);
  }
  return true;
}

TransformLookup TransformTree::find_ways(std::string_view target,
                                         std::string_view source,
                                         Way& from_target,
                                         Way& from_source) const {
  for (const std::string_view name : {target, source}) {
    if (target == source || is_known(name)) continue;
    return refused(target,
                   source,
                   LookupStatus::kUnknownFrame,
                   fmt::format("{} is not in any transform", name));
  }
  if (!find_way_up(target, from_target) || !find_way_up(source, from_source)) {
    return refused(target, source, LookupStatus::kLoop, "the frames above them form a loop");
  }
  const auto root = [](const Way& way, std::string_view frame) {
    return way.empty() ? frame : std::string_view(way.back()->second.parent);
  };
  if (root(from_target, target) != root(from_source, source)) {
    return refused(target,
                   source,
                   LookupStatus::kNotConnected,
                   fmt::format("one hangs from {}, the other from {}",
                               root(from_target, target),
                               root(from_source, source)));
  }
  while (!from_target.empty() && !from_source.empty() && from_target.back() == from_source.back()) {
    from_target.pop_back();  // Where their common way goes makes no difference.
    from_source.pop_back();
  }
  return found();
}

TransformLookup TransformTree::look_up(std::string_view target,
                                       std::string_view source,
                                       Timestamp stamp,
                                       double max_outside_s) const {
  target = plain_frame_name(target);
  source = plain_frame_name(source);
  Way from_target;
  Way from_source;
  TransformLookup ways = find_ways(target, source, from_target, from_source);
  if (!ways.is_found()) return ways;
  const TransformLookup root_target = compose(from_target, stamp, max_outside_s);
  TransformLookup root_source = compose(from_source, stamp, max_outside_s);
  const TransformLookup& worse = root_target.is_found() ? root_source : root_target;
  if (!worse.is_found()) {
    TransformLookup outside = refused(target, source, worse.status, worse.reason);
    outside.outside_s = worse.outside_s;
    return outside;
  }
  TransformLookup& answer = root_source;
  answer.T_target_source = root_target.T_target_source.inverse() * answer.T_target_source;
  answer.is_static = answer.is_static && root_target.is_static;
  answer.outside_s = farther(answer.outside_s, root_target.outside_s);
  return answer;
}

/// The pose of the first frame of a way in the parent of its last.
TransformLookup TransformTree::compose(const Way& way, Timestamp stamp, double max_outside_s) {
  TransformLookup up = found();
  for (const auto* link : way) {
    const auto& [child, frame] = *link;
    up.is_static = up.is_static && frame.is_static;
    double outside_s = 0.0;
    up.T_target_source = pose_in_parent(frame, stamp, outside_s) * up.T_target_source;
    up.outside_s = farther(up.outside_s, outside_s);
    if (std::abs(outside_s) <= max_outside_s) continue;
    up.status = LookupStatus::kOutsideOfTime;
    up.reason = fmt::format("where {} is in {} is known from {} to {}, not at {}",
                            child,
                            frame.parent,
                            to_string(frame.samples.front().stamp),
                            to_string(frame.samples.back().stamp),
                            to_string(stamp));
    break;
  }
  return up;
}

Eigen::Isometry3d TransformTree::pose_in_parent(const Frame& frame,
                                                Timestamp stamp,
                                                double& outside_s) {
  const std::deque<Sample>& samples = frame.samples;
  if (frame.is_static) return isometry(samples.front().translation_m, samples.front().rotation);
  const auto after = std::lower_bound(
      samples.begin(), samples.end(), stamp, [](const Sample& sample, Timestamp time) {
        return sample.stamp < time;
      });
  if (after == samples.end() || after == samples.begin()) {
    const Sample& nearest = after == samples.end() ? samples.back() : samples.front();
    outside_s = seconds_between(nearest.stamp, stamp);
    return isometry(nearest.translation_m, nearest.rotation);
  }
  const Sample& before = *std::prev(after);
  const double share =
      seconds_between(before.stamp, stamp) / seconds_between(before.stamp, after->stamp);
  return isometry(before.translation_m + share * (after->translation_m - before.translation_m),
                  before.rotation.slerp(share, after->rotation));
}

}  // namespace setsquare::ros
