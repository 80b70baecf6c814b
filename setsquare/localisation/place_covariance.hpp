// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/localisation/place_search.hpp"

namespace setsquare {

/// Inverse covariance of a verified place in the grid's frame: what the walls determine, but no
/// better than a map of cells is.
[[nodiscard]] Eigen::Matrix3d information_of(const VerifiedPlace& place);

/// Its covariance: along what the walls leave open as wide as the place was searched.
[[nodiscard]] Eigen::Matrix3d covariance_of(const VerifiedPlace& place);

/// The same covariance in a frame that is turned by an angle: that of the grid in the map.
[[nodiscard]] Eigen::Matrix3d turned_covariance(const Eigen::Matrix3d& covariance,
                                                double angle_rad);

}  // namespace setsquare
