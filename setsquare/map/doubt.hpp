// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <string>

#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// Why a place of a map is in doubt.
enum class DoubtKind {
  kContradictingPairs,  ///< Pairs of scans match otherwise than the map has them.
  kUnknownLength,       ///< The walls left a direction open, and nothing else measured the length.
  kUnjoinedPiece,       ///< A piece of the track could not be joined to the map.
  kOutvotedClosures,    ///< Loop closures that were accepted and then contradicted all others.
  kUndecidedTurn,       ///< The walls turn there: a slip of tracking, or another wing.
  kRefusedOdometry,     ///< The odometry was refused where the walls left a direction open, too.
  kMirrored,            ///< Odometry or gyro turn the other way than the scans, all along.
  kCrossedWalls,        ///< Scans of the same place see through each other's walls over metres.
  kNotClosed,           ///< Loops could not be closed: the map is the track as it was driven.
  kNotSeen,             ///< Many scans in a row that measured nothing: repeated, empty, or lost.
};

/// "contradicting pairs", "unknown length", "piece not joined", "outvoted closures", "undecided
/// turn", "refused odometry", "may be mirrored", "crossed walls", "loops not closed", "not seen".
[[nodiscard]] const char* to_string(DoubtKind kind);

/// A place where the map may be wrong, and why.
struct MapDoubt {
  DoubtKind kind = DoubtKind::kContradictingPairs;    ///< Why it is doubted.
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< Of the robot, in the map frame.
  std::size_t first_scan = 0;                         ///< Of Map::scans.
  std::size_t num_scans = 0;  ///< In doubt, from first_scan on; 0 where it is a single place.
  Timestamp first_stamp;      ///< Of first_scan.
  Timestamp last_stamp;       ///< Of the last of num_scans.
  std::string reason;         ///< A sentence without its full stop.
};

}  // namespace setsquare
