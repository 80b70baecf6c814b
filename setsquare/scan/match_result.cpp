// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/match_result.hpp"

#include <cmath>

#include "setsquare/core/symmetric_eigen.hpp"

namespace setsquare {

std::string_view to_string(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return "matched";
    case MatchStatus::kAmbiguous:
      return "ambiguous";
    case MatchStatus::kDegenerate:
      return "degenerate";
    case MatchStatus::kNoOverlap:
      return "no_overlap";
    case MatchStatus::kTooFewPoints:
      return "too_few_points";
    case MatchStatus::kRejected:
      return "rejected";
  }
  return "unknown";
}

std::optional<PoseSigmas> marginal_sigmas(const MatchResult& result) {
  const Eigen::Vector3d diagonal = result.information.diagonal();
  if (!(diagonal.minCoeff() > 0.0)) return std::nullopt;
  // Metres and radians are made comparable before the smallest eigenvalue is judged.
  constexpr double kSingular = 1e-9;
  const Eigen::Vector3d scale = diagonal.cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d scaled = scale.asDiagonal() * result.information * scale.asDiagonal();
  const SymmetricEigen<3> eigen = symmetric_eigen(scaled);
  if (!(eigen.values(0) > kSingular)) return std::nullopt;
  const Eigen::Vector3d inverse_diagonal = eigen.vectors.cwiseAbs2() * eigen.values.cwiseInverse();
  const Eigen::Vector3d sigmas = inverse_diagonal.cwiseSqrt().cwiseProduct(scale);
  return PoseSigmas{sigmas.x(), sigmas.y(), sigmas.z()};
}

}  // namespace setsquare
