// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/surfaces/alignment.hpp"

namespace setsquare {

/// How one scan's wall falls on the other's surfaces, in metres. Unlike Evidence it asks why a
/// piece is hidden, and how well one agrees.
struct WallKinds {
  double wall_m = 0.0;
  double tight_m = 0.0;         ///< On the surface to 4 cm, facing the same way.
  double loose_m = 0.0;         ///< To 15 cm.
  double clutter_m = 0.0;       ///< To 15 cm, but of something without a line.
  double contradicted_m = 0.0;  ///< Where the other scan saw through.
  double hidden_m = 0.0;        ///< Behind a surface that agrees itself.
  double unexplained_m = 0.0;   ///< Behind a surface that does not.
  double outside_m = 0.0;       ///< Outside the other's view, or where no beam came back.

  WallKinds& operator+=(const WallKinds& other);
};

/// The current scan's wall on the reference, and the reference's on the current scan.
struct TwoWayKinds {
  WallKinds forward;
  WallKinds backward;
};

[[nodiscard]] TwoWayKinds wall_kinds(const AlignedScan& reference,
                                     const AlignedScan& current,
                                     const Pose2& T_reference_current);

}  // namespace setsquare
