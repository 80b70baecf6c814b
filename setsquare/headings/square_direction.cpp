// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/square_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/headings/curve_peaks.hpp"
#include "setsquare/headings/square_direction_mean.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kNumDensityBins = 180;  // Of the density: 0.5 deg each.
constexpr double kBin_rad = kQuarterTurn / static_cast<double>(kNumDensityBins);

/// Density of the rotations that lay a piece along an axis, modulo 90 deg, one value per bin. A
/// piece counts by the root of its length, spread by a normal curve as wide as it is uncertain.
std::vector<double> direction_density(const std::vector<StraightPiece>& pieces,
                                      const SquareDirectionParams& params) {
  std::vector<double> density(kNumDensityBins, 0.0);
  for (const StraightPiece& piece : pieces) {
    const double width_rad = std::sqrt(piece_variance_rad2(piece, params) +
                                       params.density_width_rad * params.density_width_rad);
    const double height = std::sqrt(piece.length_m) / width_rad;
    const double center = wrap_to_period(-piece.direction_rad, kQuarterTurn) / kBin_rad - 0.5;
    constexpr long kMaxReach = static_cast<long>(kNumDensityBins) / 2 - 1;
    const long reach = static_cast<long>(
        std::min(3.0 * width_rad / kBin_rad + 1.0, static_cast<double>(kMaxReach)));
    const long nearest = std::lround(center);
    for (long k = nearest - reach; k <= nearest + reach; ++k) {
      const double z = (static_cast<double>(k) - center) * kBin_rad / width_rad;
      const auto bin =
          static_cast<std::size_t>(k + 2 * static_cast<long>(kNumDensityBins)) % kNumDensityBins;
      density[bin] += height * std::exp(-0.5 * z * z);
    }
  }
  return density;
}

bool is_apart(const SquareDirection& peak,
              const std::vector<SquareDirection>& others,
              double min_separation_rad) {
  return std::all_of(others.begin(), others.end(), [&](const SquareDirection& other) {
    return std::abs(wrap_to_period(peak.theta_rad - other.theta_rad, kQuarterTurn)) >=
           0.5 * min_separation_rad;
  });
}

}  // namespace

void SquareDirectionParams::validate() const {
  require_positive(min_separation_rad, "min_separation_rad");
  require_positive(density_width_rad, "density_width_rad");
  require_positive(min_rms_m, "min_rms_m");
  require_positive(wall_sigma_rad, "wall_sigma_rad");
  require_positive(inlier_rad, "inlier_rad");
  require_positive(min_pair_distance_m, "min_pair_distance_m");
  require_positive(pair_sigma_m, "pair_sigma_m");
  require_positive(pair_inlier_m, "pair_inlier_m");
  if (!(pair_weight >= 0.0)) throw ParameterError("pair_weight", "must not be negative");
}

double SquareDirections::margin() const {
  if (peaks.empty()) return 0.0;
  if (peaks.size() == 1) return std::numeric_limits<double>::infinity();
  return peaks[0].height / peaks[1].height;
}

SquareDirections square_directions(const PointSet& points,
                                   double bearing_step_rad,
                                   const SquareDirectionParams& params) {
  const std::vector<StraightPiece> pieces =
      straight_pieces(points, bearing_step_rad, params.pieces);
  const auto min_separation =
      static_cast<std::size_t>(std::max(params.min_separation_rad / kBin_rad, 1.0));
  SquareDirections directions;
  for (const CurvePeak& peak :
       highest_peaks(direction_density(pieces, params), params.max_num_peaks, min_separation)) {
    const double start_rad = (peak.position + 0.5) * kBin_rad;
    const DirectionMean mean = robust_direction_mean(pieces, start_rad, params);
    double theta_rad = wrap_to_period(mean.theta_rad, kQuarterTurn);
    if (theta_rad < 0.0) theta_rad += kQuarterTurn;
    const SquareDirection direction{theta_rad, mean.sigma_rad, peak.over_mean, peak.value};
    if (!is_apart(direction, directions.peaks, params.min_separation_rad)) continue;
    directions.peaks.push_back(direction);
  }
  return directions;
}

}  // namespace setsquare
