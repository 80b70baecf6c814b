// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/known_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace setsquare {
namespace {

/// Some of the keyframes of a piece, each seen from the one of the map's that is nearest to it.
std::vector<ComparedPlaces> joints_of_piece(std::span<const AnchoredKeyframe> map,
                                            std::span<const AnchoredKeyframe> piece,
                                            const PieceJoiningParams& params) {
  constexpr std::size_t kNumJoints = 5;
  std::vector<ComparedPlaces> joints;
  for (std::size_t i = 0; i < piece.size(); i += 1 + (piece.size() - 1) / kNumJoints) {
    const AnchoredKeyframe& sought = piece[i];
    const auto distance_m = [&](const AnchoredKeyframe& other) {
      return (other.T_map_sensor.translation() - sought.T_map_sensor.translation()).norm();
    };
    const AnchoredKeyframe& nearest = *std::ranges::min_element(map, {}, distance_m);
    joints.push_back(matched_places(nearest.keyframe,
                                    sought.keyframe,
                                    nearest.T_map_sensor.inverse() * sought.T_map_sensor,
                                    information_of_joint(params)));
  }
  return joints;
}

}  // namespace

Eigen::Matrix3d information_of_joint(const PieceJoiningParams& params,
                                     std::optional<double> open_direction_rad) {
  const double per_m2 = 1.0 / (params.joint_sigma_m * params.joint_sigma_m);
  const double per_rad2 = 1.0 / (params.joint_sigma_rad * params.joint_sigma_rad);
  Eigen::Matrix3d information = Eigen::Vector3d(per_m2, per_m2, per_rad2).asDiagonal();
  if (open_direction_rad) {
    const Eigen::Vector2d open(std::cos(*open_direction_rad), std::sin(*open_direction_rad));
    const double open_per_m2 = 1.0 / (params.joint_open_sigma_m * params.joint_open_sigma_m);
    information.topLeftCorner<2, 2>() -= (per_m2 - open_per_m2) * open * open.transpose();
  }
  return information;
}

void lay_known(std::span<const AnchoredKeyframe> known, std::span<Pose2> T_here_sensor) {
  if (known.empty()) return;
  const auto& [first, T_map_first] = known.front();
  const Pose2 T_here_map = T_here_sensor[first] * T_map_first.inverse();
  for (const auto& [k, T_map_k] : known) T_here_sensor[k] = T_here_map * T_map_k;
}

std::vector<std::vector<ComparedPlaces>> known_joints(const KeyframeTrack& track,
                                                      std::span<const AnchoredKeyframe> known,
                                                      const PieceJoiningParams& params) {
  std::vector<std::vector<ComparedPlaces>> joints;
  std::size_t begin = 0;  // Of a piece.
  while (begin < known.size()) {
    std::size_t end = begin;
    const std::size_t piece = track.pieces[known[begin].keyframe];
    while (end < known.size() && track.pieces[known[end].keyframe] == piece) ++end;
    if (begin > 0) {
      joints.push_back(
          joints_of_piece(known.first(begin), known.subspan(begin, end - begin), params));
    }
    begin = end;
  }
  return joints;
}

}  // namespace setsquare
