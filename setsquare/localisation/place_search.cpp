// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/place_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/sort_by.hpp"
#include "setsquare/localisation/wall_step.hpp"
#include "setsquare/matching/distinct_wall.hpp"
#include "setsquare/matching/keep_best.hpp"
#include "setsquare/matching/sweep_refinement.hpp"
#include "setsquare/matching/wall_kinds.hpp"

namespace setsquare {
namespace {

constexpr float kFitTolerance_m = 0.3F;
/// Of so many places per place that is verified all beams are compared.
constexpr std::size_t kLookedAtPerVerified = 4;

/// How the samples fall on the walls: 1 where all lie on them, -1 where all lie in free space.
double fit_at(const WallDistance& walls, const SurfaceSamples& samples, const Pose2& T) {
  const auto c = static_cast<float>(std::cos(T.theta_rad));
  const auto s = static_cast<float>(std::sin(T.theta_rad));
  const auto x0 = static_cast<float>(T.x_m);
  const auto y0 = static_cast<float>(T.y_m);
  float sum = 0.0F;
  float weight = 0.0F;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float x = c * samples.x_m[i] - s * samples.y_m[i] + x0;
    const float y = s * samples.x_m[i] + c * samples.y_m[i] + y0;
    weight += samples.weight_m[i];
    const float distance_m = walls.slope_at(x, y).distance_m;
    if (distance_m < kFitTolerance_m) {
      const float u = distance_m / kFitTolerance_m;
      sum += samples.weight_m[i] * (1.0F - u * u);
    } else if (walls.state(walls.cell_at(x, y)) == CellState::kFree) {
      sum -= samples.weight_m[i];
    }
  }
  return weight > 0.0F ? sum / weight : -1.0;
}

/// One step of Gauss and Newton onto the walls; samples farther than the tolerance have no part.
Pose2 stepped(const WallDistance& walls,
              const SurfaceSamples& samples,
              const Pose2& T,
              float tolerance_m) {
  const auto c = static_cast<float>(std::cos(T.theta_rad));
  const auto s = static_cast<float>(std::sin(T.theta_rad));
  const auto x0 = static_cast<float>(T.x_m);
  const auto y0 = static_cast<float>(T.y_m);
  float xx = 0.0F, xy = 0.0F, xt = 0.0F, yy = 0.0F, yt = 0.0F, tt = 0.0F;
  float x_sum = 0.0F, y_sum = 0.0F, t_sum = 0.0F;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float rx = c * samples.x_m[i] - s * samples.y_m[i];
    const float ry = s * samples.x_m[i] + c * samples.y_m[i];
    const WallDistance::Slope slope = walls.slope_at(rx + x0, ry + y0);
    if (slope.distance_m >= tolerance_m) continue;
    const float u = slope.distance_m / tolerance_m;
    const float near = 1.0F - u * u;
    const float weight = samples.weight_m[i] * near * near;
    const float lever = slope.along_y * rx - slope.along_x * ry;
    xx += weight * slope.along_x * slope.along_x;
    xy += weight * slope.along_x * slope.along_y;
    xt += weight * slope.along_x * lever;
    yy += weight * slope.along_y * slope.along_y;
    yt += weight * slope.along_y * lever;
    tt += weight * lever * lever;
    x_sum += weight * slope.along_x * slope.distance_m;
    y_sum += weight * slope.along_y * slope.distance_m;
    t_sum += weight * lever * slope.distance_m;
  }
  NormalEquations<3> equations;
  equations.hessian << xx, xy, xt, xy, yy, yt, xt, yt, tt;
  equations.gradient << x_sum, y_sum, t_sum;
  constexpr double kMaxStep_m = 0.3;
  return stepped_onto_walls(T, equations, kMaxStep_m);
}

Pose2 moved_onto_walls(const WallDistance& walls,
                       const SurfaceSamples& samples,
                       const Pose2& proposed) {
  Pose2 T = proposed;
  for (const float tolerance_m : {0.6F, 0.45F, 0.35F, 0.25F}) {
    T = stepped(walls, samples, T, tolerance_m);
  }
  return T;
}

ComparedBeams compared_beams(const Scan& scan) {
  constexpr std::size_t kNumBeams = 120;
  ComparedBeams beams;
  const std::size_t stride = std::max<std::size_t>(1, scan.num_beams() / kNumBeams);
  for (std::size_t beam = stride / 2; beam < scan.num_beams(); beam += stride) {
    const BeamOutcome outcome = scan.outcome(beam);
    if (outcome == BeamOutcome::kInvalid) continue;
    beams.directions.push_back(rotation_matrix(scan.bearing_rad(beam)).col(0));
    beams.range_m.push_back(outcome == BeamOutcome::kReturn
                                ? scan.ranges_m[beam]
                                : std::numeric_limits<double>::infinity());
  }
  return beams;
}

/// Every fourth of the beams: a first look.
ComparedBeams every_fourth(const ComparedBeams& beams) {
  ComparedBeams fewer;
  for (std::size_t i = 0; i < beams.range_m.size(); i += 4) {
    fewer.directions.push_back(beams.directions[i]);
    fewer.range_m.push_back(beams.range_m[i]);
  }
  return fewer;
}

/// How ranges agree with those that are to be expected.
struct RangeAgreement {
  double mean = -1.0;           ///< 1 where all agree, -1 where all go through walls.
  double unjudged_share = 1.0;  ///< Of the beams: as in VerifiedPlace.
};

RangeAgreement range_agreement(const WallDistance& walls,
                               const ComparedBeams& beams,
                               double max_range_m,
                               const Pose2& T) {
  constexpr double kTolerance_m = 0.3;
  constexpr double kShort = -0.5;  ///< Something stands before the wall: people, new things.
  double sum = 0.0;
  std::size_t num_unjudged = 0;
  const Eigen::Matrix2d turn = rotation_matrix(T.theta_rad);
  for (std::size_t i = 0; i < beams.range_m.size(); ++i) {
    const double expected_m =
        range_to_wall(walls, T.x_m, T.y_m, turn * beams.directions[i], max_range_m);
    const double range_m = beams.range_m[i];
    if (std::isnan(expected_m)) {
      num_unjudged += !std::isinf(range_m);
      continue;
    }
    if (std::isinf(range_m)) {
      // No return proves little: dark and slanting things give none.
      sum += std::isinf(expected_m) ? 0.5 : 0.0;
      continue;
    }
    const double beyond_m = range_m - expected_m;
    const double tolerance_m = kTolerance_m + 0.02 * range_m;
    const double u = beyond_m / tolerance_m;
    if (std::abs(u) < 1.0) {
      sum += 1.0 - u * u;
    } else {
      sum += beyond_m > 0.0 ? -1.0 : kShort;
    }
  }
  if (beams.range_m.empty()) return {};
  const auto num_beams = static_cast<double>(beams.range_m.size());
  return {sum / num_beams, static_cast<double>(num_unjudged) / num_beams};
}

/// Of the samples' wall, the share on which no line fits.
double unlined_share(const SurfaceSamples& samples) {
  float all_m = 0.0F;
  float unlined_m = 0.0F;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    all_m += samples.weight_m[i];
    if (samples.normal_x[i] == 0.0F && samples.normal_y[i] == 0.0F)
      unlined_m += samples.weight_m[i];
  }
  return all_m > 0.0F ? unlined_m / all_m : 1.0;
}

RangeAgreement range_agreement(const KnownMap& map, const SoughtScan& scan, const Pose2& T) {
  return range_agreement(map.walls(), scan.compared, scan.beams.max_range_m, T);
}

/// On the walls, and range by range.
double whole_fit(double fit_on_walls, const RangeAgreement& ranges) {
  return 0.5 * (fit_on_walls + ranges.mean);
}

/// How the scan fits a place.
struct PlaceFit {
  double whole = -1.0;
  double unjudged_share = 0.0;  ///< As of RangeAgreement.
};

PlaceFit place_fit(const KnownMap& map, const SoughtScan& scan, const Pose2& T_grid_sensor) {
  const RangeAgreement ranges = range_agreement(map, scan, T_grid_sensor);
  return {whole_fit(fit_at(map.walls(), scan.proposing, T_grid_sensor), ranges),
          ranges.unjudged_share};
}

/// The best of the whole map, the highest correlation first.
std::vector<MapProposal> propose_places(const KnownMap& map,
                                        const SoughtScan& scan,
                                        std::size_t num_rotations,
                                        std::size_t num_proposals) {
  std::vector<MapProposal> proposals;
  MapCorrelation::Scratch scratch;
  int min_correlation = static_cast<int>(scan.proposing.size()) / 3;
  for (std::size_t i = 0; i < num_rotations; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(num_rotations);
    const double rotation_rad = wrap_to_pi(share * kTwoPi);
    map.correlation().propose(scan.proposing, rotation_rad, min_correlation, scratch, proposals);
    min_correlation = std::max(min_correlation, keep_best(num_proposals, proposals));
  }
  sort_by_greatest(proposals, &MapProposal::correlation);
  return proposals;
}

}  // namespace

SoughtScan sought_scan(const Scan& scan) {
  SoughtScan sought;
  sought.prepared = prepare(scan);
  const SurfacePoints& points = sought.prepared.points();
  sought.proposing = sample_surface(points,
                                    direction_balanced_weights(points, sought.prepared.histogram),
                                    MapCorrelation::kMaxSamples);
  sought.beams = layout_of(scan);
  sought.compared = compared_beams(scan);
  return sought;
}

bool is_one_place(const Pose2& a, const Pose2& b) {
  constexpr double kSame_m = 0.4;
  constexpr double kSame_rad = rad_from_deg(6.0);
  const double dx_m = a.x_m - b.x_m;
  const double dy_m = a.y_m - b.y_m;
  return dx_m * dx_m + dy_m * dy_m < kSame_m * kSame_m &&
         std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)) < kSame_rad;
}

VerifiedPlace verified_place(const KnownMap& map,
                             const SoughtScan& scan,
                             const Pose2& T_grid_sensor,
                             double max_fall) {
  constexpr std::array<double, 3> kTolerances_m{0.3, 0.2, 0.2};
  const MatchParams params;
  VerifiedPlace place;
  const PreparedScan expected = prepare(expected_scan(map.walls(), scan.beams, T_grid_sensor));
  const Pose2 T_expected_scan =
      refine(expected.fine_alignment(), scan.prepared.fine_alignment(), {}, kTolerances_m);
  const SweepRefinement refined = refine_with_turns(expected.swept(),
                                                    scan.prepared.swept(),
                                                    T_expected_scan,
                                                    params.refinement.sweep_tolerance_m,
                                                    params.sweep);
  const PlaceFit fit_before = place_fit(map, scan, T_grid_sensor);
  const PlaceFit fit_refined = place_fit(map, scan, T_grid_sensor * refined.T_reference_current);
  const bool is_astray = fit_refined.whole < fit_before.whole - max_fall;
  const Pose2 T = is_astray ? Pose2{} : refined.T_reference_current;
  const PlaceFit& fit = is_astray ? fit_before : fit_refined;
  place.T_grid_sensor = T_grid_sensor * T;
  const Alignment aligned =
      align(expected.fine_alignment(), scan.prepared.fine_alignment(), T, params.score.tolerance_m);
  place.score = score(aligned.evidence, params.score);
  place.unlined_share = unlined_share(scan.prepared.fine);
  place.unjudged_share = fit.unjudged_share;
  place.fit = fit.whole;
  place.kinds = wall_kinds(expected.fine_alignment(), scan.prepared.fine_alignment(), T);
  place.constraint = wall_constraint(refined.pose_hessian);
  place.distinct_wall_m = distinct_wall_m(
      expected.fine_alignment(), scan.prepared.fine_alignment(), T, params.distinct_wall);
  place.information = match_information(refined.normal);
  return place;
}

PlaceSearch::PlaceSearch(const KnownMap& map,
                         const SoughtScan& scan,
                         const PlaceSearchParams& widest)
    : map_(map),
      scan_(scan),
      proposals_(propose_places(
          map, scan, widest.num_rotations, widest.in_area(map.free_m2()).num_proposals)) {}

std::vector<VerifiedPlace> PlaceSearch::best(const PlaceSearchParams& wished) {
  const PlaceSearchParams params = wished.in_area(map_.free_m2());
  move_proposals(params.num_proposals);
  // Those of a search before keep what was measured at them.
  std::vector<RoughPlace*> different;
  for (RoughPlace& place : rough_) {
    if (different.size() == params.num_compared) break;
    const bool is_known = std::ranges::any_of(different, [&](const RoughPlace* other) {
      return is_one_place(place.T_grid_sensor, other->T_grid_sensor);
    });
    if (!is_known) different.push_back(&place);
  }
  look_at(different, kLookedAtPerVerified * params.num_verified);
  for (RoughPlace* place : different) {
    if (place->whole_fit) continue;
    place->whole_fit =
        whole_fit(place->fit_on_walls, range_agreement(map_, scan_, place->T_grid_sensor));
  }
  sort_by_greatest(different, [](const RoughPlace* place) { return *place->whole_fit; });
  if (different.size() > params.num_verified) different.resize(params.num_verified);
  std::vector<VerifiedPlace> verified;
  for (RoughPlace* place : different) {
    if (!place->verified) place->verified = verified_place(map_, scan_, place->T_grid_sensor);
    const bool is_known = std::ranges::any_of(verified, [&](const VerifiedPlace& other) {
      return is_one_place(place->verified->T_grid_sensor, other.T_grid_sensor);
    });
    if (!is_known) verified.push_back(*place->verified);
  }
  sort_by_greatest(verified, &VerifiedPlace::score);
  return verified;
}

void PlaceSearch::move_proposals(std::size_t count) {
  const std::size_t end = std::min(count, proposals_.size());
  for (; num_moved_ < end; ++num_moved_) {
    const Pose2 T =
        moved_onto_walls(map_.walls(), scan_.proposing, proposals_[num_moved_].T_grid_sensor);
    rough_.push_back(
        {.T_grid_sensor = T, .fit_on_walls = fit_at(map_.walls(), scan_.proposing, T)});
  }
  sort_by_greatest(rough_, &RoughPlace::fit_on_walls);
}

void PlaceSearch::look_at(std::vector<RoughPlace*>& places, std::size_t count) const {
  if (places.size() <= count) return;
  const ComparedBeams beams = every_fourth(scan_.compared);
  for (RoughPlace* place : places) {
    if (place->first_look) continue;
    place->first_look = whole_fit(
        place->fit_on_walls,
        range_agreement(map_.walls(), beams, scan_.beams.max_range_m, place->T_grid_sensor));
  }
  sort_by_greatest(places, [](const RoughPlace* place) { return *place->first_look; });
  places.resize(count);
}

std::vector<VerifiedPlace> search_places(const KnownMap& map,
                                         const SoughtScan& scan,
                                         const PlaceSearchParams& params) {
  return PlaceSearch(map, scan, params).best(params);
}

}  // namespace setsquare
