// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Parameters of this folder's steps, in their order.
#pragma once

#include <cstddef>
#include <cstdint>

#include "setsquare/core/angle.hpp"

namespace setsquare {

/// Parameters of straight_pieces.
struct StraightPieceParams {
  double max_gap_m = 0.2;      ///< Neighbouring returns further apart may part two surfaces.
  double max_gap_beams = 8.0;  ///< Nor nearer than this many steps of the beams' fan there.
  std::int32_t max_skipped_beams = 2;  ///< Beams without a return inside a piece.
  double min_tolerance_m = 0.05;       ///< Furthest that a point may lie off its piece ...
  double max_tolerance_m = 0.15;       ///< ... in between: this many times the scan's noise.
  double tolerance_per_noise = 4.0;    ///< Noise as surface_noise_m measures it.
  std::int32_t min_num_points = 3;     ///< Of a piece.
};

/// Parameters of square_directions. Angles in rad.
struct SquareDirectionParams {
  StraightPieceParams pieces = {};     ///< How returns are joined to straight pieces.
  std::size_t max_num_peaks = 3;       ///< Directions proposed.
  double min_separation_rad = 0.0873;  ///< Between two of them (5 deg).
  double density_width_rad = 0.0122;   ///< Standard deviation that smooths the pieces' directions.
  double min_rms_m = 0.006;            ///< A line's points are never trusted more than this.
  double wall_sigma_rad = 0.002;       ///< How far walls of one building are from square.
  double inlier_rad = 0.06;            ///< Scale at which a piece's weight has fallen to 1/4.
  double min_pair_distance_m = 0.5;    ///< Along the wall, between two pieces of one line.
  double pair_sigma_m = 0.01;          ///< Of the offset between two pieces of one line.
  double pair_inlier_m = 0.06;         ///< Offset at which a pair's weight has fallen to 1/4.
  double pair_weight = 3.0;            ///< Of a pair, relative to a piece of the same precision.
  std::size_t max_num_paired = 64;     ///< Pieces that are paired, the longest.

  /// Throws ParameterError where a field is outside its domain.
  void validate() const;
};

/// Parameters of trace_headings. Costs are in keyframes: passing by a proposal of full confidence
/// costs 1.
struct HeadingTraceParams {
  double period_rad = 0.5 * kPi;          ///< Of the proposals.
  double bin_rad = rad_from_deg(0.5);     ///< Of the offset; divides the period.
  double inlier_rad = rad_from_deg(2.0);  ///< A proposal farther off than this is ignored.
  double drift_cost = 0.25;               ///< Of drift, for each standard deviation of the step.
  double min_step_sigma_rad = rad_from_deg(0.15);       ///< No step is more certain than this ...
  double min_confirmed_sigma_rad = rad_from_deg(0.06);  ///< ... but for those that are confirmed.
  /// In standard deviations. A larger move that also exceeds min_change_rad is never drift,
  /// whatever its cost: where one scan was lost the walls may turn by 45 deg, but an unseen robot
  /// may not.
  double max_drift_sigmas = 4.0;
  /// A smaller move is drift, however certain the step.
  double min_change_rad = rad_from_deg(10.0);
  double change_cost = 6.0;  ///< Of a change of frame, however large.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of find_heading_frames.
struct HeadingFramesParams {
  /// A smaller jump that is not soon undone is no change of frame, but a slip of tracking.
  double min_separation_rad = rad_from_deg(14.0);
  std::size_t max_excursion = 60;             ///< Keyframes until which a jump is undone soon.
  double same_frame_rad = rad_from_deg(4.0);  ///< A frame seen again comes out this near.
  double min_slip_rad = rad_from_deg(2.5);    ///< A smaller jump is noise of the trace.
  /// Keyframes, each counted by its confidence: support that a piece needs to count ...
  double min_support = 8.0;
  /// ... and their share of all its keyframes. Where no piece has both, the best supported counts.
  double min_share = 0.25;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of doubted_turns.
struct DoubtedTurnParams {
  std::size_t num_steps = 10;               ///< In which the drift has turned ...
  double min_rad = rad_from_deg(1.5);       ///< ... by this, ...
  double min_sigmas = 4.0;                  ///< ... and by so many times what tracking may err.
  double min_sure = 0.9;                    ///< Two neighbours so sure of their walls ...
  double min_sure_rad = rad_from_deg(3.0);  ///< ... differ by this.
  std::size_t max_margin = 30;  ///< Keyframes to either side until walls are seen again.
  double min_belief = 0.5;      ///< Of a proposal that shows them.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of fuse_headings. Angles in rad.
struct HeadingFusionParams {
  HeadingTraceParams trace = {};                  ///< How proposals are joined to a trace.
  HeadingFramesParams frames = {};                ///< How wings are told apart.
  DoubtedTurnParams doubt = {};                   ///< Which turns are asked about.
  double building_sigma_rad = rad_from_deg(0.3);  ///< Of a proposal, in addition to its own sigma.
  double inlier_rad = rad_from_deg(1.0);  ///< Residual at which a proposal's weight falls to 1/4.
  int num_iterations = 30;                ///< Of reweighting.
  /// Neighbouring keyframes see the same walls, so their errors are correlated: this many of them
  /// count as one measurement in the standard deviations.
  double num_alike = 6.0;

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
