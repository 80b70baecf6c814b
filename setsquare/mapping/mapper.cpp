// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <cmath>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/growing_track.hpp"
#include "setsquare/mapping/known_maps.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/robot_part_search.hpp"
#include "setsquare/mapping/scanners/scanners.hpp"
#include "setsquare/mapping/sweep_search.hpp"
#include "setsquare/mapping/unjudged_inputs.hpp"
#include "setsquare/scan/isolated_returns.hpp"
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
  /// `known`: a map to go on with; may be null.
  Parts(const MapperParams& params, std::shared_ptr<const KnownMaps> known)
      : params_(params),
        known_(std::move(known)),
        sweeps_(params.tracker),
        robot_parts_(params.leaves_out_robot_parts),
        tracker_(params.tracker),
        scanners_(params.mounting),
        track_(known_ ? known_->track : GrowingTrack(params)) {
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
  [[nodiscard]] std::size_t num_scans() const { return track_.num_scans(); }

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
  /// What the log's sensors turned out to be, whatever is mapped.
  void add_sensors(Map& map) const;

  MapperParams params_;
  std::shared_ptr<const KnownMaps> known_;
  SweepSearch sweeps_;
  RobotPartSearch robot_parts_;
  UnjudgedInputs unjudged_;
  OdometryWatch odometry_;
  ScanTracker tracker_;
  Scanners scanners_;
  GrowingTrack track_;
  std::size_t num_tracked_ = 0;
  std::size_t num_with_odometry_ = 0;
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
  auto again = std::make_unique<Parts>(params_, known_);
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
  track_.add(scan, tracked, tracker_);
  ++num_tracked_;
  return tracked;
}

Map Mapper::Parts::finish() const {
  return track_.make([this](Map& map) { add_sensors(map); });
}

void Mapper::Parts::add_sensors(Map& map) const {
  if (known_) write_sensors(*known_, map);
  if (known_ && num_tracked_ == 0) return;
  map.scanners = scanners_.results();
  map.gyro = tracker_.gyro();
  map.odometry = tracker_.odometry();
  map.odometry.num_ignored += odometry_.num_ignored();
  map.sweep = sweeps_.report();
  map.num_with_odometry += num_with_odometry_;
}

Mapper::Mapper() : Mapper(MapperParams{}) {}
Mapper::Mapper(const MapperParams& params) : parts_(std::make_unique<Parts>(params, nullptr)) {}
Mapper::Mapper(const Map& map, const MapperParams& params)
    : parts_(std::make_unique<Parts>(
          params, std::make_shared<const KnownMaps>(known_maps({&map, 1}, params)))) {}
Mapper::Mapper(const Map& map) : Mapper(map, MapperParams{}) {}
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

Map merge(std::span<const Map> maps, const MapperParams& params) {
  if (maps.empty()) throw ParameterError("maps", "must be one at least");
  KnownMaps known = known_maps(maps, params);
  known.track.date_by_stamps();
  return known.track.make([&](Map& map) { write_sensors(known, map); });
}

Map merge(std::span<const Map> maps) { return merge(maps, MapperParams{}); }

}  // namespace setsquare
