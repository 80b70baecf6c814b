// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/open_spread.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <Eigen/LU>
#include <optional>

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/graph/marginal_covariance.hpp"
#include "setsquare/tracking/open_direction.hpp"

namespace setsquare {
namespace {

/// Of an open direction (sigma).
constexpr double kDirectionSigma_rad = rad_from_deg(1.0);
/// The open directions of a straight corridor differ by less: sigma across over sigma along.
constexpr double kMaxBend = 0.02;
/// No direction is known better than this: a motion that may be off by far along one may be off
/// across by its share. Else the graph, which has such shares as rounding, takes it as not bound.
constexpr double kDirectionRounding = 1e-4;

/// Ways less certain than this are looked at again, by the closures.
constexpr double kLooseWay_m = 0.3;

bool binds_one_axis(const Constraint& constraint) {
  constexpr double kRounding = 1e-9;
  const Eigen::Matrix2d W = constraint.information.topLeftCorner<2, 2>();
  return constraint.kind == ConstraintKind::kLoopClosure &&
         open_direction(W).effective_points < kRounding * W.trace();
}

/// The end of the open stretch that motion `first` is in.
std::size_t end_of_stretch(const KeyframeTrack& track, std::size_t first) {
  std::size_t end = first + 1;
  while (end < track.size() && track.pieces[end] == track.pieces[first] &&
         track.motions[end].open_stretch == track.motions[first].open_stretch) {
    ++end;
  }
  return end;
}

Eigen::Matrix2d with_rounded_direction(const Eigen::Matrix2d& covariance_m2) {
  const SymmetricEigen<2> eigen = symmetric_eigen(covariance_m2);
  const double least_m2 = kDirectionRounding * kDirectionRounding * eigen.values.y();
  if (!(eigen.values.x() < least_m2)) return covariance_m2;
  const Eigen::Vector2d across = eigen.vectors.col(0);
  return covariance_m2 + (least_m2 - eigen.values.x()) * across * across.transpose();
}

/// Adds to the covariances of motions [first, end), of one stretch, what their open direction does.
/// `open_m`: their sigmas in the map frame.
void add_stretch(std::span<const Eigen::Matrix2d> open_m,
                 std::span<Eigen::Matrix2d> covariances_m2) {
  Eigen::Matrix2d whole_m = Eigen::Matrix2d::Zero();
  for (const Eigen::Matrix2d& sigma_m : open_m) whole_m += sigma_m;
  const double share = std::min(1.0, kLargestOpenSigma_m / whole_m.trace());
  whole_m *= share;
  const SymmetricEigen<2> eigen = symmetric_eigen(whole_m);
  const Eigen::Vector2d along = eigen.vectors.col(1);
  const bool is_straight = eigen.values.x() < kMaxBend * eigen.values.y();
  for (std::size_t k = 0; k < open_m.size(); ++k) {
    const double sigma_m = share * open_m[k].trace();
    if (!(sigma_m > 0.0)) continue;
    if (is_straight) {
      covariances_m2[k] += sigma_m * eigen.values.y() * along * along.transpose();
    } else {
      covariances_m2[k] +=
          share * open_m[k] * (open_m[k].cwiseProduct(whole_m).sum() / open_m[k].trace());
    }
    covariances_m2[k] = with_rounded_direction(covariances_m2[k]);
  }
}

/// How far the way between two keyframes may be off, by the tracked motions alone.
class TrackSpread {
 public:
  TrackSpread(const PoseGraph& graph, std::size_t num_motions)
      : covariances_m2_(1, Eigen::Matrix2d::Zero()) {
    for (std::size_t k = 0; k < num_motions; ++k) {
      const Constraint& motion = graph.constraints[k];
      const Eigen::Matrix2d R = rotation_matrix(graph.T_map_node[motion.from].theta_rad);
      const Eigen::Matrix2d W = motion.information.topLeftCorner<2, 2>();
      covariances_m2_.push_back(covariances_m2_.back() + R * W.inverse() * R.transpose());
    }
  }

  /// Covariance in the map frame.
  [[nodiscard]] Eigen::Matrix2d of_way(std::size_t from, std::size_t to) const {
    const auto [low, high] = std::minmax(from, to);
    return covariances_m2_[high] - covariances_m2_[low];
  }

 private:
  std::vector<Eigen::Matrix2d> covariances_m2_;  ///< Of each keyframe's place against the first's.
};

/// Ways by the motions and by what else binds both axes.
MarginalCovariance marginals_without_one_axis(PoseGraph graph) {
  std::erase_if(graph.constraints, binds_one_axis);
  return MarginalCovariance(graph);
}

/// The closure, if it may be off across by so much (m^2).
void loosen(Constraint& closure, const Eigen::Vector2d& open, double variance_m2) {
  const Eigen::Vector3d across(-open.y(), open.x(), 0.0);
  const Eigen::Vector3d bound = closure.information * across;
  closure.information -=
      bound * bound.transpose() * (variance_m2 / (1.0 + variance_m2 * across.dot(bound)));
}

}  // namespace

std::vector<Eigen::Matrix2d> motion_covariances_m2(const KeyframeTrack& track,
                                                   std::span<const double> turn_rad) {
  assert(turn_rad.size() == track.size());
  std::vector<Eigen::Matrix2d> open_m;
  std::vector<Eigen::Matrix2d> covariances_m2;
  for (std::size_t k = 0; k < track.size(); ++k) {
    const MotionCovariance& motion = track.motions[k];
    const Eigen::Matrix2d R = rotation_matrix(turn_rad[k]);
    open_m.push_back(R * motion.open_sigma_m * R.transpose());
    covariances_m2.push_back(
        R * (motion.translation_m2 - motion.open_sigma_m * motion.open_sigma_m) * R.transpose());
  }
  for (std::size_t first = 0; first < track.size();) {
    const std::size_t end = end_of_stretch(track, first);
    add_stretch(std::span(open_m).subspan(first, end - first),
                std::span(covariances_m2).subspan(first, end - first));
    first = end;
  }
  return covariances_m2;
}

void loosen_across(std::size_t num_motions, bool is_by_closures, PoseGraph& graph) {
  const TrackSpread by_track(graph, num_motions);
  std::optional<MarginalCovariance> by_all;
  for (Constraint& closure : graph.constraints) {
    if (!binds_one_axis(closure)) continue;
    const Eigen::Vector2d open =
        open_direction(closure.information.topLeftCorner<2, 2>()).direction;
    const Eigen::Vector2d along = rotation_matrix(graph.T_map_node[closure.from].theta_rad) * open;
    double variance_m2 = along.dot(by_track.of_way(closure.from, closure.to) * along);
    if (is_by_closures && variance_m2 > kLooseWay_m * kLooseWay_m) {
      if (!by_all) by_all.emplace(marginals_without_one_axis(graph));
      variance_m2 = along.dot(by_all->of_way(closure.from, closure.to) * along);
    }
    loosen(closure, open, std::max(0.0, variance_m2) * kDirectionSigma_rad * kDirectionSigma_rad);
  }
}

}  // namespace setsquare
