// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/localisation/expected_scan.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localisation_params.hpp"
#include "setsquare/localisation/map_correlation.hpp"
#include "setsquare/matching/verdict.hpp"
#include "setsquare/matching/wall_kinds.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// Some beams of a scan, evenly over its sweep, that tell how far it is to a wall or how far
/// nothing is.
struct ComparedBeams {
  std::vector<Eigen::Vector2d> directions;  ///< In the sensor frame, of length 1.
  std::vector<double> range_m;              ///< Infinite: nothing within reach.
};

/// A scan as it is searched for in a map.
struct SoughtScan {
  PreparedScan prepared;
  SurfaceSamples proposing;  ///< A few dozen, rare directions favoured.
  BeamLayout beams;
  ComparedBeams compared;
};

/// Throws ParameterError where the scan's geometry is not valid (Scan::validate).
[[nodiscard]] SoughtScan sought_scan(const Scan& scan);

/// A place compared with the scan that is to be expected there.
struct VerifiedPlace {
  Pose2 T_grid_sensor;
  double fit = 0.0;    ///< Of samples on the walls and of ranges with the expected ones, -1 to 1.
  double score = 0.0;  ///< Of the matcher (score()).
  TwoWayKinds kinds;   ///< The scan's wall on the expected one, and back.
  WallConstraint constraint;
  double distinct_wall_m = 0.0;
  /// Of the beams, those that returned along rays through space that the map does not know: they
  /// speak neither for the place nor against it.
  double unjudged_share = 1.0;
  /// Of the scan's wall, on which no line fits: much of it where ranges are noisy.
  double unlined_share = 0.0;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< In the grid's frame.
};

/// Places near enough to be one answer.
[[nodiscard]] bool is_one_place(const Pose2& a, const Pose2& b);

/// The places of a whole map where a scan may have been taken:
///
/// 1. every translation is correlated at each rotation (MapCorrelation);
/// 2. the best are moved onto the walls by the distance to them, and compared;
/// 3. the best different ones are verified against the scan that is to be expected there, free
///    space and all, and refined.
///
/// What is found may be searched again, wider: nothing is measured twice. The map and the scan must
/// outlive it.
class PlaceSearch {
 public:
  /// Step 1. No search may look at more proposals than those of `widest`.
  PlaceSearch(const KnownMap& map, const SoughtScan& scan, const PlaceSearchParams& widest);

  /// Steps 2 and 3: the best places, all different, best first. `wished` is that of a large map.
  [[nodiscard]] std::vector<VerifiedPlace> best(const PlaceSearchParams& wished);

 private:
  /// A place on its way from proposal to verification.
  struct RoughPlace {
    Pose2 T_grid_sensor;
    double fit_on_walls = -1.0;
    std::optional<double> first_look = std::nullopt;  ///< Fit by a few beams.
    std::optional<double> whole_fit = std::nullopt;   ///< Once it was compared.
    std::optional<VerifiedPlace> verified = std::nullopt;
  };

  void move_proposals(std::size_t count);
  /// Keeps the best `count` of the places, by a few of the beams.
  void look_at(std::vector<RoughPlace*>& places, std::size_t count) const;

  const KnownMap& map_;
  const SoughtScan& scan_;
  std::vector<MapProposal> proposals_;  ///< The highest correlation first.
  std::size_t num_moved_ = 0;           ///< Of these, onto the walls.
  std::vector<RoughPlace> rough_;       ///< Best fit on the walls first.
};

/// The best places of the whole map by one search, all different, best first.
[[nodiscard]] std::vector<VerifiedPlace> search_places(const KnownMap& map,
                                                       const SoughtScan& scan,
                                                       const PlaceSearchParams& params = {});

/// A place that the refinement leaves with a fit that fell by more was led astray by it.
inline constexpr double kMaxFallOfFit = 0.05;

/// Step 3 alone, of a place that is right within some decimetres and degrees. Few or noisy returns
/// may lead the refinement astray: where the fit falls by more than `max_fall`, it stays where it
/// was.
[[nodiscard]] VerifiedPlace verified_place(const KnownMap& map,
                                           const SoughtScan& scan,
                                           const Pose2& T_grid_sensor,
                                           double max_fall = kMaxFallOfFit);

}  // namespace setsquare
