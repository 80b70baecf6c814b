// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What a map file holds of each struct, field by field: one list for writing and reading, apart
// from map_file that puts the lists into sections.
//
// Each list names all fields of its struct, so that one that is added to the struct is a compile
// error here, not lost without a word. What to do then: the sections of a format stay as they are,
// for maps of it are kept. Put the field behind the others in a section of its own, which older
// files do not have, or begin a new format (map_file.cpp says how).
#pragma once

#include <concepts>
#include <type_traits>

#include "setsquare/io/map_file/archive.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/map/run_record.hpp"

namespace setsquare::map_file {

template <>
inline constexpr auto kLastOf<TrackStatus> = TrackStatus::kLost;
template <>
inline constexpr auto kLastOf<ClosureAxes> = ClosureAxes::kY;
template <>
inline constexpr auto kLastOf<ConstraintKind> = ConstraintKind::kLoopClosure;
template <>
inline constexpr auto kLastOf<DoubtKind> = DoubtKind::kNotSeen;
template <>
inline constexpr auto kLastOf<GyroVerdict> = GyroVerdict::kUnlike;
template <>
inline constexpr auto kLastOf<OdometryVerdict> = OdometryVerdict::kUnlike;
template <>
inline constexpr auto kLastOf<SweepVerdict> = SweepVerdict::kAtOnce;
template <>
inline constexpr auto kLastOf<MountingVerdict> = MountingVerdict::kUnfit;
template <>
inline constexpr auto kLastOf<PoseOf> = PoseOf::kSensor;

/// A struct that is written, or one that is read.
template <typename Value, typename Struct>
concept Is = std::same_as<std::remove_const_t<Value>, Struct>;

template <typename Archive>
void describe(Archive& archive, Is<Timestamp> auto& stamp) {
  auto& [ns] = stamp;
  archive(ns);
}

template <typename Archive>
void describe(Archive& archive, Is<Pose2> auto& pose) {
  auto& [x_m, y_m, theta_rad] = pose;
  archive(x_m, y_m, theta_rad);
}

template <typename Archive>
void describe(Archive& archive, Is<MappedScan> auto& scan) {
  auto& [stamp,
         status,
         is_placed,
         T_map_sensor,
         T_map_base,
         score,
         has_odometry,
         open_sigma_m,
         is_turn_open,
         open_turn_sigma_rad,
         open_turn_motion_m,
         position_sigma_m,
         position_covariance_m2,
         heading_sigma_rad] = scan;
  archive(stamp,
          status,
          is_placed,
          T_map_sensor,
          T_map_base,
          score,
          has_odometry,
          open_sigma_m,
          is_turn_open,
          open_turn_sigma_rad,
          open_turn_motion_m,
          position_sigma_m,
          position_covariance_m2,
          heading_sigma_rad);
}

template <typename Archive>
void describe(Archive& archive, Is<Scan> auto& scan) {
  auto& [stamp,
         first_bearing_rad,
         bearing_step_rad,
         min_range_m,
         max_range_m,
         ranges_m,
         T_base_sensor,
         time_increment_s,
         scan_time_s,
         scanner] = scan;
  archive(stamp, first_bearing_rad, bearing_step_rad, min_range_m, max_range_m);
  archive.ranges(ranges_m);
  archive(T_base_sensor, time_increment_s, scan_time_s, scanner);
}

template <typename Archive>
void describe(Archive& archive, Is<MappedHeading> auto& heading) {
  auto& [tracked_rad, measured_rad, information_per_rad2, weight, frame] = heading;
  archive(tracked_rad, measured_rad, information_per_rad2, weight, frame);
}

template <typename Archive>
void describe(Archive& archive, Is<BuildingFrame> auto& frame) {
  auto& [offset_rad, sigma_rad, support] = frame;
  archive(offset_rad, sigma_rad, support);
}

template <typename Archive>
void describe(Archive& archive, Is<ForgottenPoses> auto& gap) {
  auto& [next_scan, num_scans, way_m] = gap;
  archive(next_scan, num_scans, way_m);
}

template <typename Archive>
void describe(Archive& archive, Is<TrackPiece> auto& piece) {
  auto& [first_scan, num_scans, is_joined] = piece;
  archive(first_scan, num_scans, is_joined);
}

template <typename Archive>
void describe(Archive& archive, Is<SessionSearch> auto& search) {
  auto& [num_pairs, num_matched, num_agreeing] = search;
  archive(num_pairs, num_matched, num_agreeing);
}

template <typename Archive>
void describe(Archive& archive, Is<MapSession> auto& session) {
  auto& [first_scan, num_scans, recency, search] = session;
  archive(first_scan, num_scans, recency, search);
}

template <typename Archive>
void describe(Archive& archive, Is<MotionCovariance> auto& covariance) {
  auto& [translation_m2,
         rotation_rad2,
         open_sigma_m,
         open_stretch,
         slip_sigma_m,
         departure_sigma_m,
         departure_sigma_rad,
         has_odometry,
         is_long_step] = covariance;
  static_cast<void>(departure_sigma_m);  // In a section of their own.
  static_cast<void>(departure_sigma_rad);
  archive(translation_m2,
          rotation_rad2,
          open_sigma_m,
          open_stretch,
          slip_sigma_m,
          has_odometry,
          is_long_step);
}

template <typename Archive>
void describe(Archive& archive, Is<TrackedMotion> auto& motion) {
  auto& [T_odom_body, covariance, stretch, share_of_place] = motion;
  archive(T_odom_body, covariance, stretch, share_of_place);
}

template <typename Archive>
void describe(Archive& archive, Is<MapTrack> auto& track) {
  auto& [T_odom_sensor, motions] = track;
  archive(T_odom_sensor, motions);
}

template <typename Archive>
void describe(Archive& archive, Is<LoopClosure> auto& closure) {
  auto& [stamp_i, stamp_j, T_i_j, axes, is_accepted, weight, reason] = closure;
  archive(stamp_i, stamp_j, T_i_j, axes, is_accepted, weight, reason);
}

template <typename Archive>
void describe(Archive& archive, Is<MappedClosure> auto& mapped) {
  auto& [closure, scan_i, scan_j] = mapped;
  archive(closure, scan_i, scan_j);
}

template <typename Archive>
void describe(Archive& archive, Is<OpenStretch> auto& stretch) {
  auto& [first_scan,
         num_scans,
         way_m,
         duration_s,
         direction_rad,
         has_odometry,
         length_sigma_m,
         is_turn,
         heading_sigma_rad] = stretch;
  archive(first_scan,
          num_scans,
          way_m,
          duration_s,
          direction_rad,
          has_odometry,
          length_sigma_m,
          is_turn,
          heading_sigma_rad);
}

template <typename Archive>
void describe(Archive& archive, Is<UndecidedTurn> auto& turn) {
  auto& [first_scan, last_scan, turned_rad] = turn;
  archive(first_scan, last_scan, turned_rad);
}

template <typename Archive>
void describe(Archive& archive, Is<MappedScanner> auto& mapped) {
  auto& [scanner,
         verdict,
         num_scans,
         num_mapped,
         num_sightings,
         T_base_sensor,
         T_base_seen,
         sigma_rad,
         sigma_m] = mapped;
  archive(scanner,
          verdict,
          num_scans,
          num_mapped,
          num_sightings,
          T_base_sensor,
          T_base_seen,
          sigma_rad,
          sigma_m);
}

template <typename Archive>
void describe(Archive& archive, Is<GyroReport> auto& gyro) {
  auto& [verdict, num_samples, num_turns, scale, scans_late_s, bias_rad_per_s] = gyro;
  archive(verdict, num_samples, num_turns, scale, scans_late_s, bias_rad_per_s);
}

template <typename Archive>
void describe(Archive& archive, Is<OdometryComparison> auto& comparison) {
  auto& [num_compared, scale, deviation] = comparison;
  archive(num_compared, scale, deviation);
}

template <typename Archive>
void describe(Archive& archive, Is<OdometryReport> auto& odometry) {
  auto& [verdict, way, turn, num_ignored, num_jumps, num_carried] = odometry;
  archive(verdict, way, turn, num_ignored, num_jumps, num_carried);
}

template <typename Archive>
void describe(Archive& archive, Is<SweepReport> auto& sweep) {
  auto& [verdict, sweep_s, stated_s, num_turns] = sweep;
  archive(verdict, sweep_s, stated_s, num_turns);
}

template <typename Archive>
void describe(Archive& archive, Is<Constraint> auto& constraint) {
  auto& [from, to, T_from_to, information, kind, weight, source] = constraint;
  archive(from, to, T_from_to, information, kind, weight, source);
}

template <typename Archive>
void describe(Archive& archive, Is<HeadingMeasurement> auto& measurement) {
  auto& [node, heading_rad, information_per_rad2] = measurement;
  archive(node, heading_rad, information_per_rad2);
}

template <typename Archive>
void describe(Archive& archive, Is<PoseGraph> auto& graph) {
  auto& [T_map_node, constraints, headings] = graph;
  archive(T_map_node, constraints, headings);
}

template <typename Archive>
void describe(Archive& archive, Is<AuditReport> auto& audit) {
  auto& [num_pairs, num_matched, num_agreeing, num_contradicting, num_seconded] = audit;
  archive(num_pairs, num_matched, num_agreeing, num_contradicting, num_seconded);
}

template <typename Archive>
void describe(Archive& archive, Is<MapDoubt> auto& doubt) {
  auto& [kind, place_m, first_scan, num_scans, first_stamp, last_stamp, reason] = doubt;
  archive(kind, place_m, first_scan, num_scans, first_stamp, last_stamp, reason);
}

template <typename Archive>
void describe(Archive& archive, Is<RunRecord> auto& run) {
  auto& [version,
         log,
         format,
         sensor,
         scanner_names,
         preset,
         options_json,
         parameters_json,
         findings_json,
         num_damaged_records] = run;
  archive(version,
          log,
          format,
          sensor,
          scanner_names,
          preset,
          options_json,
          parameters_json,
          findings_json,
          num_damaged_records);
}

template <typename Archive>
void describe(Archive& archive, Is<MapRecord> auto& record) {
  auto& [title, pose_of, run] = record;
  archive(title, pose_of, run);
}

}  // namespace setsquare::map_file
