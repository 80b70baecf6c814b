// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/kept_scans.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/robot_part_search.hpp"
#include "setsquare/mapping/scanners/scanners.hpp"
#include "setsquare/mapping/sweep_search.hpp"
#include "setsquare/mapping/tracked_scans.hpp"
#include "setsquare/mapping/unjudged_inputs.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/odometry_watch.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// A keyframe that tracking left.
struct TrackedKeyframe {
  KeyframePtr keyframe;
  MotionCovariance motion;      ///< From the keyframe before.
  double share_of_place = 1.0;  ///< One over the scanners that show a place (share_place).
};

/// What tracking tells of one scan of a map.
struct TrackStep {
  TrackedScan scan;
  std::shared_ptr<const Scan> kept;  ///< Null where the map does not keep the whole scan.
  std::optional<TrackedKeyframe> keyframe;
};

/// What tracking tells of what came: mostly one step, none of a scan that is not mapped.
struct TrackSteps {
  bool begins_again = false;  ///< What was told before does not hold: these are steps of all scans.
  std::vector<TrackStep> steps;
};

/// What a log's sensors turned out to be.
struct SensorReports {
  std::vector<MappedScanner> scanners;
  GyroReport gyro;
  OdometryReport odometry;
  SweepReport sweep;
  std::size_t num_with_odometry = 0;
};

class TrackingAgain;

/// The first half of Mapper: scans in, where each is by tracking out, at once. What loops say later
/// never comes back to it, so that the second half (GrowingMap) may run behind, on another thread.
///
/// 1. The scan is cleared of what is no measurement of the building: the robot's own parts, returns
///    that stand alone; odometry that is none is left out.
/// 2. It is placed against the recent keyframes (ScanTracker).
/// 3. Where the sweep time was found meanwhile, or parts of the robot, or the odometry was found
///    wrong, what came so far is to be tracked again by it (TrackingAgain).
class LogTracker {
 public:
  /// Throws ParameterError that names the field.
  explicit LogTracker(const MapperParams& params);

  /// As Mapper::add(). `steps` is what the map needs of it.
  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base, TrackSteps& steps);
  /// As Mapper::add_turn_rate().
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s);

  [[nodiscard]] SensorReports sensors() const;

  /// Throws ParameterError where add() would.
  static void require_valid(const Scan& scan, const std::optional<Pose2>& T_wheels_base);

  // The same in two parts, for whoever cannot wait until all is tracked again.

  /// add() of a scan that is tracked as those before.
  TrackedPose track(const Scan& scan, const std::optional<Pose2>& T_wheels_base, TrackSteps& steps);
  /// Where all that came is to be tracked again: the tracker that does it, once. Else null. Until
  /// it has caught up this one may go on; its poses are provisional.
  [[nodiscard]] std::unique_ptr<TrackingAgain> take_tracking_again();

 private:
  friend class TrackingAgain;

  /// add_turn_rate() of a rate that the search for the sweep time has seen.
  void turn(Timestamp stamp, double turn_rad_per_s);
  /// track() of a scan whose sweep time has been looked for.
  TrackedPose place(const Scan& scan,
                    const std::optional<Pose2>& T_wheels_base,
                    std::vector<TrackStep>& steps);
  /// The same of a scan without isolated returns and of odometry that is one.
  TrackedPose place_cleared(const Scan& scan,
                            const std::optional<Pose2>& T_wheels_base,
                            std::vector<TrackStep>& steps);

  MapperParams params_;
  SweepSearch sweeps_;
  RobotPartSearch robot_parts_;
  UnjudgedInputs unjudged_;
  OdometryWatch odometry_;
  ScanTracker tracker_;
  Scanners scanners_;
  MotionUncertainty uncertainty_;
  KeptScanChoice kept_;
  std::size_t num_with_odometry_ = 0;
};

/// A log that is tracked again by what was found of its sensors.
class TrackingAgain {
 public:
  TrackingAgain(LogTracker tracker, std::vector<MapperInput> inputs)
      : tracker_(std::move(tracker)), inputs_(std::move(inputs)) {}

  /// Tracks all that came. Returns the last scan's pose; `steps` are those of all.
  TrackedPose run(TrackSteps& steps);

  /// The tracker that goes on from there.
  [[nodiscard]] LogTracker take() { return std::move(tracker_); }

 private:
  LogTracker tracker_;
  std::vector<MapperInput> inputs_;
};

}  // namespace setsquare
