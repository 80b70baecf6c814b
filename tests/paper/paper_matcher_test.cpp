// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/paper_matcher.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::paper_matcher_test {

using testing::Fan;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;

/// A bin is 4 cm and a direction 0.1 deg: the method itself is not finer.
constexpr PoseTolerance kPaper{.translation_m = 0.06, .rotation_rad = rad_from_deg(0.6)};

const Fan kFullTurn{360, -kPi, rad_from_deg(1.0)};
const Fan kHokuyo{1081, rad_from_deg(-135.0), rad_from_deg(0.25)};
const Fan kClockwise{720, kPi, rad_from_deg(-0.5)};

/// The true relative pose of two scans of the room, and what the paper's method finds.
void expect_recovered(const Fan& fan, const Pose2& T_reference_current) {
  const Pose2 T_world_reference{2.0, 2.5, rad_from_deg(7.0)};
  const Pose2 T_world_current = T_world_reference * T_reference_current;
  const MatchResult result =
      match_paper(scan_of_walls(l_shaped_room(), T_world_reference, fan, 0.003, 1),
                  scan_of_walls(l_shaped_room(), T_world_current, fan, 0.003, 2));
  EXPECT_EQ(result.status, MatchStatus::kMatched);
  ASSERT_TRUE(result.T_reference_current.has_value());
  EXPECT_THAT(*result.T_reference_current, PoseNear(T_reference_current, kPaper));
}

TEST(PaperMatcher, RecoversScansTurnedAnyWay) {
  for (int turn_deg = 0; turn_deg < 360; turn_deg += 15) {
    SCOPED_TRACE(turn_deg);
    // Each component has its own size and sign: every sign of eq. (8) counts.
    const Pose2 T_reference_current{0.62, -0.31, wrap_to_pi(rad_from_deg(turn_deg + 2.0))};
    expect_recovered(kFullTurn, T_reference_current);
    expect_recovered(kClockwise, T_reference_current);
  }
}

TEST(PaperMatcher, RecoversNeighbouringScansOfAHokuyo) {
  for (const double turn_deg : {-20.0, -5.0, 0.0, 10.0, 25.0}) {
    SCOPED_TRACE(turn_deg);
    expect_recovered(kHokuyo, {0.25, -0.2, rad_from_deg(turn_deg)});
  }
}

TEST(RelativePose, EveryOffsetUndoesItsOwnQuarterTurns) {
  const Pose2 T_world_reference{2.0, 2.5, 0.4};
  const Pose2 T_reference_current{0.5, -0.3, 0.9};
  const auto reference =
      prepare_paper(scan_of_walls(l_shaped_room(), T_world_reference, kFullTurn));
  const auto current = prepare_paper(
      scan_of_walls(l_shaped_room(), T_world_reference * T_reference_current, kFullTurn));
  const auto found = relative_pose(reference.projected, current.projected, ShiftSearch{});
  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(found->T_reference_current, PoseNear(T_reference_current, kPaper));
  for (std::size_t quarters = 0; quarters < 4; ++quarters) {
    // As if Algorithm 2 had found another of the room's four directions.
    const double theta_rad =
        current.direction.theta_rad - static_cast<double>(quarters) * 0.5 * kPi;
    const auto projected = project_scan(current.points, theta_rad, ProfileBins{});
    const auto turned = relative_pose(reference.projected, projected, ShiftSearch{});
    ASSERT_TRUE(turned.has_value());
    EXPECT_EQ(turned->offset, (found->offset + quarters) % 4);
    EXPECT_THAT(turned->T_reference_current,
                PoseNear(found->T_reference_current, PoseTolerance{.translation_m = 0.0051}));
    EXPECT_NEAR(turned->zncc_x, found->zncc_x, 0.05);
  }
}

TEST(PaperMatcher, MovingForwardIsAlongX) {
  const Pose2 T_world_reference{2.0, 2.5, rad_from_deg(33.0)};
  const Pose2 T_reference_current{0.8, 0.0, 0.0};
  const MatchResult result = match_paper(
      scan_of_walls(l_shaped_room(), T_world_reference, kFullTurn),
      scan_of_walls(l_shaped_room(), T_world_reference * T_reference_current, kFullTurn));
  ASSERT_TRUE(result.T_reference_current.has_value());
  EXPECT_THAT(*result.T_reference_current, PoseNear(T_reference_current, kPaper));
}

TEST(PaperMatcher, SelfMatchIsIdentity) {
  const Scan scan = scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.3}, kHokuyo);
  const MatchResult result = match_paper(scan, scan);
  EXPECT_EQ(result.status, MatchStatus::kMatched);
  ASSERT_TRUE(result.T_reference_current.has_value());
  EXPECT_THAT(*result.T_reference_current, PoseNear(Pose2{}, PoseTolerance{}));
  EXPECT_DOUBLE_EQ(result.zncc_x, 1.0);
  EXPECT_DOUBLE_EQ(result.zncc_y, 1.0);
  EXPECT_DOUBLE_EQ(result.score, 1.0);
}

TEST(PaperMatcher, LeavesTheEvidenceThatItDoesNotMeasureOpen) {
  const Scan scan = scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.1}, kFullTurn, 0.003, 1);
  for (const MatchResult& result : {match_paper(scan, scan), match_paper(scan, Scan{})}) {
    EXPECT_TRUE(std::isnan(result.agreement));
    EXPECT_TRUE(std::isnan(result.contradiction));
    EXPECT_TRUE(std::isnan(result.overlap));
  }
}

TEST(PaperMatcher, BothReadingsOfEquationSevenServe) {
  PaperParams params;
  params.moment = DirectionMoment::kSquaredFrequency;
  const Pose2 T_world_reference{2.0, 2.5, 0.1};
  const Pose2 T_reference_current{0.5, 0.2, 0.6};
  const MatchResult result = match_paper(
      scan_of_walls(l_shaped_room(), T_world_reference, kFullTurn),
      scan_of_walls(l_shaped_room(), T_world_reference * T_reference_current, kFullTurn),
      params);
  ASSERT_TRUE(result.T_reference_current.has_value());
  EXPECT_THAT(*result.T_reference_current, PoseNear(T_reference_current, kPaper));
}

TEST(PaperMatcher, TraceShowsWhatAlgorithm3Chose) {
  const Scan reference = scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.1}, kFullTurn);
  const Scan current = scan_of_walls(l_shaped_room(), {2.4, 2.3, 1.9}, kFullTurn);
  const auto prepared_reference = prepare_paper(reference).projected;
  const auto prepared_current = prepare_paper(current).projected;
  RelativePoseTrace trace;
  const auto pose = relative_pose(prepared_reference, prepared_current, ShiftSearch{}, kPi, &trace);
  ASSERT_TRUE(pose.has_value());
  for (const OffsetSearch& offset : trace) {
    EXPECT_EQ(offset.x.correlation.size(), 1001U);
    EXPECT_EQ(offset.y.correlation.size(), 1001U);
    EXPECT_LE(offset.product(), trace[pose->offset].product());
  }
  // The axes are square: turning the shifts into the reference's frame keeps their length.
  const double shift_x_m = ShiftSearch{}.shift_m(trace[pose->offset].x.peak);
  const double shift_y_m = ShiftSearch{}.shift_m(trace[pose->offset].y.peak);
  EXPECT_NEAR(
      std::hypot(shift_x_m, shift_y_m), pose->T_reference_current.translation().norm(), 1e-9);
}

TEST(PaperMatcher, AnOffsetBeyondTheLimitIsNotChosen) {
  const Pose2 T_world_reference{2.0, 2.5, 0.1};
  const auto reference =
      prepare_paper(scan_of_walls(l_shaped_room(), T_world_reference, kFullTurn));
  for (const double turn_deg : {-170.0, -92.0, -20.0, 0.0, 30.0, 80.0, 175.0}) {
    SCOPED_TRACE(turn_deg);
    const Pose2 T_reference_current{0.3, -0.2, rad_from_deg(turn_deg)};
    const auto current = prepare_paper(
        scan_of_walls(l_shaped_room(), T_world_reference * T_reference_current, kFullTurn));
    RelativePoseTrace trace;
    const MatchResult literal = match_paper(reference, current);
    const MatchResult limited =
        match_paper(reference, current, {.max_rotation_rad = rad_from_deg(45.0)}, &trace);
    ASSERT_TRUE(limited.T_reference_current.has_value());
    EXPECT_NEAR(limited.T_reference_current->theta_rad,
                wrap_to_period(literal.T_reference_current->theta_rad, 0.5 * kPi),
                1e-9);
    int num_tried = 0;
    for (const OffsetSearch& offset : trace) num_tried += offset.product() > 0;
    EXPECT_EQ(num_tried, 1);
    if (std::abs(turn_deg) < 45.0) {
      EXPECT_EQ(limited.T_reference_current, literal.T_reference_current);
      EXPECT_EQ(limited.score, literal.score);
    }
  }
}

TEST(PaperMatcher, RejectsRoomsThatHaveNothingInCommon) {
  std::vector<testing::Wall> triangle = {{-3, -2, 4, -1}, {4, -1, 0.5, 5}, {0.5, 5, -3, -2}};
  const MatchResult result = match_paper(scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.0}, kFullTurn),
                                         scan_of_walls(triangle, {0.5, 0.5, 0.0}, kFullTurn));
  EXPECT_EQ(result.status, MatchStatus::kRejected);
  EXPECT_TRUE(result.T_reference_current.has_value());  // The best proposal, whatever the status.
  EXPECT_LE(result.score, 0.25);
}

TEST(PaperMatcher, SaysWhereAScanHasNoPoints) {
  const Scan room = scan_of_walls(l_shaped_room(), {2.0, 2.5, 0.0}, kFullTurn);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& ranges_m : {std::vector<double>{},
                                              std::vector<double>{3.0},
                                              std::vector<double>(180, 81.83),
                                              std::vector<double>(180, nan),
                                              std::vector<double>(180, 0.0)}) {
    Scan poor = scan_of_walls({}, {});
    poor.ranges_m = ranges_m;
    for (const MatchResult& result : {match_paper(room, poor), match_paper(poor, room)}) {
      EXPECT_EQ(result.status, MatchStatus::kTooFewPoints);
      EXPECT_FALSE(result.T_reference_current.has_value());
    }
  }
}

TEST(PaperMatcher, AnswersNothingWhereEverythingIsBeyondTheProfiles) {
  Scan far = scan_of_walls({}, {});
  far.ranges_m.assign(180, 29.0);
  far.first_bearing_rad = 0.6;  // Both coordinates beyond 12.5 m, whatever the direction, for some.
  far.bearing_step_rad = 1e-4;
  const MatchResult result = match_paper(far, far);
  EXPECT_NE(result.status, MatchStatus::kMatched);
}

TEST(PaperParams, NamesTheFieldThatIsOutsideItsDomain) {
  EXPECT_NO_THROW(PaperParams{}.validate());
  const auto complaint = [](const PaperParams& params) -> std::string {
    try {
      params.validate();
    } catch (const ParameterError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint({.min_spacing_m = 0.0}), ::testing::HasSubstr("min_spacing_m"));
  EXPECT_THAT(complaint({.bin_width_m = 0.03}), ::testing::HasSubstr("bin_width_m"));
  EXPECT_THAT(complaint({.max_shift_m = -1.0}), ::testing::HasSubstr("max_shift_m"));
  EXPECT_THAT(complaint({.shift_step_m = 0.03}), ::testing::HasSubstr("shift_step_m"));
  EXPECT_THAT(complaint({.max_rotation_rad = 0.5}), ::testing::HasSubstr("max_rotation_rad"));
  EXPECT_THAT(complaint({.max_rotation_rad = 4.0}), ::testing::HasSubstr("max_rotation_rad"));
  EXPECT_THAT(complaint({.min_zncc_product = 1.0}), ::testing::HasSubstr("min_zncc_product"));
  EXPECT_THAT(complaint({.min_num_points = 0}), ::testing::HasSubstr("min_num_points"));
}

}  // namespace setsquare::paper_matcher_test
