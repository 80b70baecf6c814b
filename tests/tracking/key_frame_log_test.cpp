// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs of key frames: a scan every metre or every 30 degrees, and no odometry. The last motion says
// next to nothing of the next one, and along a corridor the walls fit anywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
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
};

Steps track_key_frames(std::uint64_t seed, const ScanTrackerParams& params) {
  std::mt19937_64 random(seed);
  constexpr double kLength_m = 30.0;
  const std::vector<Wall> walls = corridor_with_offices(kLength_m, random);
  const std::vector<Pose2> truth = key_frames(kLength_m, random);
  const std::vector<Scan> scans = scans_on_drive(walls, truth, kNoise_m);
  ScanTracker tracker(params);
  Steps steps;
  Pose2 T_odom_last = tracker.track(scans[0], std::nullopt).T_odom_sensor;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const TrackedPose tracked = tracker.track(scans[i], std::nullopt);
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
    const Steps steps = track_key_frames(seed, params);
    sum.num_right += steps.num_right;
    sum.num_wrong += steps.num_wrong;
    sum.num_reported += steps.num_reported;
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

}  // namespace setsquare::key_frame_log_test
