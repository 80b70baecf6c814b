// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// Which of the map frame's axes a loop closure binds: a corridor leaves one of them open.
enum class ClosureAxes {
  kXY,  ///< Both.
  kX,   ///< That of x alone.
  kY,   ///< That of y alone.
};

/// A place visited twice, as a mapper judged it: scan j seen from scan i. Poses are those of
/// `base`.
struct LoopClosure {
  Timestamp stamp_i;  ///< Of scan i, from which the other is seen.
  Timestamp stamp_j;  ///< Of scan j.
  Pose2 T_i_j;        ///< The pose of j in i; along an axis that is not bound it means nothing.
  ClosureAxes axes = ClosureAxes::kXY;  ///< What of the position it binds; the rotation always.
  bool is_accepted = false;             ///< Verified, so that it entered the pose graph.
  double weight = 0.0;                  ///< Its robust weight in the final graph, 0 to 1.
  std::string reason;                   ///< Why it was accepted or refused, in lower-case words.

  /// Accepted, and then contradicted by all the others: a final weight below one half.
  [[nodiscard]] bool is_outvoted() const { return is_accepted && weight < 0.5; }
};

}  // namespace setsquare
