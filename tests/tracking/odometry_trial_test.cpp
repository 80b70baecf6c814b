// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/odometry_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::odometry_trial_test {

using testing::make_generator;

Timestamp stamp_at(std::size_t i) { return {static_cast<std::int64_t>(i) * 100'000'000}; }

/// A drive, and what wheels make of each of its steps.
std::vector<Pose2> wheels_on(const std::vector<Pose2>& truth,
                             const std::function<Pose2(const Pose2&)>& shown) {
  std::vector<Pose2> wheels{Pose2{3.0, -2.0, 1.0}};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    wheels.push_back(wheels.back() * shown(testing::between(truth[i - 1], truth[i])));
  }
  return wheels;
}

/// Scans placed with noise of 5 mm and 0.2 degrees, all certain. Counts the steps believed.
struct Trial {
  explicit Trial(const OdometryTrialParams& params = {}) : trial(params) {}

  void run(const std::vector<Pose2>& truth, const std::vector<Pose2>& wheels) {
    auto generator = make_generator();
    std::normal_distribution<double> noise(0.0, 1.0);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto believed = trial.believed(wheels[i], stamp_at(i));
      num_believed += believed.has_value();
      last_believed = believed;
      const Pose2 off{
          0.005 * noise(generator), 0.005 * noise(generator), 0.0035 * noise(generator)};
      trial.add(wheels[i],
                {.stamp = stamp_at(i),
                 .T_odom_base = truth[i] * off,
                 .is_placed = true,
                 .is_certain = true});
    }
  }

  OdometryTrial trial;
  std::size_t num_believed = 0;
  std::optional<Pose2> last_believed;
};

std::vector<Pose2> drive_around() { return testing::drive(testing::way_around_the_room()); }

TEST(OdometryTrial, BelievesWheelsThatDriftToTheLastDigit) {
  const auto truth = drive_around();
  const auto wheels = wheels_on(truth, [](const Pose2& step) {
    return Pose2{0.97 * step.x_m, step.y_m, 1.05 * step.theta_rad};
  });
  Trial trial;
  trial.run(truth, wheels);
  EXPECT_EQ(trial.trial.report().verdict, OdometryVerdict::kBelieved);
  EXPECT_EQ(trial.num_believed, truth.size());
  EXPECT_EQ(trial.last_believed, wheels.back());
  EXPECT_NEAR(trial.trial.report().way.scale, 1.0 / 0.97, 0.02);
  EXPECT_NEAR(trial.trial.report().turn.scale, 1.0 / 1.05, 0.03);
}

TEST(OdometryTrial, TellsAndIgnoresOdometryThatIsNone) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  struct Case {
    std::function<Pose2(const Pose2&)> shown;
    OdometryVerdict verdict;
  };
  const std::vector<Case> cases = {
      {[](const Pose2&) { return Pose2{}; }, OdometryVerdict::kStill},
      {[&](const Pose2&) {
         return Pose2{1e-4 * noise(random), 1e-4 * noise(random), 0.0};
       },
       OdometryVerdict::kStill},
      {[](const Pose2& step) {
         return Pose2{step.x_m, step.y_m, 0.0};
       },
       OdometryVerdict::kStill},
      {[](const Pose2& step) {
         return Pose2{step.x_m, -step.y_m, -step.theta_rad};
       },
       OdometryVerdict::kMirrored},
      {[](const Pose2& step) {
         return Pose2{-step.x_m, -step.y_m, step.theta_rad};
       },
       OdometryVerdict::kUnlike},
      {[&](const Pose2& step) {
         return step * Pose2{0.2 * noise(random), 0.2 * noise(random), 0.2 * noise(random)};
       },
       OdometryVerdict::kUnlike}};
  const auto truth = drive_around();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Trial trial;
    trial.run(truth, wheels_on(truth, cases[i].shown));
    EXPECT_EQ(trial.trial.report().verdict, cases[i].verdict) << i;
    EXPECT_FALSE(trial.last_believed) << i;
    EXPECT_LT(trial.num_believed, truth.size() / 3) << i;
  }
}

TEST(OdometryTrial, MendsScales) {
  const auto truth = drive_around();
  for (const double way : {0.5, 2.0, 100.0, 1000.0}) {
    for (const double turn : {0.5, 1.0, 2.0}) {
      Trial trial;
      trial.run(truth, wheels_on(truth, [&](const Pose2& step) {
                  return Pose2{way * step.x_m, way * step.y_m, turn * step.theta_rad};
                }));
      const OdometryReport& report = trial.trial.report();
      EXPECT_EQ(report.verdict, OdometryVerdict::kScaled) << way << " " << turn;
      EXPECT_NEAR(report.way.scale * way, 1.0, 0.05);
      EXPECT_NEAR(report.turn.scale * turn, 1.0, 0.05);
    }
  }
}

TEST(OdometryTrial, ReachesNoFartherThanItHasErredOnceItHasProved) {
  const auto truth = drive_around();
  const auto run = [&](double error) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, error);
    Trial trial;
    trial.run(
        truth, wheels_on(truth, [&](const Pose2& step) {
          const double way = 1.0 + noise(random);
          return Pose2{way * step.x_m, way * step.y_m, (1.0 + noise(random)) * step.theta_rad};
        }));
    return trial.trial;
  };
  const Pose2 step{3.0, 0.0, 1.0};
  const auto exact = run(0.0).proved_reach(step);
  const auto fair = run(0.15).proved_reach(step);
  ASSERT_TRUE(exact);
  ASSERT_TRUE(fair);
  // Of 3 m and 1 rad: what is noise of the scans, along stretches of 0.3 m, counts, too.
  EXPECT_LT(exact->distance_m, 0.6);
  EXPECT_LT(exact->turn_rad, 0.3);
  EXPECT_GT(fair->distance_m, exact->distance_m);
  EXPECT_FALSE(run(1.0).proved_reach(step)) << "it never proved";
  EXPECT_FALSE(OdometryTrial({}).proved_reach(step));
}

}  // namespace setsquare::odometry_trial_test
