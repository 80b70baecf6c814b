// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace setsquare::app {

/// What a file of ground truth holds.
enum class ReferenceKind { kRelations, kTrajectory };

/// Tells the two apart by their content, for both are eight numbers a line: a trajectory (TUM)
/// where the last four of every line are a unit quaternion, relations where those of at most half
/// the lines are. Throws FileError; FormatError where a line is not eight numbers, or where it is
/// neither.
[[nodiscard]] ReferenceKind reference_kind(const std::string& path);

}  // namespace setsquare::app
