// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only user, because that is long enough.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/surfaces/surface_samples.hpp"
#include "setsquare/tracking/agreed_place.hpp"
#include "setsquare/tracking/deskew.hpp"
#include "setsquare/tracking/prepared_keyframes.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/sweep_turns.hpp"

namespace setsquare {

/// The scan that is being placed. Its image is made when it is first asked for: most scans are
/// neither recovered nor kept.
class ArrivedScan {
 public:
  ArrivedScan(const Scan& scan, const ScanTrackerParams& params)
      : scan_(scan),
        params_(params),
        sweep_s_(params.deskew.is_on ? sweep_time_s(scan) : 0.0),
        points_(surface_points_from_scan(scan, params.surfaces)) {}

  /// As it came.
  [[nodiscard]] const Scan& arrived() const { return scan_; }
  /// As it is placed.
  [[nodiscard]] const Scan& scan() const { return deskewed_ ? deskewed_->scan : scan_; }
  /// 0 where it is not deskewed.
  [[nodiscard]] double sweep_s() const { return sweep_s_; }
  void deskew(const SweepMotion& motion) {
    motion_ = motion;
    deskewed_ = deskewed(scan_, motion, params_.surfaces);
    points_ = surface_points_from_scan(deskewed_->scan, params_.surfaces);
    surfaces_.reset();
    votes_.reset();
  }
  /// Of the deskewed scan.
  [[nodiscard]] PlacedSweep placed_at(const Pose2& T_odom_sensor, const SweepMotion& motion) const {
    return {points(), deskewed_->share, T_odom_sensor, motion};
  }
  [[nodiscard]] const SweepMotion& motion() const { return motion_; }
  [[nodiscard]] std::optional<Scan> take_deskewed() {
    return deskewed_ ? std::optional<Scan>(std::move(deskewed_->scan)) : std::nullopt;
  }

  [[nodiscard]] std::size_t num_points() const { return points().size(); }
  [[nodiscard]] SurfaceSamples all_points() const {
    return sample_surface(points(), points().size());
  }
  [[nodiscard]] const ScanSurfacesPtr& surfaces() {
    if (!surfaces_) surfaces_ = scan_surfaces(scan(), std::move(points_), params_.image);
    return surfaces_;
  }
  /// Of the submap's keyframes: found once, however often they are asked for.
  [[nodiscard]] const std::vector<PlaceVote>& votes(PreparedKeyframes& keyframes) {
    if (!votes_) votes_ = place_votes(keyframes, prepare(surfaces()), params_.votes);
    return *votes_;
  }

 private:
  [[nodiscard]] const SurfacePoints& points() const {
    return surfaces_ ? surfaces_->points : points_;
  }

  const Scan& scan_;
  const ScanTrackerParams& params_;
  double sweep_s_ = 0.0;
  SweepMotion motion_;
  std::optional<DeskewedScan> deskewed_;
  SurfacePoints points_;  ///< Until they are part of the surfaces.
  ScanSurfacesPtr surfaces_;
  std::optional<std::vector<PlaceVote>> votes_;
};

}  // namespace setsquare
