// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// Parameters of solve_robustly. A separate header, so that MapperParams need not include the
/// solver.
struct RobustPoseGraphParams {
  /// Squared error beyond which a closure that binds both axes is taken for wrong: chi-squared of
  /// two degrees of freedom. One that binds a single axis has the threshold that chi-squared of one
  /// degree exceeds as rarely (12.9 for 16; one right closure in 3000).
  double max_squared_error = 16.0;
  /// Closures that are nearer to each other along the track, at both ends, and tell the same stand
  /// or fall together: two of the mapper's stations. With 0 each closure stands alone.
  double place_m = 3.0;
  double mu_growth = 1.4;   ///< Factor from step to step of the graduation: mu grows by it.
  int max_iterations = 60;  ///< Of a graduation; the step is longer where it would need more.

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
