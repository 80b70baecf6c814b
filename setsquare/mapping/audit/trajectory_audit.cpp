// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/trajectory_audit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/mapping/audit/audit.hpp"

namespace setsquare {
namespace {

constexpr double kKeyframeSpacing_m = 0.3;
constexpr double kKeyframeTurn_rad = rad_from_deg(10.0);

}  // namespace

TrajectoryAudit::TrajectoryAudit(const AuditParams& params) : params_(params) {
  params_.validate();
}

void TrajectoryAudit::add(const Scan& scan, const MappedScan& placed) {
  scan.validate();
  const std::size_t index = map_.scans.size();
  map_.scans.push_back(placed);
  if (!placed.is_placed || placed.status == TrackStatus::kLost) return;
  if (!has_moved_on(scan, placed)) return;
  std::erase_if(last_, [&](const LastKeyframe& last) { return last.scanner == scan.scanner; });
  last_.push_back({scan.scanner, placed.T_map_sensor});
  map_.keyframes.push_back(index);
  surfaces_.push_back(scan_surfaces(scan));
}

bool TrajectoryAudit::has_moved_on(const Scan& scan, const MappedScan& placed) const {
  const auto last = std::ranges::find(last_, scan.scanner, &LastKeyframe::scanner);
  if (last == last_.end()) return true;
  const Pose2 moved = last->T_map_sensor.inverse() * placed.T_map_sensor;
  return moved.translation().norm() > kKeyframeSpacing_m ||
         std::abs(moved.theta_rad) > kKeyframeTurn_rad;
}

Map TrajectoryAudit::finish(std::vector<TrackPiece> pieces,
                            std::vector<OpenStretch> open_stretches,
                            std::size_t num_threads) const {
  Map map = map_;
  map.pieces = std::move(pieces);
  map.open_stretches = std::move(open_stretches);
  audit_map(map, surfaces_, params_, num_threads);
  return map;
}

}  // namespace setsquare
