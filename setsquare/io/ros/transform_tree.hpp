// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

/// "/base_link" to "base_link": the slash is of the old tf.
[[nodiscard]] std::string_view plain_frame_name(std::string_view frame_id);

/// What is wrong with a transform that was added.
enum class TransformFault : std::uint8_t {
  kNone,
  kNoFrame,        ///< Refused: a frame has no name, or is its own parent.
  kNotFinite,      ///< Refused: a number is not finite.
  kNoRotation,     ///< Refused: the quaternion is zero.
  kBadRotation,    ///< Refused: the quaternion's length is off by more than 10 %.
  kContradicts,    ///< Refused: a frame that is held (TransformTree::hold) stands elsewhere.
  kTooManyFrames,  ///< Taken: in place of a frame that is not held (kMaxFrames); else refused.
  kNotNormalised,  ///< Taken with the quaternion made of length 1, which was off by over 1 %.
  kParentChanged,  ///< Taken: the frame hangs from another parent now, its past is forgotten.
};

/// The fault in words: "a quaternion of zeros"; empty for kNone.
[[nodiscard]] std::string_view to_text(TransformFault fault);
/// Whether the transform was not taken.
[[nodiscard]] bool is_refused(TransformFault fault);

/// What is wrong with a pose in itself: kNone, kNotFinite, kNoRotation, kBadRotation,
/// kNotNormalised. Positions farther than 1e8 m are no numbers of a robot's: kNotFinite.
[[nodiscard]] TransformFault fault_of_pose(const Eigen::Vector3d& position_m,
                                           const Eigen::Quaterniond& rotation);

enum class LookupStatus : std::uint8_t {
  kFound,
  kUnknownFrame,   ///< A frame is in no transform.
  kNotConnected,   ///< The frames hang from different roots.
  kLoop,           ///< A frame is above itself.
  kOutsideOfTime,  ///< A moving transform on the way is not known at the time.
};

/// The answer to "where is `source` in `target`?".
struct TransformLookup {
  LookupStatus status = LookupStatus::kUnknownFrame;
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();  ///< Where kFound.
  /// No transform on the way moves: the answer is the same at all times until the tree changes.
  bool is_static = true;
  /// kOutsideOfTime: how far from what is known, in s; negative before its first stamp (it will not
  /// come any more), positive behind its last (it may still come). Where kFound, how far beyond
  /// what is known the nearest was taken.
  double outside_s = 0.0;
  std::string reason;  ///< A sentence where not kFound.

  [[nodiscard]] bool is_found() const { return status == LookupStatus::kFound; }
};

/// Coordinate frames by name, each placed in its parent, as tf messages give them.
///
/// A static transform holds at all times. Of a moving one the last 30 s are kept, at most 2000 of
/// them; between two neighbours the translation is interpolated linearly and the rotation along the
/// shortest arc. Where the stamps jump back by more than those 30 s, that transform begins anew.
///
/// The last that comes holds, but for frames that are held: what scans were placed by does not
/// change its parent, and what never moved does not move.
class TransformTree {
 public:
  static constexpr std::size_t kMaxFrames = 500;
  static constexpr std::size_t kMaxKept = 2000;
  static constexpr double kHistory_s = 30.0;

  /// Adds a transform of /tf_static.
  TransformFault add_static(const TransformStamped& transform);
  /// Adds a transform of /tf.
  TransformFault add(const TransformStamped& transform);

  /// The pose of `source` in `target` at a time. Beyond the first and the last stamp of a moving
  /// transform the nearest is taken, at most max_outside_s away.
  [[nodiscard]] TransformLookup look_up(std::string_view target,
                                        std::string_view source,
                                        Timestamp stamp,
                                        double max_outside_s = 0.0) const;

  /// From now on the transforms between two frames are held.
  void hold(std::string_view target, std::string_view source);
  [[nodiscard]] bool is_held(std::string_view child) const;

  /// A frame that has a parent.
  struct Link {
    std::string parent;
    std::string child;
    bool is_static = true;
    std::uint64_t num_added = 0;
  };
  /// The frame that a frame hangs from; empty for a frame in no transform, and for a root.
  [[nodiscard]] std::string_view parent_of(std::string_view child) const;
  /// Every frame that has a parent, by the child's name.
  [[nodiscard]] std::vector<Link> links() const;

 private:
  struct Sample {
    Timestamp stamp;
    Eigen::Vector3d translation_m;
    Eigen::Quaterniond rotation;
  };
  struct Frame {
    std::string parent;
    bool is_static = true;
    bool is_held = false;
    std::uint64_t num_added = 0;
    std::uint64_t last_added = 0;     ///< By num_added_.
    std::deque<Sample> samples = {};  ///< By stamp, no two of the same; not empty.
  };
  /// The way from a frame up to its root: the frames that have a parent.
  using Way = std::vector<const std::pair<const std::string, Frame>*>;

  TransformFault add(const TransformStamped& transform, bool is_static);
  /// Whether a transform is not that of a frame that is held.
  [[nodiscard]] static bool contradicts(const Frame& frame,
                                        const TransformStamped& transform,
                                        bool is_static);
  /// Makes place for a frame. Returns whether there is one.
  bool forget_oldest();
  static void insert(Frame& frame, const Sample& sample);
  [[nodiscard]] bool is_known(std::string_view name) const;
  [[nodiscard]] bool find_way_up(std::string_view name, Way& way) const;
  [[nodiscard]] TransformLookup find_ways(std::string_view target,
                                          std::string_view source,
                                          Way& from_target,
                                          Way& from_source) const;
  [[nodiscard]] static TransformLookup compose(const Way& way,
                                               Timestamp stamp,
                                               double max_outside_s);
  [[nodiscard]] static Eigen::Isometry3d pose_in_parent(const Frame& frame,
                                                        Timestamp stamp,
                                                        double& outside_s);

  std::map<std::string, Frame, std::less<>> frames_;  ///< By the child's name.
  std::uint64_t num_added_ = 0;
};

}  // namespace setsquare::ros
