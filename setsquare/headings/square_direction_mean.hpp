// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from square_direction, its only caller: the robust mean of the pieces is a separate idea.
#pragma once

#include <vector>

#include "setsquare/headings/square_direction.hpp"
#include "setsquare/headings/straight_pieces.hpp"

namespace setsquare {

/// Variance of a piece's direction as one of its building's, in rad^2: of the fitted line, and of
/// the wall itself.
[[nodiscard]] double piece_variance_rad2(const StraightPiece& piece,
                                         const SquareDirectionParams& params);

/// A robust mean and its standard deviation.
struct DirectionMean {
  double theta_rad = 0.0;
  double sigma_rad = 0.0;
};

/// Step (3) of square_directions: the robust mean, modulo 90 deg, of the rotations that lay the
/// pieces, and the lines from piece to piece, along an axis, starting at `start_rad`.
[[nodiscard]] DirectionMean robust_direction_mean(const std::vector<StraightPiece>& pieces,
                                                  double start_rad,
                                                  const SquareDirectionParams& params);

}  // namespace setsquare
