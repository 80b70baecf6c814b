// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs of key frames: a scan every metre or every 30 degrees, and no odometry. The last motion says
// next to nothing of the next one, and along a corridor the walls fit anywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "setsquare/tracking/scan_tracker.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::key_frame_log_test {

using testing::between;
using testing::scans_on_drive;
using testing::Wall;

constexpr double kNoise_m = 0.01;
constexpr double kWrong_m = 0.3;
constexpr double kWrong_rad = rad_from_deg(5.0);
constexpr std::uint64_t kNumSeeds = 20;

/// A corridor 2 m wide with offices on both sides: doors of 0.9 m, 3 to 6 m apart.
std::vector<Wall> corridor_with_offices(double length_m, std::mt19937_64& random) {
  std::uniform_real_distribution<double> apart_m(3.0, 6.0);
  std::uniform_real_distribution<double> deep_m(2.5, 5.0);
  std::vector<Wall> walls{{-1.0, -1.0, -1.0, 1.0}, {length_m, -1.0, length_m, 1.0}};
  for (const double side : {-1.0, 1.0}) {
    double x_m = -1.0;
    for (double door_m = apart_m(random); door_m + 2.0 < length_m; door_m += apart_m(random)) {
      walls.push_back({x_m, side, door_m, side});
      x_m = door_m + 0.9;
      const double back_m = side * (1.0 + deep_m(random));
      walls.push_back({door_m - 1.0, side, door_m - 1.0, back_m});
      walls.push_back({door_m - 1.0, back_m, door_m + 1.5, back_m});
      walls.push_back({door_m + 1.5, back_m, door_m + 1.5, side});
    }
    walls.push_back({x_m, side, length_m, side});
  }
  return walls;
}

/// There, a turn on the spot, and back: a scan about every metre, and every 25 to 35 degrees.
std::vector<Pose2> key_frames(double length_m, std::mt19937_64& random) {
  std::uniform_real_distribution<double> step_m(0.8, 1.2);
  std::uniform_real_distribution<double> turn_rad(rad_from_deg(25.0), rad_from_deg(35.0));
  std::uniform_real_distribution<double> off(-1.0, 1.0);
  std::vector<Pose2> poses;
  const auto add = [&](double x_m, double heading_rad) {
    poses.push_back({x_m, 0.2 * off(random), wrap_to_pi(heading_rad + 0.1 * off(random))});
  };
  double x_m = 0.5;
  for (; x_m < length_m - 1.5; x_m += step_m(random)) add(x_m, 0.0);
  for (double heading_rad = 0.0; heading_rad < kPi; heading_rad += turn_rad(random)) {
    add(x_m, heading_rad);
  }
  for (; x_m > 0.5; x_m -= step_m(random)) add(x_m, kPi);
  return poses;
}

/// What tracking made of the steps from scan to scan.
struct Steps {
  std::size_t num_right = 0;
  std::size_t num_wrong = 0;     ///< And not told.
  std::size_t num_reported = 0;  ///< Lost, or along a corridor by nobody knows how far.

  void add(const Steps& other) {
    num_right += other.num_right;
    num_wrong += other.num_wrong;
    num_reported += other.num_reported;
  }
};

/// A drive, and its scans.
struct Log {
  std::vector<Pose2> truth;
  std::vector<Scan> scans;
};

/// `sight_m`: nothing is seen beyond it.
Log key_frame_log(std::uint64_t seed, double sight_m = 30.0) {
  std::mt19937_64 random(seed);
  constexpr double kLength_m = 30.0;
  const std::vector<Wall> walls = corridor_with_offices(kLength_m, random);
  Log log{.truth = key_frames(kLength_m, random), .scans = {}};
  log.scans = scans_on_drive(walls, log.truth, kNoise_m);
  for (Scan& scan : log.scans) {
    scan.stamp.ns *= 20;  // At 0.5 m/s.
    for (double& range_m : scan.ranges_m) {
      if (range_m > sight_m) range_m = std::numeric_limits<double>::infinity();
    }
  }
  return log;
}

/// What wheels tell that err by 2 % of each way and turn.
std::vector<Pose2> wheels_on(const std::vector<Pose2>& truth, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> share(1.0, 0.02);
  std::vector<Pose2> wheels{Pose2{}};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Pose2 step = between(truth[i - 1], truth[i]);
    const double way = share(random);
    wheels.push_back(wheels.back() *
                     Pose2{way * step.x_m, way * step.y_m, share(random) * step.theta_rad});
  }
  return wheels;
}

Steps track_log(const Log& log,
                const ScanTrackerParams& params,
                const std::vector<Pose2>& wheels = {}) {
  const auto& [truth, scans] = log;
  const auto wheels_at = [&](std::size_t i) {
    return wheels.empty() ? std::nullopt : std::optional(wheels[i]);
  };
  ScanTracker tracker(params);
  Steps steps;
  Pose2 T_odom_last = tracker.track(scans[0], wheels_at(0)).T_odom_sensor;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const TrackedPose tracked = tracker.track(scans[i], wheels_at(i));
    const Pose2 off =
        between(between(truth[i - 1], truth[i]), between(T_odom_last, tracked.T_odom_sensor));
    T_odom_last = tracked.T_odom_sensor;
    if (tracked.status == TrackStatus::kLost || tracked.open_sigma_m > 0.0) {
      ++steps.num_reported;
    } else if (std::hypot(off.x_m, off.y_m) > kWrong_m || std::abs(off.theta_rad) > kWrong_rad) {
      ++steps.num_wrong;
    } else {
      ++steps.num_right;
    }
  }
  return steps;
}

Steps track_all_seeds(const ScanTrackerParams& params) {
  Steps sum;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    sum.add(track_log(key_frame_log(seed), params));
  }
  return sum;
}

TEST(KeyFrameLog, IsTrackedByWhatKeyframesAgreeUpon) {
  const Steps steps = track_all_seeds({});
  RecordProperty("right", static_cast<int>(steps.num_right));
  RecordProperty("wrong", static_cast<int>(steps.num_wrong));
  RecordProperty("reported", static_cast<int>(steps.num_reported));
  const std::size_t num_steps = steps.num_right + steps.num_wrong + steps.num_reported;
  // Two are known: a dead end where a quarter turn looks like the step.
  EXPECT_LE(steps.num_wrong, 3U) << "of " << num_steps;
  EXPECT_GE(100 * steps.num_right, 97 * num_steps) << steps.num_reported << " reported";
}

/// The rule switched off: steps are never taken for long ones.
TEST(KeyFrameLog, IsTrackedWronglyByRefinementAlone) {
  ScanTrackerParams params;
  params.long_steps.num_steps = 1;
  params.long_steps.min_long = 2;
  EXPECT_GT(track_all_seeds(params).num_wrong, 20U);
}

// A scanner that sees 4 m, in corridors: places look alike, and the wheels know where the robot is.
// Before odometry has proved, two keyframes that agree upon a wrong place outvote it.
Steps steps_of_short_sight(const ScanTrackerParams& params) {
  Steps sum;
  for (std::uint64_t seed = 101; seed <= 106; ++seed) {
    const Log log = key_frame_log(seed, 4.0);
    sum.add(track_log(log, params, wheels_on(log.truth, seed)));
  }
  return sum;
}

TEST(KeyFrameLog, OdometrySpeaksAgainstPlacesThatLookAlike) {
  ScanTrackerParams params;
  const Steps steps = steps_of_short_sight(params);
  params.votes.min_votes_for_jump = 0.0;   // Any place that keyframes agree upon ...
  params.odometry.proved_deviation = 0.0;  // ... is believed, for nothing ever proves.
  const Steps without = steps_of_short_sight(params);
  RecordProperty("wrong", static_cast<int>(steps.num_wrong));
  RecordProperty("without", static_cast<int>(without.num_wrong));
  EXPECT_LE(100 * steps.num_wrong, 5 * (steps.num_right + steps.num_wrong + steps.num_reported));
  EXPECT_GT(without.num_wrong, 2 * steps.num_wrong);
}

// The wheels show no motion at all between two key frames that see different places: they hung, or
// the robot was carried. The log goes on with a new piece.
TEST(KeyFrameLog, WheelsThatStandStillBridgeNothing) {
  std::size_t num_bridged = 0;
  std::size_t num_apart = 0;
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    Log log = key_frame_log(seed);
    std::vector<Pose2> wheels = wheels_on(log.truth, seed);
    // Carried over 12 m.
    const auto cut = [](auto& all) { all.erase(all.begin() + 8, all.begin() + 20); };
    cut(log.scans);
    cut(wheels);
    wheels[8] = wheels[7];
    ScanTracker tracker;
    for (std::size_t i = 0; i <= 8; ++i) {
      const TrackedPose tracked = tracker.track(log.scans[i], wheels[i]);
      if (i < 8) continue;
      num_bridged += tracked.is_restart && tracked.has_odometry;
      num_apart += tracked.is_restart && !tracked.has_odometry;
    }
  }
  EXPECT_EQ(num_bridged, 0U);
  EXPECT_GT(num_apart, kNumSeeds / 2);
}

}  // namespace setsquare::key_frame_log_test
