// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <tuple>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/loops/candidates.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::closure_candidates_test {

using testing::uniform;

/// Stations on a random walk, with some closures.
struct Walk {
  std::vector<Eigen::Vector2d> positions_m;
  std::vector<double> ways_m;
  std::vector<std::pair<std::size_t, std::size_t>> links;
};

Walk random_walk(std::size_t num_stations, std::mt19937_64& generator) {
  Walk walk;
  double heading_rad = 0.0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < num_stations; ++k) {
    heading_rad += uniform(generator, -0.9, 0.9);
    const double way_m = uniform(generator, 0.8, 1.6);
    position_m += way_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
    walk.positions_m.push_back(position_m);
    walk.ways_m.push_back(way_m);
  }
  for (int k = 0; k < 6; ++k) {
    const auto draw = [&] { return static_cast<std::size_t>(generator() % num_stations); };
    const auto [a, b] = std::pair(draw(), draw());
    if (a != b) walk.links.emplace_back(a, b);
  }
  return walk;
}

ClosureCandidates candidates_on(const Walk& walk, const ClosureCandidateParams& params) {
  ClosureCandidates candidates(params);
  for (const double way_m : walk.ways_m) candidates.add_station(way_m);
  for (const auto& [a, b] : walk.links) candidates.link(a, b);
  return candidates;
}

/// Shortest ways of all pairs over stations up to `last` (Floyd and Warshall).
std::vector<std::vector<double>> shortest_ways(const Walk& walk,
                                               std::size_t last,
                                               double closure_way_m) {
  const std::size_t n = last + 1;
  std::vector<std::vector<double>> way_m(
      n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t k = 0; k < n; ++k) way_m[k][k] = 0.0;
  for (std::size_t k = 1; k < n; ++k) way_m[k - 1][k] = way_m[k][k - 1] = walk.ways_m[k];
  for (const auto& [a, b] : walk.links) {
    if (std::max(a, b) > last) continue;
    way_m[a][b] = way_m[b][a] = std::min(way_m[a][b], closure_way_m);
  }
  for (std::size_t via = 0; via < n; ++via) {
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        way_m[a][b] = std::min(way_m[a][b], way_m[a][via] + way_m[via][b]);
      }
    }
  }
  return way_m;
}

/// Candidates of one station by looking at all others.
std::vector<ClosureCandidate> plain_candidates(const Walk& walk,
                                               std::size_t current,
                                               const ClosureCandidateParams& params) {
  const auto way_m = shortest_ways(walk, current, params.closure_way_m);
  std::vector<std::tuple<double, std::size_t, double>> near;
  double along_m = 0.0;
  for (std::size_t reference = current; reference-- > 0;) {
    along_m += walk.ways_m[reference + 1];
    if (along_m < params.min_way_m) continue;
    const double window_m = std::min(
        params.max_window_m, params.window_m + params.window_per_metre * way_m[reference][current]);
    const double distance_m = (walk.positions_m[current] - walk.positions_m[reference]).norm();
    if (distance_m > params.radius_m + window_m) continue;
    near.emplace_back(distance_m + window_m, reference, window_m);
  }
  std::sort(near.begin(), near.end());
  std::vector<ClosureCandidate> found;
  for (const auto& [cost_m, reference, window_m] : near) {
    if (found.size() == params.max_num) break;
    bool is_apart = true;
    for (const ClosureCandidate& other : found) {
      const std::size_t gap =
          std::max(other.reference, reference) - std::min(other.reference, reference);
      is_apart = is_apart && gap >= params.min_separation;
    }
    if (is_apart) found.push_back({reference, current, window_m});
  }
  return found;
}

TEST(ClosureCandidates, AreThoseOfThePlainTwin) {
  std::mt19937_64 generator = testing::make_generator();
  std::size_t num_found = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const Walk walk = random_walk(120, generator);
    const ClosureCandidateParams params{.window_per_metre = 0.05, .max_window_m = 3.0};
    const auto found = candidates_on(walk, params).find(90, walk.positions_m);
    std::vector<ClosureCandidate> expected;
    for (std::size_t current = 90; current < 120; ++current) {
      const auto more = plain_candidates(walk, current, params);
      expected.insert(expected.end(), more.begin(), more.end());
    }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].reference, expected[i].reference);
      EXPECT_EQ(found[i].current, expected[i].current);
      EXPECT_NEAR(found[i].window_m, expected[i].window_m, 1e-9);
    }
    num_found += found.size();
  }
  EXPECT_GT(num_found, 20U);
}

TEST(ClosureCandidates, AreTheSameWhetherAskedAtOnceOrInParts) {
  std::mt19937_64 generator = testing::make_generator();
  const Walk walk = random_walk(150, generator);
  const ClosureCandidates candidates = candidates_on(walk, {});
  const auto all = candidates.find(100, walk.positions_m);
  const auto latter = candidates.find(120, walk.positions_m);
  ASSERT_LE(latter.size(), all.size());
  for (std::size_t i = 0; i < latter.size(); ++i) {
    const ClosureCandidate& same = all[all.size() - latter.size() + i];
    EXPECT_EQ(latter[i].reference, same.reference);
    EXPECT_EQ(latter[i].current, same.current);
    EXPECT_EQ(latter[i].window_m, same.window_m);
  }
}

TEST(ClosureCandidates, AClosureNarrowsTheWindowsBehindIt) {
  // There and back on a parallel line, 60 m each way.
  const auto window_at_the_start = [](bool is_linked) {
    ClosureCandidates candidates({});
    std::vector<Eigen::Vector2d> positions_m;
    for (int k = 0; k < 61; ++k) positions_m.emplace_back(k, 0.0);
    for (int k = 60; k >= 0; --k) positions_m.emplace_back(k, 1.0);
    for (std::size_t k = 0; k < positions_m.size(); ++k) candidates.add_station(1.0);
    if (is_linked) candidates.link(10, 111);
    const auto found = candidates.find(121, positions_m);
    return found.empty() ? -1.0 : found.front().window_m;
  };
  const ClosureCandidateParams params;
  EXPECT_NEAR(window_at_the_start(false), params.window_m + params.window_per_metre * 121.0, 1e-9);
  EXPECT_NEAR(window_at_the_start(true), params.window_m + params.window_per_metre * 21.0, 1e-9);
}

TEST(ClosureCandidates, AWayBackOfAnyLengthHasTheWidestWindow) {
  const ClosureCandidateParams params;
  ClosureCandidates candidates(params);
  candidates.add_station(0.0);
  candidates.add_station(1e4);
  const auto found = candidates.find(1, std::vector<Eigen::Vector2d>(2, {0.0, 0.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().window_m, params.max_window_m);
}

TEST(ClosureCandidates, PiecesAreComparedOnceALinkJoinsThem) {
  ClosureCandidates candidates({});
  const std::vector<Eigen::Vector2d> positions_m(40, {0.0, 0.0});
  for (std::size_t k = 0; k < 40; ++k) candidates.add_station(1.0, k / 20);
  for (const ClosureCandidate& candidate : candidates.find(20, positions_m)) {
    EXPECT_GE(candidate.reference, 20U);
  }
  candidates.link(5, 25);
  std::size_t num_across = 0;
  for (const ClosureCandidate& candidate : candidates.find(20, positions_m)) {
    num_across += candidate.reference < 20 ? 1 : 0;
  }
  EXPECT_GT(num_across, 10U);
}

/// The time that a station costs at the end of a track that goes to and fro, 40 m per lane, in s.
double time_per_station_s(std::size_t num_stations) {
  constexpr std::size_t kLane = 40;
  ClosureCandidates candidates({});
  std::vector<Eigen::Vector2d> positions_m;
  for (std::size_t k = 0; k < num_stations; ++k) {
    const std::size_t lane = k / kLane;
    const std::size_t along = lane % 2 == 0 ? k % kLane : kLane - 1 - k % kLane;
    positions_m.emplace_back(static_cast<double>(along), 2.0 * static_cast<double>(lane));
    candidates.add_station(1.0);
  }
  for (std::size_t lane = 1; lane * kLane + kLane <= num_stations; ++lane) {
    candidates.link(lane * kLane - 10, lane * kLane + 9);
  }
  constexpr std::size_t kNumAsked = 400;
  double best_s = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < 5; ++trial) {
    const auto start = std::chrono::steady_clock::now();
    const auto found = candidates.find(num_stations - kNumAsked, positions_m);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_FALSE(found.empty());
    best_s = std::min(best_s, taken.count() / kNumAsked);
  }
  return best_s;
}

TEST(ClosureCandidates, AStationCostsTheSameInALargeMap) {
  // If all stations were looked at, four times the map would take four times the time.
  EXPECT_LT(time_per_station_s(8000), 2.5 * time_per_station_s(2000));
}

TEST(ClosureCandidates, RefuseParametersThatAreNone) {
  EXPECT_THROW(ClosureCandidateParams{.radius_m = 0.0}.validate(), ParameterError);
  EXPECT_THROW(ClosureCandidateParams{.window_per_metre = 0.0}.validate(), ParameterError);
  EXPECT_THROW((ClosureCandidateParams{.window_m = 1.0, .max_window_m = 0.5}.validate()),
               ParameterError);
}

}  // namespace setsquare::closure_candidates_test
