// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/doubt.hpp"

namespace setsquare {

const char* to_string(DoubtKind kind) {
  switch (kind) {
    case DoubtKind::kContradictingPairs:
      return "contradicting pairs";
    case DoubtKind::kUnknownLength:
      return "unknown length";
    case DoubtKind::kUnjoinedPiece:
      return "piece not joined";
    case DoubtKind::kOutvotedClosures:
      return "outvoted closures";
    case DoubtKind::kUndecidedTurn:
      return "undecided turn";
    case DoubtKind::kRefusedOdometry:
      return "refused odometry";
    case DoubtKind::kMirrored:
      return "may be mirrored";
    case DoubtKind::kCrossedWalls:
      return "crossed walls";
    case DoubtKind::kNotClosed:
      return "loops not closed";
    case DoubtKind::kNotSeen:
      return "not seen";
  }
  return "unknown";
}

}  // namespace setsquare
