// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/square_direction_mean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/robust_weight.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

/// A piece once the scan is turned by theta.
struct TurnedPiece {
  double along_m = 0.0;   ///< Of its centre, along its axis.
  double across_m = 0.0;  ///< Of its centre, across it.
  double weight = 0.0;    ///< In pairs: its length up to 1 m.
  std::size_t index = 0;
  bool is_vertical = false;  ///< Runs along y.
};

/// One step of the iteration: weights, weighted residuals, and every piece's share of them.
struct Step {
  double sum_weights = 0.0;
  double sum_residuals = 0.0;
  std::vector<double> share;

  void add(std::size_t piece, double weight, double residual_rad) {
    sum_weights += weight;
    sum_residuals += weight * residual_rad;
    share[piece] += weight * residual_rad;
  }
  /// Half of the residual goes to each piece of the pair.
  void add_pair(std::size_t a, std::size_t b, double weight, double residual_rad) {
    add(a, 0.5 * weight, residual_rad);
    add(b, 0.5 * weight, residual_rad);
  }
};

void add_pieces(const std::vector<StraightPiece>& pieces,
                double theta_rad,
                const SquareDirectionParams& params,
                Step& step) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double residual_rad = wrap_to_period(-pieces[i].direction_rad - theta_rad, kQuarterTurn);
    const double weight = geman_mcclure_weight(residual_rad, params.inlier_rad);
    step.add(i, weight / piece_variance_rad2(pieces[i], params), residual_rad);
  }
}

std::vector<TurnedPiece> turn_pieces(const std::vector<StraightPiece>& pieces,
                                     const std::vector<std::size_t>& paired,
                                     double theta_rad,
                                     const SquareDirectionParams& params) {
  const double s = std::sin(theta_rad);
  const double c = std::cos(theta_rad);
  std::vector<TurnedPiece> turned;
  turned.reserve(paired.size());
  for (const std::size_t i : paired) {
    const StraightPiece& piece = pieces[i];
    const double axes = std::round((piece.direction_rad + theta_rad) / kQuarterTurn);
    if (std::abs(piece.direction_rad + theta_rad - axes * kQuarterTurn) >= params.inlier_rad)
      continue;
    const bool is_vertical = static_cast<long>(axes) % 2 != 0;
    const double x_m = c * piece.center_x_m - s * piece.center_y_m;
    const double y_m = s * piece.center_x_m + c * piece.center_y_m;
    turned.push_back({is_vertical ? y_m : x_m,
                      is_vertical ? -x_m : y_m,
                      std::min(piece.length_m, 1.0),
                      i,
                      is_vertical});
  }
  return turned;
}

/// Collinear pieces belong to one wall; its direction is that between their centres.
void add_pairs(const std::vector<TurnedPiece>& turned,
               const SquareDirectionParams& params,
               Step& step) {
  const double wall_variance = params.wall_sigma_rad * params.wall_sigma_rad;
  const double pair_variance_m2 = params.pair_sigma_m * params.pair_sigma_m;
  for (std::size_t a = 0; a < turned.size(); ++a) {
    for (std::size_t b = a + 1; b < turned.size(); ++b) {
      if (turned[a].is_vertical != turned[b].is_vertical) continue;
      const double along_m = turned[b].along_m - turned[a].along_m;
      const double across_m = turned[b].across_m - turned[a].across_m;
      if (std::abs(along_m) < params.min_pair_distance_m) continue;
      const double variance = wall_variance + pair_variance_m2 / (along_m * along_m);
      const double weight = params.pair_weight * turned[a].weight * turned[b].weight *
                            geman_mcclure_weight(across_m, params.pair_inlier_m) / variance;
      step.add_pair(turned[a].index, turned[b].index, weight, -across_m / along_m);
    }
  }
}

/// The pieces to pair: the longest, in their own order.
std::vector<std::size_t> longest(const std::vector<StraightPiece>& pieces, std::size_t max_num) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() <= max_num) return order;
  sort_by_greatest(order, [&pieces](std::size_t k) { return pieces[k].length_m; });
  order.resize(max_num);
  std::sort(order.begin(), order.end());
  return order;
}

/// Spread of the pieces' shares, pieces taken as independent (the sandwich estimate), widened to
/// what the relations of real logs show (docs/method.md).
double sigma_of(const Step& step) {
  constexpr double kFloor_rad = rad_from_deg(0.15);
  constexpr double kFactor = 2.0;
  double sum_squares = 0.0;
  for (const double share : step.share) sum_squares += share * share;
  return std::hypot(kFloor_rad, kFactor * std::sqrt(sum_squares) / step.sum_weights);
}

}  // namespace

double piece_variance_rad2(const StraightPiece& piece, const SquareDirectionParams& params) {
  const double rms_m = std::max(piece.rms_m, params.min_rms_m);
  return params.wall_sigma_rad * params.wall_sigma_rad + rms_m * rms_m / piece.spread_m2;
}

DirectionMean robust_direction_mean(const std::vector<StraightPiece>& pieces,
                                    double start_rad,
                                    const SquareDirectionParams& params) {
  constexpr int kMaxIterations = 8;
  constexpr int kIterationsBeforePairs = 2;  // Pairs need a direction good to a degree.
  constexpr double kConverged_rad = 1e-6;
  const std::vector<std::size_t> paired = longest(pieces, params.max_num_paired);
  DirectionMean mean{start_rad, kPi};
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    Step step{0.0, 0.0, std::vector<double>(pieces.size(), 0.0)};
    add_pieces(pieces, mean.theta_rad, params, step);
    if (iteration >= kIterationsBeforePairs) {
      add_pairs(turn_pieces(pieces, paired, mean.theta_rad, params), params, step);
    }
    if (!(step.sum_weights > 0.0)) break;
    const double change_rad = step.sum_residuals / step.sum_weights;
    mean = {mean.theta_rad + change_rad, sigma_of(step)};
    if (iteration > kIterationsBeforePairs && std::abs(change_rad) < kConverged_rad) break;
  }
  return mean;
}

}  // namespace setsquare
