// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// How tracking placed a scan.
enum class TrackStatus {
  kTracked,     ///< The walls determine the pose.
  kDegenerate,  ///< They do not along one direction; there the prediction stands in.
  kRecovered,   ///< Tracking had lost the scan; the search all around found it again.
  kLost,        ///< Not found: the pose is the predicted one.
};

/// "tracked", "degenerate", "recovered" or "lost".
[[nodiscard]] const char* to_string(TrackStatus status);

}  // namespace setsquare
