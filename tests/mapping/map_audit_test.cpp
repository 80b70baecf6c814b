// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Simulated buildings, with the true trajectory and with one that was bent on purpose.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/mapping/audit/doubts.hpp"
#include "setsquare/mapping/audit/trajectory_audit.hpp"
#include "tests/mapping/driven_building.hpp"

namespace setsquare::map_audit_test {

/// A scan half-way between two that saw the same place, 20 s apart: what no two scans span, none
/// can tell. Nothing where the robot never came back so.
std::optional<std::size_t> scan_before_a_revisit(const std::vector<Pose2>& poses) {
  constexpr std::size_t kApart = 40;
  std::optional<std::size_t> found;
  double nearest_m = 1.0;
  for (std::size_t i = 0; i + kApart < poses.size(); ++i) {
    for (std::size_t j = i + kApart; j < poses.size(); ++j) {
      const Pose2 between = poses[i].inverse() * poses[j];
      const double apart_m = between.translation().norm();
      if (apart_m >= nearest_m || std::abs(between.theta_rad) > rad_from_deg(30.0)) continue;
      nearest_m = apart_m;
      found = (i + j) / 2;
    }
  }
  return found;
}

/// Everything from the scan on turned and moved about where it was taken.
std::vector<Pose2> bent_at(std::vector<Pose2> poses, std::size_t scan, const Pose2& T_scan_bent) {
  const Pose2 T_map_bent = poses[scan] * T_scan_bent * poses[scan].inverse();
  for (std::size_t i = scan; i < poses.size(); ++i) poses[i] = T_map_bent * poses[i];
  return poses;
}

Map audited(const DrivenBuilding& drive,
            const std::vector<Pose2>& T_map_sensor,
            const AuditParams& params = {},
            std::size_t num_threads = 2) {
  TrajectoryAudit audit(params);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const Scan& scan = drive.scans[i];
    audit.add(scan,
              {.stamp = scan.stamp,
               .T_map_sensor = T_map_sensor[i],
               .T_map_base = T_map_sensor[i] * scan.T_base_sensor.inverse()});
  }
  return audit.finish({}, {}, num_threads);
}

constexpr BuildingClass kClasses[] = {
    BuildingClass::kOffice, BuildingClass::kWings, BuildingClass::kCorridor};

TEST(MapAudit, TheTrueTrajectoryIsNotDoubted) {
  for (const BuildingClass building_class : kClasses) {
    const DrivenBuilding drive = driven_building(building_class, 2011);
    const Map map = audited(drive, drive.T_map_sensor);
    ASSERT_TRUE(map.audit);
    EXPECT_GT(map.audit->num_agreeing, 40U);
    EXPECT_EQ(map.audit->num_seconded, 0U);
    EXPECT_TRUE(map.doubts.empty()) << map.doubts.front().reason;
    EXPECT_EQ(map.audit->num_agreeing + map.audit->num_contradicting, map.audit->num_matched);
    EXPECT_LE(map.audit->num_matched, map.audit->num_pairs);
  }
}

/// Every few metres another error: no two matches ask for the same correction.
TEST(MapAudit, WhereMostMatchesContradictTheMapAllOfItIsInDoubt) {
  const DrivenBuilding drive = driven_building(BuildingClass::kOffice, 2012);
  std::vector<Pose2> poses = drive.T_map_sensor;
  Random random(7);
  for (std::size_t scan = 4; scan < poses.size(); scan += 4) {
    poses = bent_at(poses, scan, {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0});
  }
  const Map map = audited(drive, poses);
  EXPECT_LE(map.audit->num_agreeing, map.audit->num_contradicting);
  EXPECT_TRUE(std::ranges::any_of(map.doubts, [&](const MapDoubt& doubt) {
    return doubt.kind == DoubtKind::kContradictingPairs && doubt.num_scans == map.scans.size();
  }));
}

bool has_crossed_walls(const Map& map) {
  return std::ranges::any_of(
      map.doubts, [](const MapDoubt& doubt) { return doubt.kind == DoubtKind::kCrossedWalls; });
}

/// Two floors joined by a lift: each is right, and no match need contradict the map.
TEST(MapAudit, TwoFloorsOverEachOtherAreTold) {
  for (const std::uint64_t seed : {2014U, 2015U, 2016U}) {
    DrivenBuilding floors = driven_building(BuildingClass::kOffice, seed);
    const DrivenBuilding above = driven_building(BuildingClass::kOffice, seed + 10);
    const std::size_t num_below = floors.scans.size();
    const std::int64_t later_ns = floors.scans.back().stamp.ns + 1'000'000'000;
    for (Scan scan : above.scans) {
      scan.stamp.ns += later_ns;
      floors.scans.push_back(scan);
    }
    const Pose2 T_map_above =
        floors.T_map_sensor[num_below / 2] * above.T_map_sensor[above.scans.size() / 2].inverse();
    for (const Pose2& pose : above.T_map_sensor) floors.T_map_sensor.push_back(T_map_above * pose);
    const Map map = audited(floors, floors.T_map_sensor);
    EXPECT_TRUE(has_crossed_walls(map));
    for (const MapDoubt& doubt : map.doubts) {
      EXPECT_TRUE(doubt.kind != DoubtKind::kCrossedWalls || doubt.first_scan >= num_below);
    }
    AuditParams without_the_rule;
    without_the_rule.min_crossed_m = 1e9;
    EXPECT_FALSE(has_crossed_walls(audited(floors, floors.T_map_sensor, without_the_rule)));
  }
}

TEST(MapAudit, ABentTrajectoryIsDoubtedBehindTheBend) {
  for (const BuildingClass building_class : kClasses) {
    const DrivenBuilding drive = driven_building(building_class, 2012);
    const auto before_revisit = scan_before_a_revisit(drive.T_map_sensor);
    ASSERT_TRUE(before_revisit);
    const std::size_t bend = *before_revisit;
    for (const Pose2 T_scan_bent : {Pose2{0.0, 0.0, rad_from_deg(12.0)}, Pose2{0.7, 0.5, 0.0}}) {
      SCOPED_TRACE(static_cast<int>(building_class));
      const Map map = audited(drive, bent_at(drive.T_map_sensor, bend, T_scan_bent));
      ASSERT_FALSE(map.doubts.empty());
      for (const MapDoubt& doubt : map.doubts) {
        EXPECT_TRUE(doubt.kind == DoubtKind::kContradictingPairs ||
                    doubt.kind == DoubtKind::kCrossedWalls);
        EXPECT_GE(doubt.first_scan, bend) << doubt.reason;
        const std::size_t last = doubt.first_scan + doubt.num_scans - 1;
        ASSERT_LT(last, map.scans.size());
        EXPECT_EQ(doubt.first_stamp.ns, map.scans[doubt.first_scan].stamp.ns);
        EXPECT_EQ(doubt.last_stamp.ns, map.scans[last].stamp.ns);
      }
      EXPECT_GE(map.audit->num_seconded, AuditParams{}.min_seconded);
    }
  }
}

TEST(MapAudit, WithoutSecondsNothingIsDoubted) {
  const DrivenBuilding drive = driven_building(BuildingClass::kOffice, 2012);
  const auto bent =
      bent_at(drive.T_map_sensor, drive.scans.size() / 2, {0.0, 0.0, rad_from_deg(12.0)});
  AuditParams params;
  params.min_seconded = 1000;
  for (const MapDoubt& doubt : audited(drive, bent, params).doubts) {
    EXPECT_EQ(doubt.kind, DoubtKind::kCrossedWalls);
  }
  params.min_crossed_m = 1e9;
  EXPECT_TRUE(audited(drive, bent, params).doubts.empty());
}

TEST(MapAudit, AnyNumberOfThreadsSaysTheSame) {
  const DrivenBuilding drive = driven_building(BuildingClass::kOffice, 2013);
  const auto bent = bent_at(drive.T_map_sensor, drive.scans.size() / 3, {0.6, 0.0, 0.1});
  const Map one = audited(drive, bent, {}, 1);
  const Map three = audited(drive, bent, {}, 3);
  EXPECT_EQ(one.audit->num_matched, three.audit->num_matched);
  EXPECT_EQ(one.audit->num_seconded, three.audit->num_seconded);
  ASSERT_EQ(one.doubts.size(), three.doubts.size());
  for (std::size_t i = 0; i < one.doubts.size(); ++i) {
    EXPECT_EQ(one.doubts[i].reason, three.doubts[i].reason);
  }
}

TEST(MapAudit, AMapOfOneScanOrNoneIsNotDoubted) {
  EXPECT_EQ(TrajectoryAudit().finish({}, {}, 1).audit->num_pairs, 0U);
  TrajectoryAudit audit;
  audit.add(driven_building(BuildingClass::kHall, 2011).scans.front(), {});
  const Map map = audit.finish({}, {}, 1);
  EXPECT_EQ(map.audit->num_pairs, 0U);
  EXPECT_TRUE(map.doubts.empty());
}

/// A straight track of scans 0.5 m apart, each a keyframe.
Map straight_map(std::size_t num_scans) {
  Map map;
  for (std::size_t i = 0; i < num_scans; ++i) {
    const Pose2 pose{0.5 * static_cast<double>(i), 0.0, 0.0};
    map.scans.push_back({.stamp = {}, .T_map_sensor = pose, .T_map_base = pose});
    map.scans.back().stamp.ns = static_cast<std::int64_t>(i);
    map.keyframes.push_back(i);
  }
  map.pieces = {{0, num_scans, true}};
  return map;
}

std::vector<MapDoubt> doubts_without_matches(const Map& map) {
  AuditFindings findings;
  findings.track = audited_track(map);
  return doubts_of(map, findings, {});
}

/// For the kind of log whose driver sends each scan several times: most of its scans are lost, and
/// nothing is lost of its way.
TEST(AuditedTrack, RepeatsOfAScanAreNoLosses) {
  Map map = straight_map(100);
  for (const std::size_t lost : {20U, 50U}) map.scans[lost].status = TrackStatus::kLost;
  EXPECT_EQ(audited_track(map).losses.size(), 2U) << "of a trajectory";
  map.track.motions.resize(map.keyframes.size());
  map.track.motions[21].covariance.slip_sigma_m = 0.3;  // The other one repeats a scan.
  EXPECT_EQ(audited_track(map).losses, std::vector<std::size_t>{20}) << "without the lost scans";
}

TEST(MapDoubts, PiecesThatWereNotJoinedAreOneDoubtEachRow) {
  Map map = straight_map(100);
  map.pieces = {{0, 40, true}, {40, 10, false}, {50, 10, false}, {60, 40, true}};
  for (std::size_t i = 40; i < 60; ++i) map.scans[i].is_placed = false;
  const auto doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].kind, DoubtKind::kUnjoinedPiece);
  EXPECT_EQ(doubts[0].first_scan, 40U);
  EXPECT_EQ(doubts[0].num_scans, 20U);
  EXPECT_DOUBLE_EQ(doubts[0].place_m.x(), 19.5) << "where the track was last in the map";
}

OpenStretch stretch_of(std::size_t first, std::size_t num, double sigma_m) {
  return {.first_scan = first, .num_scans = num, .way_m = 5.0, .length_sigma_m = sigma_m};
}

TEST(MapDoubts, AStretchOfUnknownLengthIsDoubtedUnlessMatchesMeasureIt) {
  Map map = straight_map(100);
  map.open_stretches = {stretch_of(40, 10, 0.1)};
  EXPECT_TRUE(doubts_without_matches(map).empty()) << "known to 0.1 m";
  map.open_stretches = {stretch_of(40, 10, 2.0)};
  auto doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].kind, DoubtKind::kUnknownLength);
  EXPECT_EQ(doubts[0].first_scan, 40U);
  map.odometry.verdict = OdometryVerdict::kStill;
  EXPECT_EQ(doubts_without_matches(map)[0].kind, DoubtKind::kRefusedOdometry);

  AuditFindings findings;
  findings.track = audited_track(map);
  const auto agreeing = [&](std::size_t from, std::size_t to) {
    const auto& poses = findings.track.T_map_sensor;
    return AuditMatch{{from, to}, poses[from].inverse() * poses[to], Eigen::Matrix3d::Identity()};
  };
  findings.matches = {agreeing(30, 60), agreeing(30, 35)};
  EXPECT_EQ(doubts_of(map, findings, {}).size(), 1U) << "one pair across it is not enough";
  findings.matches.push_back(agreeing(32, 62));
  EXPECT_TRUE(doubts_of(map, findings, {}).empty());
  map.open_stretches.push_back(stretch_of(52, 5, 2.0));
  EXPECT_EQ(doubts_of(map, findings, {}).size(), 2U) << "which of two it was, nobody knows";
}

TEST(MapAudit, AMendedMapMustExplainMoreOfAllMatches) {
  const AuditReport before{.num_pairs = 300,
                           .num_matched = 100,
                           .num_agreeing = 80,
                           .num_contradicting = 20,
                           .num_seconded = 15};
  AuditReport mended{.num_pairs = 300,
                     .num_matched = 90,
                     .num_agreeing = 88,
                     .num_contradicting = 2,
                     .num_seconded = 0};
  EXPECT_TRUE(explains_more(mended, before));
  EXPECT_FALSE(explains_more(before, before));
  EXPECT_FALSE(explains_more(before, mended));
  mended.num_agreeing = 72;  // The same share.
  EXPECT_FALSE(explains_more(mended, before)) << "fewer contradict, but no more agree";
}

TEST(MapDoubts, AMapThatMayBeMirroredIsDoubtedAsAWhole) {
  Map map = straight_map(100);
  map.odometry.verdict = OdometryVerdict::kBelieved;
  EXPECT_TRUE(doubts_without_matches(map).empty());
  map.odometry.verdict = OdometryVerdict::kMirrored;
  auto doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].kind, DoubtKind::kMirrored);
  EXPECT_EQ(doubts[0].num_scans, 100U);
  map.odometry.verdict = OdometryVerdict::kBelieved;
  map.gyro.verdict = GyroVerdict::kDegrees;
  map.gyro.scale = 0.017;
  EXPECT_TRUE(doubts_without_matches(map).empty());
  map.gyro.scale = -0.017;
  doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].kind, DoubtKind::kMirrored);
}

TEST(MapDoubts, WallsThatTurnedAreOneWhereNoMatchTellsWhy) {
  Map map = straight_map(100);
  map.undecided_turns = {{40, 44, rad_from_deg(-9.0)}, {60, 61, rad_from_deg(2.0)}};
  const auto doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U) << "2 deg are too little to tell";
  EXPECT_EQ(doubts[0].kind, DoubtKind::kUndecidedTurn);
  EXPECT_EQ(doubts[0].first_scan, 40U);
  EXPECT_EQ(doubts[0].num_scans, 60U) << "what follows hangs on it";
  AuditFindings findings;
  findings.track = audited_track(map);
  const auto& poses = findings.track.T_map_sensor;
  findings.matches = {{{30, 70}, poses[30].inverse() * poses[70], Eigen::Matrix3d::Identity()}};
  EXPECT_EQ(doubts_of(map, findings, {})[0].num_scans, 30U) << "to where a match ties it";
  findings.matches = {{{42, 70}, poses[42].inverse() * poses[70], Eigen::Matrix3d::Identity()}};
  EXPECT_EQ(doubts_of(map, findings, {})[0].num_scans, 60U) << "one from behind it ties nothing";
  map.scans[44].is_placed = false;
  EXPECT_TRUE(doubts_without_matches(map).empty()) << "not in the map";
}

TEST(MapDoubts, AStandingRobotAtTheEndIsNoDoubt) {
  Map map = straight_map(100);
  map.open_stretches = {stretch_of(95, 5, 2.0)};
  EXPECT_EQ(doubts_without_matches(map).size(), 1U);
  map.open_stretches[0].way_m = 0.2;
  EXPECT_TRUE(doubts_without_matches(map).empty());
}

MappedClosure closure_of(std::size_t i, std::size_t j, double weight) {
  MappedClosure closure;
  closure.scan_i = i;
  closure.scan_j = j;
  closure.closure.is_accepted = true;
  closure.closure.weight = weight;
  return closure;
}

TEST(MapDoubts, OutvotedClosuresAreDoubtedWhereTheyOutnumberThoseThatHold) {
  Map map = straight_map(200);
  map.closures = {closure_of(20, 150, 0.0), closure_of(23, 153, 0.1), closure_of(90, 180, 0.0)};
  EXPECT_TRUE(doubts_without_matches(map).empty()) << "two of the same places and a third";
  map.closures.push_back(closure_of(26, 156, 0.2));
  const auto doubts = doubts_without_matches(map);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].kind, DoubtKind::kOutvotedClosures);
  EXPECT_EQ(doubts[0].first_scan, 150U);
  EXPECT_EQ(doubts[0].num_scans, 7U);
  for (const std::size_t i : {21U, 22U, 24U}) map.closures.push_back(closure_of(i, i + 130, 1.0));
  EXPECT_TRUE(doubts_without_matches(map).empty()) << "as many hold";
}

}  // namespace setsquare::map_audit_test
