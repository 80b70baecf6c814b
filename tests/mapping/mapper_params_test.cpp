// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Every bad field of the structs below reaches the mapper's own validate(), by its name.
#include "setsquare/mapping/mapper_params.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/mapper.hpp"

namespace setsquare::mapper_params_test {

/// What the error says; empty where there is none.
std::string complaint(const std::function<void(MapperParams&)>& spoil) {
  MapperParams params;
  spoil(params);
  try {
    params.validate();
  } catch (const ParameterError& error) {
    return error.what();
  }
  return {};
}

enum class Zero { kIsFine, kIsBad };

struct Number {
  std::string name;
  std::function<double&(MapperParams&)> of;
  Zero zero = Zero::kIsBad;
};

template <typename Struct>
struct Member {
  std::string name;
  double Struct::*field;
  Zero zero = Zero::kIsBad;
};

/// `of`: the struct among the mapper's parameters.
template <typename Struct>
void add(const std::function<Struct&(MapperParams&)>& of,
         const std::string& prefix,
         const std::vector<Member<Struct>>& members,
         std::vector<Number>& numbers) {
  for (const Member<Struct>& member : members) {
    const auto field = [=](MapperParams& p) -> double& { return of(p).*member.field; };
    numbers.push_back({prefix + member.name, field, member.zero});
  }
}

void add_tracker(std::vector<Number>& numbers) {
  using Gap = ScanGapParams;
  add<Gap>([](MapperParams& p) -> Gap& { return p.tracker.gap; },
           "gap.",
           {{"min_gap_s", &Gap::min_gap_s},
            {"min_num_periods", &Gap::min_num_periods},
            {"same_range_m", &Gap::same_range_m},
            {"min_same", &Gap::min_same}},
           numbers);
  using Refinement = SubmapRefinementParams;
  add<Refinement>([](MapperParams& p) -> Refinement& { return p.tracker.refinement; },
                  "refinement.",
                  {{"converged_m", &Refinement::converged_m},
                   {"converged_rad", &Refinement::converged_rad},
                   {"max_step_m", &Refinement::max_step_m},
                   {"min_effective_points", &Refinement::min_effective_points},
                   {"chance_points", &Refinement::chance_points, Zero::kIsFine}},
                  numbers);
  using Scale = AlignmentScale;
  const std::vector<Member<Scale>> scale = {{"gate_m", &Scale::gate_m},
                                            {"scale_m", &Scale::scale_m}};
  add<Scale>([](MapperParams& p) -> Scale& { return p.tracker.refinement.first_step; },
             "refinement.first_step.",
             scale,
             numbers);
  add<Scale>([](MapperParams& p) -> Scale& { return p.tracker.refinement.later_steps; },
             "refinement.later_steps.",
             scale,
             numbers);
  using Corridor = CorridorSearchParams;
  add<Corridor>([](MapperParams& p) -> Corridor& { return p.tracker.corridor; },
                "corridor.",
                {{"below_effective_points", &Corridor::below_effective_points, Zero::kIsFine},
                 {"half_range_m", &Corridor::half_range_m},
                 {"step_m", &Corridor::step_m},
                 {"scale_m", &Corridor::scale_m},
                 {"motion_cost", &Corridor::motion_cost, Zero::kIsFine}},
                numbers);
  using Trust = PredictionTrust;
  const std::vector<Member<Trust>> trust = {{"weight", &Trust::weight, Zero::kIsFine},
                                            {"sigma_m", &Trust::sigma_m},
                                            {"min_gain", &Trust::min_gain, Zero::kIsFine}};
  add<Trust>([](MapperParams& p) -> Trust& { return p.tracker.trust_in_odometry; },
             "trust_in_odometry.",
             trust,
             numbers);
  add<Trust>([](MapperParams& p) -> Trust& { return p.tracker.trust_in_last_motion; },
             "trust_in_last_motion.",
             trust,
             numbers);
}

void add_motion(std::vector<Number>& numbers) {
  using P = MotionUncertaintyParams;
  add<P>([](MapperParams& p) -> P& { return p.motion; },
         "",
         {{"step_sigma_m", &P::step_sigma_m},
          {"sigma_per_metre", &P::sigma_per_metre, Zero::kIsFine},
          {"open_acceleration_m_per_s2", &P::open_acceleration_m_per_s2, Zero::kIsFine},
          {"open_speed_m_per_s", &P::open_speed_m_per_s, Zero::kIsFine},
          {"open_sigma_per_metre_by_odometry", &P::open_sigma_per_metre_by_odometry, Zero::kIsFine},
          {"lost_sigma_m", &P::lost_sigma_m},
          {"recovered_sigma_m", &P::recovered_sigma_m},
          {"restart_sigma_m", &P::restart_sigma_m},
          {"step_sigma_rad", &P::step_sigma_rad},
          {"sigma_per_turn", &P::sigma_per_turn, Zero::kIsFine},
          {"lost_sigma_rad", &P::lost_sigma_rad},
          {"recovered_sigma_rad", &P::recovered_sigma_rad},
          {"restart_sigma_rad", &P::restart_sigma_rad},
          {"lost_sigma_m_by_odometry", &P::lost_sigma_m_by_odometry},
          {"restart_sigma_m_by_odometry", &P::restart_sigma_m_by_odometry},
          {"lost_sigma_rad_by_odometry", &P::lost_sigma_rad_by_odometry},
          {"restart_sigma_rad_by_odometry", &P::restart_sigma_rad_by_odometry}},
         numbers);
}

void add_closing(std::vector<Number>& numbers) {
  using P = ClosureCandidateParams;
  add<P>([](MapperParams& p) -> P& { return p.closing.candidates; },
         "candidates.",
         {{"radius_m", &P::radius_m},
          {"min_way_m", &P::min_way_m, Zero::kIsFine},
          {"window_m", &P::window_m},
          {"window_per_metre", &P::window_per_metre},
          {"max_window_m", &P::max_window_m},
          {"slip_way", &P::slip_way, Zero::kIsFine},
          {"max_sigmas_open", &P::max_sigmas_open, Zero::kIsFine},
          {"closure_way_m", &P::closure_way_m}},
         numbers);
  using Joining = PieceJoiningParams;
  add<Joining>([](MapperParams& p) -> Joining& { return p.joining; },
               "joining.",
               {{"window_m", &Joining::window_m},
                {"agreeing_m", &Joining::agreeing_m},
                {"agreeing_rad", &Joining::agreeing_rad}},
               numbers);
  using Anywhere = ClosuresAnywhereParams;
  add<Anywhere>([](MapperParams& p) -> Anywhere& { return p.anywhere; },
                "anywhere.",
                {{"min_spread_m", &Anywhere::min_spread_m},
                 {"max_rival_share", &Anywhere::max_rival_share},
                 {"num_sigmas_of_one", &Anywhere::num_sigmas_of_one, Zero::kIsFine},
                 {"num_sigmas_of_two", &Anywhere::num_sigmas_of_two, Zero::kIsFine},
                 {"extent_share", &Anywhere::extent_share, Zero::kIsFine},
                 {"min_kept", &Anywhere::min_kept, Zero::kIsFine}},
                numbers);
  using Outvoted = OutvotedWallsParams;
  add<Outvoted>([](MapperParams& p) -> Outvoted& { return p.outvoted; },
                "outvoted.",
                {{"seen_sigma_rad", &Outvoted::seen_sigma_rad},
                 {"min_turn_rad", &Outvoted::min_turn_rad},
                 {"max_sigmas", &Outvoted::max_sigmas},
                 {"max_turn_rad", &Outvoted::max_turn_rad},
                 {"min_sigma_rad", &Outvoted::min_sigma_rad},
                 {"same_place_m", &Outvoted::same_place_m},
                 {"min_majority", &Outvoted::min_majority}},
                numbers);
  using Audit = AuditParams;
  add<Audit>([](MapperParams& p) -> Audit& { return p.audit; },
             "audit.",
             {{"pairs_per_keyframe", &Audit::pairs_per_keyframe},
              {"near_m", &Audit::near_m},
              {"min_way_m", &Audit::min_way_m, Zero::kIsFine},
              {"revisit_way_m", &Audit::revisit_way_m, Zero::kIsFine},
              {"off_m", &Audit::off_m},
              {"off_rad", &Audit::off_rad},
              {"max_sigmas", &Audit::max_sigmas, Zero::kIsFine},
              {"part_m", &Audit::part_m},
              {"alike_m", &Audit::alike_m},
              {"alike_share", &Audit::alike_share, Zero::kIsFine},
              {"alike_rad", &Audit::alike_rad},
              {"min_majority", &Audit::min_majority}},
             numbers);
}

TEST(MapperParams, ANumberOutsideItsDomainIsNamed) {
  EXPECT_EQ(complaint([](MapperParams&) {}), "");
  std::vector<Number> numbers;
  add_tracker(numbers);
  add_motion(numbers);
  add_closing(numbers);
  for (const Number& number : numbers) {
    const std::string name = "parameter " + number.name + ":";
    const auto complaint_at = [&](double value) {
      return complaint([&](MapperParams& p) { number.of(p) = value; });
    };
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             -1.0}) {
      EXPECT_EQ(complaint_at(bad).rfind(name, 0), 0U) << number.name << " = " << bad;
    }
    EXPECT_EQ(complaint_at(0.0).empty(), number.zero == Zero::kIsFine) << number.name;
  }
}

TEST(MapperParams, ACountOfNoneIsNamed) {
  using P = MapperParams;
  const std::vector<std::pair<std::string, std::function<void(P&)>>> counts = {
      {"refinement.max_iterations", [](P& p) { p.tracker.refinement.max_iterations = 0; }},
      {"candidates.max_num", [](P& p) { p.closing.candidates.max_num = 0; }},
      {"candidates.min_separation", [](P& p) { p.closing.candidates.min_separation = 0; }},
      {"joining.max_num_queries", [](P& p) { p.joining.max_num_queries = 0; }},
      {"joining.num_similar", [](P& p) { p.joining.num_similar = 0; }},
      {"joining.min_agreeing", [](P& p) { p.joining.min_agreeing = 0; }},
      {"anywhere.max_num_places", [](P& p) { p.anywhere.max_num_places = 0; }},
      {"anywhere.num_alike", [](P& p) { p.anywhere.num_alike = 0; }},
      {"anywhere.min_places", [](P& p) { p.anywhere.min_places = 0; }},
      {"outvoted.min_places", [](P& p) { p.outvoted.min_places = 0; }},
      {"audit.min_num_pairs", [](P& p) { p.audit.min_num_pairs = 0; }},
      {"audit.min_seconded", [](P& p) { p.audit.min_seconded = 0; }},
  };
  for (const auto& [name, spoil] : counts) {
    EXPECT_EQ(complaint(spoil), "parameter " + name + ": must be at least 1");
  }
}

TEST(MapperParams, FieldsThatDoNotGoTogetherAreNamed) {
  EXPECT_NE(complaint([](MapperParams& p) {
              p.tracker.refinement.chance_points = p.tracker.refinement.min_effective_points;
            }).find("refinement.min_effective_points"),
            std::string::npos);
  EXPECT_NE(complaint([](MapperParams& p) {
              p.closing.candidates.window_m = 2.0 * p.closing.candidates.max_window_m;
            }).find("candidates.max_window_m"),
            std::string::npos);
  EXPECT_NE(complaint([](MapperParams& p) { p.tracker.gap.min_same = 1.01; }).find("gap.min_same"),
            std::string::npos);
}

}  // namespace setsquare::mapper_params_test
