// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// The audit of a map that is a trajectory and its scans, whoever made it.
///
///   TrajectoryAudit audit;
///   for (...) audit.add(scan, placed);
///   const Map map = audit.finish({}, {}, num_threads);   // map.audit, map.doubts
///
/// Keyframes are the placed scans that moved on by 0.3 m or 10 degrees since the last one of their
/// scanner.
class TrajectoryAudit {
 public:
  /// Throws ParameterError that names the field.
  explicit TrajectoryAudit(const AuditParams& params = {});

  /// The next scan, and where the map has it. Throws ParameterError where the scan's geometry is
  /// not valid.
  void add(const Scan& scan, const MappedScan& placed);

  /// The map of what was added, audited. What is known besides may be empty: pieces of the track,
  /// and stretches along which a direction was open.
  [[nodiscard]] Map finish(std::vector<TrackPiece> pieces,
                           std::vector<OpenStretch> open_stretches,
                           std::size_t num_threads) const;

 private:
  [[nodiscard]] bool has_moved_on(const Scan& scan, const MappedScan& placed) const;

  struct LastKeyframe {
    std::uint32_t scanner = 0;
    Pose2 T_map_sensor;
  };

  AuditParams params_;
  Map map_;
  std::vector<ScanSurfacesPtr> surfaces_;  ///< One per keyframe.
  std::vector<LastKeyframe> last_;         ///< One per scanner.
};

}  // namespace setsquare
