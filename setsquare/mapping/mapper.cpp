// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <cmath>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/kept_scans.hpp"
#include "setsquare/mapping/map_maker.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/robot_part_search.hpp"
#include "setsquare/mapping/scanners/scanners.hpp"
#include "setsquare/mapping/sweep_search.hpp"
#include "setsquare/mapping/turn_checks.hpp"
#include "setsquare/mapping/unjudged_inputs.hpp"
#include "setsquare/scan/isolated_returns.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/odometry_watch.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {
namespace {

void require_finite(const Pose2& pose, const char* name) {
  if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad)) return;
  throw ParameterError(name, "must be finite");
}

}  // namespace

class Mapper::Parts {
 public:
  explicit Parts(const MapperParams& params)
      : params_(params),
        sweeps_(params.tracker),
        robot_parts_(params.leaves_out_robot_parts),
        tracker_(params.tracker),
        scanners_(params.mounting),
        uncertainty_(params.motion),
        turn_checks_(params.turns),
        closer_(params.closing) {
    params_.validate();
  }

  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
    sweeps_.add_turn_rate(stamp, turn_rad_per_s);
    robot_parts_.add_turn_rate(stamp, turn_rad_per_s);
    turn(stamp, turn_rad_per_s);
  }
  /// Where the sweep time was found meanwhile, or parts of the robot, or the odometry was found
  /// wrong: what came so far mapped again by it, and the last scan's pose. Else null, and `last`
  /// stays.
  [[nodiscard]] std::unique_ptr<Parts> mapped_again(TrackedPose& last);
  [[nodiscard]] Map finish() const;
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }

 private:
  /// add_turn_rate() of a rate that the search for the sweep time has seen.
  void turn(Timestamp stamp, double turn_rad_per_s) {
    unjudged_.add(MapperTurnRate{stamp, turn_rad_per_s});
    tracker_.add_turn_rate(stamp, turn_rad_per_s);
  }
  /// add() of a scan whose sweep time has been looked for.
  TrackedPose map(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  /// The same of a scan without isolated returns and of odometry that is one.
  TrackedPose add_cleared(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  /// The scan that was tracked last. Where several scanners leave keyframes, each is one of as many
  /// that show a place: the same walls (share_place) and one step of the track.
  void add_keyframe(const Scan& scan);
  /// What the log's sensors turned out to be, whatever is mapped.
  void add_sensors(Map& map) const;

  MapperParams params_;
  SweepSearch sweeps_;
  RobotPartSearch robot_parts_;
  UnjudgedInputs unjudged_;
  OdometryWatch odometry_;
  ScanTracker tracker_;
  Scanners scanners_;
  MotionUncertainty uncertainty_;
  TurnChecks turn_checks_;
  LoopCloser closer_;
  std::vector<TrackedScan> scans_;
  std::size_t num_with_odometry_ = 0;
  KeptScans kept_;
  KeyframeTrack track_;
  std::vector<HeadingEvidence> evidence_;
  std::size_t num_closed_ = 0;  ///< Keyframes when loops were last looked for.
};

TrackedPose Mapper::Parts::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  scan.validate();
  require_finite(scan.T_base_sensor, "T_base_sensor");
  if (T_wheels_base) require_finite(*T_wheels_base, "T_wheels_base");
  sweeps_.add(scan, T_wheels_base);
  robot_parts_.add(scan, T_wheels_base);
  return map(scan, T_wheels_base);
}

TrackedPose Mapper::Parts::map(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  unjudged_.add(MapperScan{scan, T_wheels_base});
  const std::optional<Scan> mended = sweeps_.mended(scan);
  const Scan& timed = mended ? *mended : scan;
  const std::optional<Scan> without_parts = robot_parts_.cleared(timed);
  const Scan& seen = without_parts ? *without_parts : timed;
  const std::optional<Scan> cleared = without_isolated_returns(seen);
  return add_cleared(cleared ? *cleared : seen, odometry_.believed(seen, T_wheels_base));
}

std::unique_ptr<Mapper::Parts> Mapper::Parts::mapped_again(TrackedPose& last) {
  std::vector<MapperInput> inputs = sweeps_.take_to_map_again();
  if (inputs.empty()) inputs = robot_parts_.take_to_map_again();
  const bool has_other_scans = !inputs.empty();
  if (!has_other_scans) inputs = unjudged_.take_to_map_again(tracker_.odometry().verdict);
  if (inputs.empty()) return nullptr;
  auto again = std::make_unique<Parts>(params_);
  again->sweeps_ = sweeps_;
  again->robot_parts_ = robot_parts_;
  if (!has_other_scans) {
    again->tracker_.judge_odometry_by(tracker_.judged_odometry());
    again->unjudged_.close();
  }
  for (const MapperInput& input : inputs) {
    if (const auto* rate = std::get_if<MapperTurnRate>(&input)) {
      again->turn(rate->stamp, rate->turn_rad_per_s);
    } else {
      const auto& [scan, T_wheels_base] = std::get<MapperScan>(input);
      last = again->map(scan, T_wheels_base);
    }
  }
  return again;
}

TrackedPose Mapper::Parts::add_cleared(const Scan& scan,
                                       const std::optional<Pose2>& T_wheels_base) {
  if (!scanners_.admit(scan, T_wheels_base, tracker_)) {
    return tracker_.expected(scan, T_wheels_base);
  }
  num_with_odometry_ += T_wheels_base.has_value();
  const TrackedPose tracked = tracker_.track(scan, T_wheels_base);
  const double open_sigma_m = uncertainty_.add(tracked, {scan.scanner, scan.stamp});
  scans_.push_back(
      {scan.stamp, tracked, scan.T_base_sensor, open_sigma_m, uncertainty_.open_turn_sigma_rad()});
  const Scan& placed = tracker_.deskewed_scan() ? *tracker_.deskewed_scan() : scan;
  kept_.add(tracked, scan.scanner, [&]() -> std::shared_ptr<const Scan> {
    if (!tracked.is_keyframe) return std::make_shared<const Scan>(placed);
    const KeyframePtr& keyframe = tracker_.submap().back();
    return {keyframe, &keyframe->scan};
  });
  if (!tracked.is_keyframe) return tracked;

  add_keyframe(placed);
  if (track_.size() >= next_closing(num_closed_, params_)) {
    const FusedHeadings headings = turn_checks_.fuse(track_, evidence_, params_.heading);
    close_loops(track_, headings.heading_rad, track_.size(), params_, closer_);
    num_closed_ = track_.size();
  }
  return tracked;
}

void Mapper::Parts::add_keyframe(const Scan& scan) {
  const TrackedPose& tracked = scans_.back().tracked;
  const bool is_first = track_.keyframes.empty();
  track_.keyframes.push_back(tracker_.submap().back());
  const double share_of_place = 1.0 / static_cast<double>(tracker_.num_scanners());
  track_.motions.push_back(uncertainty_.take(share_of_place));
  const bool is_restart = tracked.is_restart && !is_first;
  const bool is_tied = track_.motions.back().has_odometry;
  const std::size_t stretch = is_first ? 0 : track_.stretches.back();
  const std::size_t piece = is_first ? 0 : track_.pieces.back();
  track_.stretches.push_back(stretch + (is_restart ? 1 : 0));
  track_.pieces.push_back(piece + (is_restart && !is_tied ? 1 : 0));

  evidence_.push_back(
      {.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
       .step_sigma_rad = std::sqrt(track_.motions.back().rotation_rad2),
       .proposals = heading_proposals(scan, params_.direction, params_.confident_margin)});
  share_place(share_of_place, evidence_.back());
}

Map Mapper::Parts::finish() const {
  if (track_.size() == 0) {
    Map map = assemble_map({.scans = scans_, .kept_scans = kept_.kept(), .track = track_});
    add_sensors(map);
    return map;
  }
  const TrackedLog log{.scans = scans_,
                       .kept_scans = kept_.kept(),
                       .track = track_,
                       .evidence = evidence_,
                       .turn_checks = turn_checks_,
                       .closer = closer_,
                       .add_sensors = [this](Map& map) { add_sensors(map); }};
  return MapMaker(log, params_).make();
}

void Mapper::Parts::add_sensors(Map& map) const {
  map.scanners = scanners_.results();
  map.gyro = tracker_.gyro();
  map.odometry = tracker_.odometry();
  map.odometry.num_ignored += odometry_.num_ignored();
  map.sweep = sweeps_.report();
  map.num_with_odometry = num_with_odometry_;
}

Mapper::Mapper() : Mapper(MapperParams{}) {}
Mapper::Mapper(const MapperParams& params) : parts_(std::make_unique<Parts>(params)) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

TrackedPose Mapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  TrackedPose tracked = parts_->add(scan, T_wheels_base);
  if (auto again = parts_->mapped_again(tracked)) parts_ = std::move(again);
  return tracked;
}

void Mapper::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  parts_->add_turn_rate(stamp, turn_rad_per_s);
}

Map Mapper::finish() const { return parts_->finish(); }

std::size_t Mapper::num_scans() const { return parts_->num_scans(); }

}  // namespace setsquare
