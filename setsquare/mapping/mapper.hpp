// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

struct MapperParams;  // setsquare/mapping/mapper_params.hpp; every default works.

/// Scans in, map out.
///
///   Mapper mapper;
///   for (const Scan& scan : log) mapper.add(scan);
///   const Map map = mapper.finish();
///
/// 1. Track: each scan is placed against the submap of recent keyframes (ScanTracker).
/// 2. Headings: each keyframe's walls measure its heading in the building, modulo a quarter turn;
///    fused with the tracked rotations they do not drift (fuse_headings).
/// 3. Loops: as the track grows, places near each other are compared, headings known (LoopCloser),
///    and positions solved, a linear problem (solve_positions).
/// 4. At the end: pieces of track between which tracking was lost are joined where they overlap
///    (join_pieces); weights of the closures by graduated non-convexity (solve_robustly), all
///    keyframes registered with their neighbours (register_keyframes), scans laid out between them
///    (assemble_track). Loops behind bare corridors are closed wherever they lie
///    (closures_anywhere), and the map is audited (MapMaker).
/// The map's axes are the building's. Memory grows with the log by a pose and its evidence for
/// every scan; the scans that Map::kept_scans names, and all else, grow with the building:
/// keyframes of places that several visits have covered are forgotten where they show nothing new
/// (ForgettingParams).
class Mapper {
 public:
  /// With every parameter at its default.
  Mapper();
  /// Throws ParameterError that names the field.
  explicit Mapper(const MapperParams& params);
  /// Goes on with a map: the scans that come are of another log, and the robot may stand anywhere.
  /// What was tracked of it is a piece of track like those between which tracking was lost: it is
  /// joined to the map where the two overlap, and stays apart until then (MapSession, TrackPiece).
  /// What its sessions show that earlier ones of them cover is forgotten first (ForgettingParams).
  /// All loops are closed anew; the map's axes and origin stay. Stamps of the two need not be in
  /// order. Where walls changed, what came later is newer. Throws ParameterError that names the
  /// field, or where the map does not tell its track (PaperMapper).
  explicit Mapper(const Map& map);
  Mapper(const Map& map, const MapperParams& params);  ///< The same, by these parameters.
  /// Ends it; maps that it gave stay.
  ~Mapper();
  /// Leaves the other without parts: it may only be assigned to or ended.
  Mapper(Mapper&&) noexcept;
  /// The same.
  Mapper& operator=(Mapper&&) noexcept;

  /// The next scan of the log, with the robot's pose by wheel odometry where the log has one. Scans
  /// of several scanners, each with its mounting and its number (Scan::scanner), come in the order
  /// of time. Those of a further scanner are left out of the map until its mounting has been
  /// confirmed (MappedScanner): TrackedPose::is_mapped says so.
  /// A scan that says how long it swept (Scan::time_increment_s) is deskewed; its pose is that of
  /// the middle of its sweep. Where a scanner that spins does not say so, or says something else
  /// than the walls show, its sweep time is found from the first turns (Map::sweep), and what came
  /// before is mapped again: poses that were returned for it were provisional. The same goes for
  /// what came before the scans refuted the odometry (Map::odometry). Throws ParameterError where
  /// the scan's geometry is not valid (Scan::validate) or a pose is not finite.
  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);

  /// A sample of a gyro: how fast the robot turns, counterclockwise seen from above. In the order
  /// of time with the scans. Helps where there is no odometry; one that does not turn as the scans
  /// show is ignored (Map::gyro).
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s);

  /// The map of all scans so far; more may follow.
  [[nodiscard]] Map finish() const;

  /// Scans mapped.
  [[nodiscard]] std::size_t num_scans() const;

 private:
  class Parts;  ///< Hidden, so that the parts' headers cost the caller nothing.
  std::unique_ptr<Parts> parts_;
};

/// One map of several, in the frame of the first: each is a piece of track, or several, and is
/// joined where it overlaps with what is joined already, as Mapper goes on with a map. What they
/// share, a log that both were made of, counts once. One that shares no place with the first stays
/// apart: is_joined(map, session) tells, and MapSession::search why. Where walls changed, the map
/// whose stamps are later is the newer, or, where their times overlap, the one that is named later.
/// Throws ParameterError, also where there is no map, or one does not tell its track (PaperMapper).
[[nodiscard]] Map merge(std::span<const Map> maps);
/// The same, by these parameters.
[[nodiscard]] Map merge(std::span<const Map> maps, const MapperParams& params);

}  // namespace setsquare
