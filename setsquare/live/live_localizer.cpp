// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_localizer.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "setsquare/core/finite_pose.hpp"
#include "setsquare/live/stand_back.hpp"
#include "setsquare/localisation/localizer_tracker.hpp"
#include "setsquare/localisation/place_hypotheses.hpp"

namespace setsquare {

/// Two threads. The caller's tracks: `tracker_`. The other one has `hypotheses_`; `work_` goes from
/// the first to it, what it last said of the place comes back.
class LiveLocalizer::Parts {
 public:
  Parts(std::shared_ptr<const KnownMap> map,
        const LocalisationParams& params,
        OnPlace on_place,
        const Behind& behind)
      : behind_(behind), on_place_(std::move(on_place)), hypotheses_(std::move(map), params) {
    placer_ = std::thread([this] { place_until_end(); });
  }
  ~Parts() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    has_work_.notify_all();
    placer_.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  LivePose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  void finish();
  void set_pose(const Pose2& T_map_base) {
    require_finite_pose(T_map_base, "T_map_base");
    const std::lock_guard lock(mutex_);
    said_ = T_map_base;
  }
  std::size_t num_behind() const {
    const std::lock_guard lock(mutex_);
    return work_.size() + (is_at_work_ ? 1 : 0);
  }
  std::size_t num_left_out() const {
    const std::lock_guard lock(mutex_);
    return num_left_out_;
  }
  std::optional<LocalisedPose> last_place() const {
    const std::lock_guard lock(mutex_);
    return last_ ? std::optional(last_->place) : std::nullopt;
  }

 private:
  /// A scan, and where tracking has it.
  struct Work {
    TrackedPose tracked;
    Scan scan;
    std::size_t run = 0;
    std::optional<Pose2> said;  ///< Before it is placed.

    [[nodiscard]] Pose2 T_track_base() const {
      return tracked.T_odom_sensor * scan.T_base_sensor.inverse();
    }
  };
  /// What is known of the place, in which run of tracking.
  struct Known {
    LocalisedPose place;
    Pose2 T_map_track;
    std::size_t run = 0;
  };

  void leave_out_oldest();
  void place_until_end();
  [[nodiscard]] Known placed(const Work& work);

  const Behind behind_;
  const OnPlace on_place_;
  LocalizerTracker tracker_;  ///< Of the caller's thread, as the two below.
  std::size_t run_ = 0;       ///< Where tracking lost the robot, another one begins.
  std::size_t num_scans_ = 0;
  PlaceHypotheses hypotheses_;  ///< Of the other thread.

  mutable std::mutex mutex_;  ///< All below.
  std::condition_variable has_work_;
  std::condition_variable has_placed_;
  std::deque<Work> work_;
  std::size_t num_left_out_ = 0;
  std::optional<Pose2> said_;
  std::optional<Known> last_;
  bool is_at_work_ = false;
  bool is_ending_ = false;
  std::exception_ptr failure_;

  std::thread placer_;
};

// --- The caller's thread: tracking ---------------------------------------------------------------

LivePose LiveLocalizer::Parts::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  const TrackedPose tracked = tracker_.track(scan, T_wheels_base);
  const bool is_first = num_scans_++ == 0;
  if (tracked.is_restart && !is_first && !tracked.has_odometry) ++run_;
  const Pose2 T_track_base = tracked.T_odom_sensor * scan.T_base_sensor.inverse();
  LivePose pose;
  pose.stamp = scan.stamp;
  pose.status = tracked.status;
  pose.is_placed = false;
  pose.T_odom_base = T_wheels_base.value_or(T_track_base);
  pose.has_wheels = T_wheels_base.has_value();
  pose.localisation = LocalisationStatus::kLost;
  Work work{tracked, tracker_.seen(scan), run_, {}};
  std::unique_lock lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  if (last_ && last_->run == run_) {
    pose.localisation = last_->place.status;
    pose.is_placed = last_->place.status == LocalisationStatus::kLocalised;
    pose.T_map_base = last_->T_map_track * T_track_base;
    pose.T_map_odom = pose.T_map_base * pose.T_odom_base.inverse();
    pose.covariance = last_->place.covariance;
  }
  if (behind_.waits) {
    has_placed_.wait(lock, [this] { return failure_ || work_.size() < behind_.max_scans; });
  }
  while (work_.size() >= behind_.max_scans) leave_out_oldest();
  work.said = std::exchange(said_, std::nullopt);
  work_.push_back(std::move(work));
  has_work_.notify_one();
  return pose;
}

/// With the lock held. What the scan that goes said beside its walls, the next one says: that
/// tracking began anew with it, or where the robot is, which has moved since.
void LiveLocalizer::Parts::leave_out_oldest() {
  const Work oldest = std::move(work_.front());
  work_.pop_front();
  ++num_left_out_;
  if (work_.empty()) return;
  Work& next = work_.front();
  if (!next.said && oldest.said && next.run == oldest.run) {
    next.said = *oldest.said * (oldest.T_track_base().inverse() * next.T_track_base());
  }
  if (oldest.tracked.is_restart && !oldest.tracked.has_odometry) {
    next.tracked.is_restart = true;
    next.tracked.has_odometry = false;
  }
}

void LiveLocalizer::Parts::finish() {
  std::unique_lock lock(mutex_);
  has_placed_.wait(lock, [this] { return failure_ || (work_.empty() && !is_at_work_); });
  if (failure_) std::rethrow_exception(failure_);
}

// --- The other thread: the place in the map ------------------------------------------------------

void LiveLocalizer::Parts::place_until_end() {
  constexpr int kNiceness = 10;
  stand_back(kNiceness);
  std::unique_lock lock(mutex_);
  try {
    for (;;) {
      has_work_.wait(lock, [this] { return is_ending_ || !work_.empty(); });
      if (is_ending_) return;
      const Work work = std::move(work_.front());
      work_.pop_front();
      is_at_work_ = true;
      lock.unlock();
      const Known known = placed(work);
      if (on_place_) on_place_(known.place);
      lock.lock();
      last_ = known;
      is_at_work_ = false;
      has_placed_.notify_all();
    }
  } catch (...) {
    if (!lock.owns_lock()) lock.lock();
    failure_ = std::current_exception();
    has_placed_.notify_all();
  }
}

LiveLocalizer::Parts::Known LiveLocalizer::Parts::placed(const Work& work) {
  if (work.said) hypotheses_.set_pose(*work.said);
  const LocalisedPose place = hypotheses_.add(work.tracked, work.scan);
  return {place, place.T_map_sensor * work.tracked.T_odom_sensor.inverse(), work.run};
}

// -------------------------------------------------------------------------------------------------

LiveLocalizer::LiveLocalizer(std::shared_ptr<const KnownMap> map,
                             const LocalisationParams& params,
                             OnPlace on_place,
                             const Behind& behind)
    : parts_(std::make_unique<Parts>(std::move(map), params, std::move(on_place), behind)) {}
LiveLocalizer::LiveLocalizer(std::shared_ptr<const KnownMap> map,
                             const LocalisationParams& params,
                             OnPlace on_place)
    : LiveLocalizer(std::move(map), params, std::move(on_place), Behind{}) {}
LiveLocalizer::~LiveLocalizer() = default;

LivePose LiveLocalizer::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  return parts_->add(scan, T_wheels_base);
}
void LiveLocalizer::finish() { parts_->finish(); }
void LiveLocalizer::set_pose(const Pose2& T_map_base) { parts_->set_pose(T_map_base); }
std::size_t LiveLocalizer::num_behind() const { return parts_->num_behind(); }
std::size_t LiveLocalizer::num_left_out() const { return parts_->num_left_out(); }
std::optional<LocalisedPose> LiveLocalizer::last_place() const { return parts_->last_place(); }

}  // namespace setsquare
