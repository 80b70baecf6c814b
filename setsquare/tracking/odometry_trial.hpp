// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller, because tests drive it without scans.
#pragma once

#include <cstddef>
#include <deque>
#include <Eigen/Core>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/map/odometry_report.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/step_reach.hpp"

namespace setsquare {

/// Whether odometry that steps so shows any motion: 1 cm, or half a degree.
[[nodiscard]] bool moves(const Pose2& step);

/// Where a scan was placed, for the odometry that came with it.
struct PlacedBase {
  Timestamp stamp;
  Pose2 T_odom_base;
  bool is_placed = false;   ///< Else it was lost.
  bool is_restart = false;  ///< Tracking begins anew there.
  bool is_certain = false;  ///< By walls that determine it, without a jump.
};

/// One kind of motion, ways or turns: what the scans show of it against what the wheels do.
class MotionOnTrial {
 public:
  /// What the latest stretches say.
  enum class Finding { kOpen, kFits, kStill, kUnlike };

  explicit MotionOnTrial(const OdometryTrialParams& params) : params_(params) {}

  /// The motion along a stretch, by both: a way, or a turn and 0.
  void add(const Eigen::Vector2d& by_scans, const Eigen::Vector2d& by_wheels);

  [[nodiscard]] Finding finding() const { return finding_; }
  [[nodiscard]] const OdometryComparison& comparison() const { return comparison_; }
  /// Whether the latest stretches fit, and closely.
  [[nodiscard]] bool is_true() const;
  /// By which the odometry's motion is to be multiplied; 1 where it is near it.
  [[nodiscard]] double correction() const;

 private:
  struct Stretch {
    Eigen::Vector2d by_scans;
    Eigen::Vector2d by_wheels;
  };

  void judge();

  OdometryTrialParams params_;
  std::deque<Stretch> stretches_;  ///< The latest.
  Finding finding_ = Finding::kOpen;
  OdometryComparison comparison_;
};

/// Odometry on trial: it is used as good as it has proved. For logs whose odometry is none: it
/// stands still, turns the other way, counts centimetres, shows noise, or jumps.
///
/// 1. Stretches of the track along which the scans determined the motion, of 0.3 m or 10 degrees
///    by the scans, are compared with the odometry's motion meanwhile. Motion that the odometry
///    alone shows is not held against it: scans stand still for more reasons than wheels do.
/// 2. The ways' scale and that of the turns are medians over the latest stretches, for single ones
///    may be wrong. A scale far from 1 that fits most stretches is mended.
/// 3. Odometry that fits most stretches by no scale, stands still or turns the other way is
///    ignored, until it fits again.
/// 4. A step that no robot makes is ignored alone, unless the scans make such steps as well: then
///    the stamps are wrong.
class OdometryTrial {
 public:
  explicit OdometryTrial(const OdometryTrialParams& params)
      : params_(params), ways_(params), turns_(params) {}

  /// The pose as far as it is believed: its steps mended, in a frame that stays put. Nothing where
  /// the odometry, or its step since the last scan, is ignored.
  [[nodiscard]] std::optional<Pose2> believed(const std::optional<Pose2>& T_wheels_base,
                                              Timestamp stamp) const;

  /// Whether the wheels have stood still since the last scan that was not lost.
  [[nodiscard]] bool is_at_rest(const std::optional<Pose2>& T_wheels_base) const;

  /// Whether they have not moved at all since then.
  [[nodiscard]] bool has_not_moved(const std::optional<Pose2>& T_wheels_base) const;

  /// How far the robot may be off where its odometry has it after `step` (m, rad): by five standard
  /// deviations of what the scans have shown of it. Nothing unless its ways and its turns have both
  /// proved true.
  [[nodiscard]] std::optional<StepReach> proved_reach(const Pose2& step) const;

  /// The next scan, placed, with the pose that came with it.
  void add(const std::optional<Pose2>& T_wheels_base, const PlacedBase& placed);

  [[nodiscard]] const OdometryReport& report() const { return report_; }

  /// What has been found, for a log that begins anew.
  [[nodiscard]] OdometryTrial judged() const;

 private:
  /// Of the last scan.
  struct Last {
    Pose2 T_wheels_base;
    Pose2 T_mended_base;
    PlacedBase placed;
  };

  [[nodiscard]] bool is_refuted() const;
  [[nodiscard]] bool is_ignored(const Pose2& step, Timestamp stamp) const;
  /// Whether the scans make the step as well.
  [[nodiscard]] bool is_confirmed(const Pose2& step, const PlacedBase& placed) const;
  [[nodiscard]] Pose2 mended(const Pose2& step) const;
  /// The stretch that grows, with the last scan.
  void grow();
  /// The wheels' motion since the last scan that was not lost.
  [[nodiscard]] std::optional<Pose2> moved_since_placed(
      const std::optional<Pose2>& T_wheels_base) const;
  void compare(const Pose2& by_scans, const Pose2& by_wheels);
  [[nodiscard]] OdometryVerdict verdict() const;

  OdometryTrialParams params_;
  std::optional<Last> last_;
  std::optional<Last> stretch_;           ///< Where the growing one begins.
  std::optional<Pose2> T_wheels_placed_;  ///< At the last scan that was not lost.
  MotionOnTrial ways_;
  MotionOnTrial turns_;
  bool is_mended_ = false;  ///< Once it was.
  std::size_t num_confirmed_jumps_ = 0;
  OdometryReport report_;
};

}  // namespace setsquare
