// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What a map is: the data that a mapper returns and that files, reports and the command are made
// of.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/grid/grid_with_changes.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/grid/placed_scan.hpp"
#include "setsquare/map/audit_report.hpp"
#include "setsquare/map/doubt.hpp"
#include "setsquare/map/gyro_report.hpp"
#include "setsquare/map/map_track.hpp"
#include "setsquare/map/mapped_scanner.hpp"
#include "setsquare/map/odometry_report.hpp"
#include "setsquare/map/sweep_report.hpp"
#include "setsquare/map/track_status.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A scan in the map.
struct MappedScan {
  Timestamp stamp;                             ///< As the log has it.
  TrackStatus status = TrackStatus::kTracked;  ///< How tracking placed it.
  bool is_placed = true;  ///< False in a piece of track that could not be joined to the map.
  /// Pose of its sensor at the middle of its sweep, in the map; in the piece's own frame where it
  /// is not placed.
  Pose2 T_map_sensor;
  Pose2 T_map_base;           ///< Pose of the robot at the same moment, in the same frame.
  double score = 0.0;         ///< See TrackedPose; the paper's product of ZNCCs by PaperMapper.
  bool has_odometry = false;  ///< Whether odometry predicted it.
  /// How far off the motion from the last scan may be (sigma), along the direction in the map that
  /// the walls leave open; zero where they leave none.
  Eigen::Vector2d open_sigma_m = Eigen::Vector2d::Zero();
  /// Whether the walls leave its turn open, as those of an empty round hall do: all face its
  /// middle.
  bool is_turn_open = false;
  double open_turn_sigma_rad = 0.0;  ///< How far off the turn from the last scan may be, then, ...
  /// ... and how a turn by 1 rad moves the sensor in the map: what a turn about the middle does.
  Eigen::Vector2d open_turn_motion_m = Eigen::Vector2d::Zero();
  /// Standard deviation of the position along its least certain direction, against the first
  /// keyframe of the map; infinite where it is not placed, NaN where there is no graph.
  double position_sigma_m = std::numeric_limits<double>::quiet_NaN();
  /// The position's covariance in the map frame, against the same keyframe. Infinite and NaN alike,
  /// on its diagonal.
  Eigen::Matrix2d position_covariance_m2 =
      std::numeric_limits<double>::quiet_NaN() * Eigen::Matrix2d::Identity();
  /// Standard deviation of the heading, against the building's walls where they were surely known
  /// again, else against the first keyframe; pi / sqrt(3) where nothing is known of it. Infinite
  /// and NaN as the position's.
  double heading_sigma_rad = std::numeric_limits<double>::quiet_NaN();
};

/// A whole scan that the map keeps to draw walls with. That of a keyframe shares the keyframe's
/// memory.
struct KeptScan {
  std::size_t index = 0;             ///< Of Map::scans.
  std::shared_ptr<const Scan> scan;  ///< Never null.
};

/// A pair of places that was compared, with the scans that it is about.
struct MappedClosure {
  LoopClosure closure;     ///< By stamps, poses of `base`.
  std::size_t scan_i = 0;  ///< Index of Map::scans.
  std::size_t scan_j = 0;  ///< Index of Map::scans.
};

/// A place in the order of the scans at which scans of known ground are left out.
struct ForgottenPoses {
  std::size_t next_scan = 0;  ///< Index of Map::scans: the first behind them.
  std::size_t num_scans = 0;  ///< That are left out.
  double way_m = 0.0;         ///< Travelled from the scan before them to the one behind.
};

/// A part of the track that tracking holds together.
struct TrackPiece {
  std::size_t first_scan = 0;  ///< Index of Map::scans.
  std::size_t num_scans = 0;   ///< Of the piece, one after the other.
  bool is_joined = true;  ///< To the largest piece; otherwise its place in the map is not known.
};

/// A stretch along which the scans left one direction open, a bare corridor, or the turn, a round
/// hall.
struct OpenStretch {
  std::size_t first_scan = 0;   ///< Index of Map::scans.
  std::size_t num_scans = 0;    ///< Of the stretch, one after the other.
  double way_m = 0.0;           ///< Travelled meanwhile, as far as is known.
  double duration_s = 0.0;      ///< From its first scan to its last.
  double direction_rad = 0.0;   ///< The open direction in the map frame, modulo pi.
  bool has_odometry = false;    ///< Whether odometry stood in all along.
  double length_sigma_m = 0.0;  ///< Standard deviation of its length, given all other measurements.
  bool is_turn = false;         ///< The turn is open, not a direction: a round hall.
  double heading_sigma_rad = 0.0;  ///< Of its least certain scan, where the turn is open.
};

/// Scans between which the building's walls turn against the tracked rotation, and no match of
/// scans tells whether tracking slipped there or walls of another wing begin.
struct UndecidedTurn {
  std::size_t first_scan = 0;  ///< Index of Map::scans: before the turn.
  std::size_t last_scan = 0;   ///< Index of Map::scans: after it.
  /// By how much the walls turn against the tracked rotation, counterclockwise.
  double turned_rad = 0.0;
};

/// The heading of one keyframe's sensor, in rad in the map frame.
struct MappedHeading {
  double tracked_rad = 0.0;  ///< By tracking alone, drift included.
  /// Against the building's walls, near the heading in the map; nothing where no wall has weight.
  std::optional<double> measured_rad;
  double information_per_rad2 = 0.0;  ///< Of the measurement, robust weight included.
  double weight = 0.0;                ///< Weight of the measurement, 0 to 1.
  std::size_t frame = 0;              ///< Whose walls were measured: index of Map::frames.
};

/// A part of the building whose walls are square to each other: a wing.
struct BuildingFrame {
  double offset_rad = 0.0;  ///< Of its walls against those of the main frame, modulo 90 degrees.
  double sigma_rad = 0.0;   ///< Standard deviation of the offset; 0 of the main frame.
  double support = 0.0;     ///< Keyframes that see it, each counted by its confidence.
};

/// What a mapper knows. The map's axes are those of the building's main frame.
struct Map {
  /// The scans that were mapped, in the order in which they came: all, but for forgotten_poses.
  std::vector<MappedScan> scans;
  std::vector<std::size_t> keyframes;       ///< Indices of scans.
  std::vector<MappedHeading> headings;      ///< One per keyframe; none by PaperMapper.
  std::vector<BuildingFrame> frames;        ///< The main one first; none by PaperMapper.
  std::vector<TrackPiece> pieces;           ///< One where tracking was never lost for long.
  std::vector<MapSession> sessions;         ///< One where a single log was mapped.
  MapTrack track;                           ///< What tracking found, to go on with.
  std::vector<MappedClosure> closures;      ///< Accepted and refused; none by PaperMapper.
  std::vector<OpenStretch> open_stretches;  ///< Bare corridors and round halls, in the map's order.
  std::vector<UndecidedTurn> undecided_turns;  ///< In the map's order; empty by PaperMapper.
  std::vector<MappedScanner> scanners;         ///< As they came; none by PaperMapper.
  GyroReport gyro;                             ///< What became of its samples, if there were any.
  OdometryReport odometry;                     ///< Whether it moved as the scans show.
  SweepReport sweep;                           ///< How long the leading scanner takes for a scan.
  std::size_t num_with_odometry = 0;           ///< Scans that came with a pose by wheel odometry.
  /// Keyframes of places seen before that showed nothing new: they are not among `keyframes`.
  std::size_t num_forgotten = 0;
  /// Where scans of known ground are left out, in the map's order: between such keyframes, and
  /// whole sessions of a map that was gone on with. Of one log nowhere unless asked for
  /// (ForgettingParams::max_known_poses).
  std::vector<ForgottenPoses> forgotten_poses;
  /// Poses of `base` at the keyframes, the motion between them, the accepted closures with their
  /// weights, the headings measured; empty by PaperMapper.
  PoseGraph graph;
  /// The keyframes, and the scans that moved on by 0.1 m or 5 degrees since the last one kept.
  std::vector<KeptScan> kept_scans;
  std::optional<AuditReport> audit;  ///< Nothing where the map was not audited.
  std::vector<MapDoubt> doubts;      ///< Where it may be wrong; empty where it was not audited.
};

/// Throws ParameterError where parts of a map do not belong together: an index names nothing, the
/// pieces hold more scans than there are, a pose is not finite, a kept scan is absent or invalid.
void validate(const Map& map);

/// A heading whose standard deviation is above this is told to be open.
inline constexpr double kOpenHeading_rad = rad_from_deg(5.0);

/// Whether no step leads to a scan from the one before: it is the first of a session that follows
/// another one, or the first behind scans that are left out.
[[nodiscard]] bool begins_anew(const Map& map, std::size_t scan);

/// Whether a part of the session has its place in the map.
[[nodiscard]] bool is_joined(const Map& map, const MapSession& session);

/// Whose poses a trajectory holds.
enum class PoseOf {
  kBase,    ///< The robot's.
  kSensor,  ///< Its scanner's.
};

/// The poses of the scans that are placed, in the order in which they came.
[[nodiscard]] Trajectory trajectory_of(const Map& map, PoseOf pose_of = PoseOf::kBase);

/// Those of one piece, joined or not: else in a frame of its own.
[[nodiscard]] Trajectory trajectory_of(const Map& map,
                                       const TrackPiece& piece,
                                       PoseOf pose_of = PoseOf::kBase);

/// The closures both of whose scans are placed: those that the map shows and counts.
[[nodiscard]] std::vector<MappedClosure> closures_of_placed(const Map& map);

/// The closures without the scans, accepted and refused.
[[nodiscard]] std::vector<LoopClosure> closures_of(const Map& map);

/// The kept scans that show walls, where they were taken; lost ones, and those that are not placed,
/// are left out: they would smear the walls. Each has the recency of its session. The map must
/// outlive them.
[[nodiscard]] std::vector<PlacedScan> placed_scans(const Map& map);
/// Not of a map that ends with the expression: the scans are the map's.
std::vector<PlacedScan> placed_scans(Map&&) = delete;
/// Those of the keyframes alone.
[[nodiscard]] std::vector<PlacedScan> placed_keyframes(const Map& map);
std::vector<PlacedScan> placed_keyframes(Map&&) = delete;  ///< As placed_scans().

/// The occupancy grid of placed_scans(). `grid_heading_rad`: direction of its rows in the map
/// frame. Any number of threads gives the same grid. Takes a good part of the time that mapping
/// takes.
[[nodiscard]] OccupancyGrid occupancy_grid(const Map& map,
                                           int num_threads = 1,
                                           double grid_heading_rad = 0.0);

/// The same, and where walls changed from session to session (ChangedCells).
[[nodiscard]] GridWithChanges occupancy_grid_with_changes(const Map& map,
                                                          int num_threads = 1,
                                                          double grid_heading_rad = 0.0);

}  // namespace setsquare
