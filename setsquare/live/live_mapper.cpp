// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_mapper.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/live/map_frame.hpp"
#include "setsquare/live/stand_back.hpp"
#include "setsquare/mapping/growing_map.hpp"
#include "setsquare/mapping/log_tracker.hpp"

namespace setsquare {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

Pose2 base_by_tracking(const Pose2& T_odom_sensor, const Pose2& T_base_sensor) {
  return T_odom_sensor * T_base_sensor.inverse();
}

/// Of the last scan; what the map does not know is left at 0.
Eigen::Matrix3d covariance_of(const MappedScan& scan) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  if (scan.position_covariance_m2.allFinite()) {
    covariance.topLeftCorner<2, 2>() = scan.position_covariance_m2;
  }
  if (std::isfinite(scan.heading_sigma_rad)) {
    covariance(2, 2) = scan.heading_sigma_rad * scan.heading_sigma_rad;
  }
  return covariance;
}

}  // namespace

void LiveMapperParams::validate() const {
  mapper.validate();
  require_positive(map_period_s, "map_period_s");
  require_positive(max_drawing_share, "max_drawing_share");
  require_at_least_one(max_behind, "max_behind");
}

/// Two threads. The caller's tracks: `tracker_`. The other one, the drawer, has `map_`; `work_`
/// goes from the first to it, the place of tracking's frame comes back. While all is tracked again
/// the drawer has the tracker that will go on (again_), and the caller's tracker only stands in.
class LiveMapper::Parts {
 public:
  Parts(const LiveMapperParams& params, OnMap on_map)
      : params_(params), on_map_(std::move(on_map)), tracker_(params.mapper), map_(params.mapper) {
    if (params.known_map) {
      map_.go_on_with(*params.known_map);
      num_known_scans_ = map_.num_scans();
      has_changed_ = true;  // It is shown as it is, before the first scan.
      counts_.is_placed = false;
    }
    drawer_ = std::thread([this] { draw_until_end(); });
  }
  ~Parts() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    has_work_.notify_all();
    drawer_.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  LivePose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s);
  Map finish();
  std::future<LiveMapPtr> request_map();

  LiveMapPtr last_map() const {
    const std::lock_guard lock(mutex_);
    return last_map_;
  }
  LiveCounts counts() const {
    const std::lock_guard lock(mutex_);
    LiveCounts counts = counts_;
    counts.num_behind = work_.size() + num_in_work_;
    return counts;
  }

 private:
  /// What the caller's thread hands to the drawer.
  struct Work {
    TrackSteps steps;
    std::optional<SensorReports> sensors = {};  ///< Beside keyframes: maps are drawn of these.
    std::unique_ptr<TrackingAgain> again = {};  ///< All is to be tracked again: nothing else holds.
  };

  // The caller's thread.
  void take_over_tracker();
  void hand_over(Work work);
  void tell_failure();

  // The drawer.
  void draw_until_end();
  void take(Work work);
  void track_again(TrackingAgain& again);
  void draw();

  const LiveMapperParams params_;
  const OnMap on_map_;

  // Of the caller's thread.
  LogTracker tracker_;
  MapFrame frame_;
  std::size_t run_ = 0;  ///< Of tracking: all tracked again begins a new one.

  // Of the drawer.
  GrowingMap map_;
  SensorReports sensors_;
  std::size_t num_known_scans_ = 0;  ///< Of the map that is gone on with.
  Pose2 T_track_base_;               ///< Of the last scan of map_.
  std::size_t run_of_map_ = 0;       ///< Of the steps in map_.
  bool has_changed_ = false;         ///< A keyframe came since the last map.
  Clock::time_point next_drawing_ = Clock::now();

  mutable std::mutex mutex_;  ///< All below.
  std::condition_variable has_work_;
  std::condition_variable is_done_;  ///< The drawer, with what it took, or with all.
  std::deque<Work> work_;
  bool is_at_work_ = false;         ///< The drawer.
  std::size_t num_in_work_ = 0;     ///< Taken by it, not yet part of its map.
  bool is_tracking_again_ = false;  ///< Inputs go to catch_up_, the caller's poses are provisional.
  std::deque<MapperInput> catch_up_;
  std::optional<LogTracker> caught_up_;                      ///< The tracker that goes on, once.
  std::optional<std::pair<Pose2, std::size_t>> correction_;  ///< T_map_track, and of which run.
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  LiveMapPtr last_map_;
  LiveCounts counts_;
  std::vector<std::promise<LiveMapPtr>> requests_;
  bool is_finishing_ = false;  ///< No map is drawn: the caller waits for all to be taken.
  bool is_ending_ = false;
  std::exception_ptr failure_;

  std::thread drawer_;
};

// --- The caller's thread: tracking ---------------------------------------------------------------

LivePose LiveMapper::Parts::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  LogTracker::require_valid(scan, T_wheels_base);
  bool is_provisional = false;
  bool is_placed = false;
  Eigen::Matrix3d covariance;
  {
    const std::lock_guard lock(mutex_);
    tell_failure();
    take_over_tracker();
    is_provisional = is_tracking_again_;
    if (is_provisional) catch_up_.emplace_back(MapperScan{scan, T_wheels_base});
    if (correction_) frame_.correct(correction_->first, correction_->second);
    is_placed = counts_.is_placed;
    covariance = covariance_;
    ++counts_.num_scans;
  }
  TrackSteps steps;
  const TrackedPose tracked = tracker_.track(scan, T_wheels_base, steps);
  const MapFrame::Placed placed = frame_.place(
      base_by_tracking(tracked.T_odom_sensor, scan.T_base_sensor), run_, T_wheels_base);
  if (!is_provisional) {
    Work work{.steps = std::move(steps)};
    work.again = tracker_.take_tracking_again();
    if (tracked.is_keyframe) work.sensors = tracker_.sensors();
    hand_over(std::move(work));
  }
  if (tracked.status == TrackStatus::kLost) {
    const std::lock_guard lock(mutex_);
    ++counts_.num_lost;
  }
  return {.stamp = scan.stamp,
          .status = tracked.status,
          .is_mapped = tracked.is_mapped,
          .is_placed = is_placed,
          .T_map_base = placed.T_map_base,
          .T_odom_base = placed.T_odom_base,
          .has_wheels = T_wheels_base.has_value(),
          .T_map_odom = placed.T_map_odom,
          .covariance = covariance};
}

void LiveMapper::Parts::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  {
    const std::lock_guard lock(mutex_);
    take_over_tracker();
    if (is_tracking_again_) catch_up_.emplace_back(MapperTurnRate{stamp, turn_rad_per_s});
  }
  tracker_.add_turn_rate(stamp, turn_rad_per_s);
}

/// With the lock held.
void LiveMapper::Parts::take_over_tracker() {
  if (!caught_up_) return;
  tracker_ = std::move(*caught_up_);
  caught_up_.reset();
  is_tracking_again_ = false;
  ++run_;
}

void LiveMapper::Parts::hand_over(Work work) {
  if (!work.again && work.steps.steps.empty()) return;
  {
    std::unique_lock lock(mutex_);
    is_done_.wait(lock,
                  [this] { return failure_ || work_.size() + num_in_work_ < params_.max_behind; });
    if (work.again) {
      is_tracking_again_ = true;
      ++counts_.num_again;
    }
    work_.push_back(std::move(work));
  }
  has_work_.notify_one();
}

/// With the lock held.
void LiveMapper::Parts::tell_failure() {
  if (failure_) std::rethrow_exception(failure_);
}

Map LiveMapper::Parts::finish() {
  std::unique_lock lock(mutex_);
  is_finishing_ = true;
  is_done_.wait(lock, [this] {
    return failure_ || (work_.empty() && !is_at_work_ && (!is_tracking_again_ || caught_up_));
  });
  tell_failure();
  take_over_tracker();
  lock.unlock();  // The drawer waits for work, and none comes from elsewhere.
  Map map = map_.make(tracker_.sensors());
  lock.lock();
  is_finishing_ = false;
  has_work_.notify_one();
  return map;
}

std::future<LiveMapPtr> LiveMapper::Parts::request_map() {
  const std::lock_guard lock(mutex_);
  requests_.emplace_back();
  has_work_.notify_one();
  return requests_.back().get_future();
}

// --- The drawer: closing, solving, drawing ------------------------------------------------------

void LiveMapper::Parts::draw_until_end() {
  stand_back(params_.drawing_niceness);
  try {
    std::unique_lock lock(mutex_);
    while (!is_ending_) {
      std::deque<Work> taken = std::exchange(work_, {});
      std::vector<std::promise<LiveMapPtr>> requests = std::exchange(requests_, {});
      const bool is_due = Clock::now() >= next_drawing_ && !is_finishing_;
      const bool must_draw = has_changed_ && (is_due || !requests.empty());
      if (taken.empty() && requests.empty() && !must_draw) {
        is_done_.notify_all();
        if (has_changed_ && !is_finishing_) {
          has_work_.wait_until(lock, next_drawing_);
        } else {
          has_work_.wait(lock);
        }
        continue;
      }
      is_at_work_ = true;
      num_in_work_ = taken.size();
      lock.unlock();
      for (Work& work : taken) take(std::move(work));
      {
        const std::lock_guard taken_lock(mutex_);
        num_in_work_ = 0;
      }
      is_done_.notify_all();
      if (must_draw || (has_changed_ && !requests.empty())) draw();
      for (auto& request : requests) request.set_value(last_map());
      lock.lock();
      is_at_work_ = false;
    }
    for (auto& request : requests_) request.set_value(last_map_);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    for (auto& request : requests_) request.set_exception(failure_);
    is_done_.notify_all();
  }
}

void LiveMapper::Parts::take(Work work) {
  if (work.again) return track_again(*work.again);
  if (work.sensors) sensors_ = std::move(*work.sensors);
  for (const TrackStep& step : work.steps.steps) {
    has_changed_ = has_changed_ || step.keyframe;
    T_track_base_ = base_by_tracking(step.scan.T_odom_sensor, step.scan.T_base_sensor);
  }
  map_.add(std::move(work.steps));
}

/// All that came, and then what comes meanwhile, until the tracker has caught up: then it is the
/// caller's, and its next steps are work again.
void LiveMapper::Parts::track_again(TrackingAgain& again) {
  ++run_of_map_;
  Work work;
  (void)again.run(work.steps);
  LogTracker tracker = again.take();
  for (;;) {
    work.sensors = tracker.sensors();
    take(std::exchange(work, {}));
    std::deque<MapperInput> inputs;
    {
      const std::lock_guard lock(mutex_);
      if (catch_up_.empty() || is_ending_) {
        caught_up_ = std::move(tracker);
        return;
      }
      inputs = std::exchange(catch_up_, {});
    }
    for (const MapperInput& input : inputs) {
      if (const auto* rate = std::get_if<MapperTurnRate>(&input)) {
        tracker.add_turn_rate(rate->stamp, rate->turn_rad_per_s);
        continue;
      }
      const auto& [scan, T_wheels_base] = std::get<MapperScan>(input);
      (void)tracker.add(scan, T_wheels_base, work.steps);
      take(std::exchange(work, {}));
    }
  }
}

/// A map that cannot be made of what came (scans of a broken driver) is counted, and tried again
/// with what comes.
void LiveMapper::Parts::draw() {
  has_changed_ = false;
  const auto begin = Clock::now();
  next_drawing_ = begin + duration_of(params_.map_period_s);
  Map map;
  std::optional<OccupancyGrid> grid;
  try {
    map = map_.make_next(sensors_);
    grid = occupancy_grid(map);
  } catch (const Error&) {
    const std::lock_guard lock(mutex_);
    ++counts_.num_undrawn;
    return;
  }
  const double duration_s = std::chrono::duration<double>(Clock::now() - begin).count();
  next_drawing_ =
      begin + duration_of(std::max(params_.map_period_s, duration_s / params_.max_drawing_share));
  const MappedScan last = map.scans.back();
  LiveMapPtr drawn;
  {
    const std::lock_guard lock(mutex_);
    ++counts_.num_maps;
    counts_.map_duration_s = duration_s;
    drawn = std::make_shared<const LiveMap>(
        LiveMap{.number = counts_.num_maps, .map = std::move(map), .grid = std::move(*grid)});
    last_map_ = drawn;
    // A piece of track that could not be joined lies anywhere: the robot goes on from where it was.
    if (last.is_placed && drawn->map.scans.size() > num_known_scans_) {
      counts_.is_placed = true;
      correction_.emplace(last.T_map_base * T_track_base_.inverse(), run_of_map_);
      covariance_ = covariance_of(last);
    }
  }
  if (on_map_) on_map_(drawn);
}

// -------------------------------------------------------------------------------------------------

LiveMapper::LiveMapper(const LiveMapperParams& params, OnMap on_map) {
  params.validate();
  LiveMapperParams bounded = params;
  bounded.mapper.forgetting.max_known_poses = params.max_known_poses;
  parts_ = std::make_unique<Parts>(bounded, std::move(on_map));
}
LiveMapper::~LiveMapper() = default;

LivePose LiveMapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  return parts_->add(scan, T_wheels_base);
}

void LiveMapper::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  parts_->add_turn_rate(stamp, turn_rad_per_s);
}

Map LiveMapper::finish() { return parts_->finish(); }

std::future<LiveMapPtr> LiveMapper::request_map() { return parts_->request_map(); }

LiveMapPtr LiveMapper::last_map() const { return parts_->last_map(); }

LiveCounts LiveMapper::counts() const { return parts_->counts(); }

}  // namespace setsquare
