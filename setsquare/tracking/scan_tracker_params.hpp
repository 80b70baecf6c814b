// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/scan/few_beams.hpp"
#include "setsquare/surfaces/surface_params.hpp"

namespace setsquare {

/// How point-to-line distances count.
struct AlignmentScale {
  double gate_m = 0.15;   ///< Farther points have no part.
  double scale_m = 0.05;  ///< Distance at which a point's weight has fallen to 1/4 (Geman-McClure).

  /// Throws ParameterError that names the field as one of `owner`.
  void validate(const std::string& owner) const;
};

/// Parameters of ScanGap: which pauses of a log are gaps.
struct ScanGapParams {
  double min_gap_s = 3.0;        ///< A pause between two scans as long as this, and ...
  double min_num_periods = 5.0;  ///< ... as this many usual ones, is a gap in the log ...
  double same_range_m = 0.1;     ///< ... unless ranges that differ by less than this, ...
  double min_same = 0.8;  ///< ... in this share of the beams, show that the robot stood still.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of Gyro.
struct GyroParams {
  double max_pause_s = 0.25;                ///< Between samples; longer ones leave a gap.
  double stretch_s = 0.5;                   ///< Of each comparison with the scans' turns.
  std::size_t num_stretches = 200;          ///< The latest, by which it is judged.
  std::size_t min_turns = 8;                ///< Of these, with a turn of more than ...
  double min_turn_rad = rad_from_deg(5.0);  ///< ... this.
  double max_rest_rad = rad_from_deg(1.0);  ///< With a smaller turn the robot does not turn.
  double max_deviation = 0.25;              ///< Median of the ratios', as a share of the scale.
  double scale_factor = 1.25;               ///< The scale may be off by this.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of OdometryTrial.
struct OdometryTrialParams {
  bool is_on = true;                        ///< Else odometry is believed as it comes.
  double stretch_m = 0.3;                   ///< A stretch is compared once it is as long as this,
  double stretch_rad = rad_from_deg(10.0);  ///< or turns by this.
  double min_way_m = 0.15;                  ///< Shorter ways ...
  double min_turn_rad = rad_from_deg(5.0);  ///< ... and smaller turns say nothing.
  double min_score = 0.6;                   ///< Of scans that are certain, ...
  double min_effective_points = 10.0;       ///< ... in their least certain direction.
  std::size_t num_stretches = 20;           ///< The latest, by which it is judged, ...
  std::size_t min_stretches = 5;            ///< ... from this many on.
  double still_share = 0.1;                 ///< Of the motion: less is standing still.
  double max_deviation = 0.35;              ///< Median, as a share of the motion.
  double usual_scale = 1.1;                 ///< A scale off by less is not mended.
  double largest_scale = 2000.0;            ///< One off by more is none.
  double proved_deviation = 0.1;            ///< Of odometry that has proved true: a step is off ...
  double proved_sigmas = 5.0;               ///< ... by so many standard deviations at most, or ...
  double least_reach_m = 0.15;              ///< ... by this, ...
  double least_reach_rad = rad_from_deg(5.0);      ///< ... and turned by this.
  double wheels_at_rest_m = 0.6;                   ///< Where the wheels moved by less than this ...
  double wheels_at_rest_rad = rad_from_deg(30.0);  ///< ... and this, what was seen is seen again.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// How far a prediction is trusted along a direction that the walls leave free.
struct PredictionTrust {
  double weight = 2.0;    ///< Of each effective point that is missing.
  double sigma_m = 0.15;  ///< How far off it is taken to be.
  double min_gain = 0.0;  ///< Closeness that a place elsewhere along the corridor must gain.

  /// Throws ParameterError that names the field. `name`: of this trust among others.
  void validate(const std::string& name) const;
};

/// Parameters of open_turn: for halls whose walls all face one point.
struct OpenTurnParams {
  double min_score = 0.7;   ///< Of scans where it is looked for: they fit there.
  double noise_rad = 0.1;   ///< Normals that are off by this (sigma) bind a turn by chance; ...
  double bound_rad = 0.14;  ///< ... a turn that is bound as if by this is bound.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of the Gauss-Newton refinement against the submap.
struct SubmapRefinementParams {
  AlignmentScale first_step{.gate_m = 0.30, .scale_m = 0.10};   ///< Catches.
  AlignmentScale later_steps{.gate_m = 0.15, .scale_m = 0.05};  ///< Settle.
  int max_iterations = 10;                                      ///< Gauss-Newton steps at most.
  double converged_m = 1e-3;                                    ///< A step smaller than this ...
  double converged_rad = 5e-4;  ///< ... and this ends the iteration.
  double max_step_m = 0.3;      ///< A longer step is cut to this.
  /// Directions bound by fewer effective points than this are topped up by the prediction.
  double min_effective_points = 3.0;
  OpenTurnParams turn;         ///< For halls whose walls face one point.
  double chance_points = 1.0;  ///< This many or fewer are chance, as in a bare corridor.

  /// How far the walls bind a direction: 0 by chance alone, 1 by min_effective_points or more.
  [[nodiscard]] double bound_share(double effective_points) const;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of the search along a corridor.
struct CorridorSearchParams {
  double below_effective_points = 4.0;  ///< Scans bound by fewer points are searched.
  double half_range_m = 0.6;            ///< About the prediction.
  double step_m = 0.05;                 ///< From one place that is tried to the next.
  double scale_m = 0.06;                ///< Closeness of points to surfaces.
  double motion_cost = 0.02;            ///< Closeness given up for one sigma off the prediction.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of finding the pose again.
struct RecoveryParams {
  double below_score = 0.4;          ///< Scans tracked with less are looked at again, ...
  double below_score_if_open = 0.7;  ///< ... those that leave a direction open with less than this.
  double min_gain = 0.1;             ///< Another place must beat the tracked score by this much.
  std::size_t num_keyframes = 3;     ///< Matched against, the latest first ...
  double enough_score = 0.8;         ///< ... until one gives this score.
  double near_m = 0.6;               ///< Beyond it, or ...
  double near_rad = rad_from_deg(35.0);  ///< ... this, from the expected pose, a place is far ...
  double far_min_score = 0.5;  ///< ... and must have this score, by a match that stands alone.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of LongSteps.
struct LongStepParams {
  double long_m = 0.3;                   ///< Farther than this, or ...
  double long_rad = rad_from_deg(15.0);  ///< ... turned by more, is a long step from scan to scan.
  std::size_t num_steps = 10;            ///< Of the latest steps ...
  std::size_t min_long = 4;              ///< ... this many long ones let the matcher lead.
  double least_reach_m = 1.5;            ///< The next step may be as long as this, and turn ...
  double least_reach_rad = rad_from_deg(60.0);  ///< ... by this, ...
  double reach_per_step = 1.3;                  ///< ... or so many times what the latest did.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of find_sudden_turn.
struct SuddenTurnParams {
  double below_score = 0.6;  ///< Scans that score less as expected are searched, ...
  double below_usual =
      0.2;                  ///< ... and if no sweep is known by so much less than scans lately did,
  double near_usual = 0.1;  ///< to which what is found must come so near again, ...
  double min_turn_rad = rad_from_deg(2.0);  ///< turned by this at least: less is no sudden turn;
  double min_gain = 0.1;           ///< ... and what is found must beat the score by this much.
  double fastest_rad_per_s = 5.5;  ///< Turns that are tried; no robot turns faster.
  double step_rad = 0.1;           ///< Of the turns that are tried.
  double scale_m = 0.15;           ///< Closeness of points to surfaces.
  std::size_t max_samples = 120;   ///< Of the scan.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of odds_against and log_odds_of_place.
struct StepOddsParams {
  /// Beyond the reach of a step: so many powers of ten for each time the reach.
  double decades_per_reach = 4.0;
  double least_wrong = 1e-5;  ///< No match is surer than this.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of place_votes, agreed_place and probable_place.
struct PlaceVoteParams {
  std::size_t num_keyframes = 4;    ///< Asked, the latest.
  double same_m = 0.3;              ///< Poses nearer than this ...
  double same_rad = 0.1;            ///< ... and this to each other are one place.
  double min_votes_for_jump = 1.5;  ///< For a place far from where odometry expects it.
  double min_probability = 0.9;     ///< Of a place, where the last motion expects the step.
  StepOddsParams odds;              ///< What the motion says of a place.
  double least_open_sigma_m = 0.1;  ///< Along what a likely place leaves open.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of is_jolt: steps unlike what was expected.
struct JoltParams {
  double min_m = 0.1;                    ///< Farther than this, ...
  double min_rad = rad_from_deg(5.0);    ///< ... or turned by more, or both by their share.
  double same_m = 0.05;                  ///< Where the last scan has it a scan fits if it stays ...
  double same_rad = rad_from_deg(2.0);   ///< ... as near as this, ...
  std::size_t min_beams = kFewestBeams;  ///< ... if it has as many beams.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of SweepTrial. Shares are of the time from scan to scan.
struct SweepTrialParams {
  bool is_on = true;                        ///< For scanners that spin.
  double max_period_s = 0.3;                ///< From scan to scan; with a longer one none is tried.
  double min_turn_rad = rad_from_deg(5.0);  ///< From scan to scan, of those that are compared.
  double min_score = 0.6;                   ///< Of the same, by tracking.
  std::size_t min_turns = 6;                ///< Compared before it is judged.
  double num_sigmas = 2.0;                  ///< By so many standard errors the median must be ...
  double max_share_at_once = 0.3;           ///< ... below this: there is no sweep, or ...
  double min_share = 0.4;                   ///< ... above this: there is one.
  double max_off_whole = 0.35;  ///< So near to 1 it takes the whole time, as scanners do that spin.
  std::size_t max_scans = 3000;  ///< Then the trial ends.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of deskewing (deskewed, refined_turns).
struct DeskewParams {
  bool is_on = true;      ///< For scans that say how long they swept.
  int max_num_turns = 6;  ///< Times that the turns during a sweep are corrected ...
  double converged_rad = rad_from_deg(0.1);  ///< ... unless they change by less.
  double gyro_sigma_rad_per_s = 0.2;    ///< Of the turning rate expected in a sweep, by a gyro,
  double motion_sigma_rad_per_s = 2.0;  ///< else: robots begin and end turns at once.
  /// Whether scans truly sweep as they say; else a sweep is expected to show no turn (SweepTrial).
  bool is_sweep_known = true;
  SuddenTurnParams sudden_turn;  ///< For turns that no prediction foresaw.
  SweepTrialParams trial;        ///< Whether scans sweep as they say.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of the scan tracker.
struct ScanTrackerParams {
  std::size_t num_keyframes = 8;     ///< In the submap, the latest of each scanner.
  double keyframe_distance_m = 0.4;  ///< The paper's spacing (section 5.1).
  /// Turned by more than this since the last keyframe, a scan is one, too.
  double keyframe_turn_rad = rad_from_deg(10.0);
  std::size_t num_scans_averaged = 7;  ///< For the last motion.
  SurfaceParams surfaces;              ///< How returns become surfaces.
  SurfaceImageParams image;            ///< How surfaces become an image.
  SubmapRefinementParams refinement;   ///< Gauss-Newton against the submap.
  CorridorSearchParams corridor;       ///< Along corridors.
  RecoveryParams recovery;             ///< Finds lost poses again.
  LongStepParams long_steps;           ///< For logs of key frames.
  PlaceVoteParams votes;               ///< For places that repeat.
  ScanGapParams gap;                   ///< For logs with pauses.
  GyroParams gyro;                     ///< Judges a gyro.
  OdometryTrialParams odometry;        ///< Judges the odometry.
  DeskewParams deskew;                 ///< Takes the skew out of scans.
  JoltParams jolts;                    ///< For scans that are pulled aside.
  /// Where odometry predicts.
  PredictionTrust trust_in_odometry{.weight = 10.0, .sigma_m = 0.05, .min_gain = 0.02};
  /// Where the mean of the last motions does.
  PredictionTrust trust_in_last_motion{.weight = 2.0, .sigma_m = 0.15, .min_gain = 0.004};
  double lost_below_score = 0.2;  ///< A scan that scores less and is not found again is lost.
  /// After this many lost scans in a row the submap restarts at the predicted pose.
  std::size_t max_lost_scans = 5;
  /// Scans with fewer returns are lost: not matched, not kept, not counted in max_lost_scans.
  std::size_t min_points = 10;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// How certain tracked motion between neighbouring keyframes is.
struct MotionUncertaintyParams {
  double step_sigma_m = 0.004;    ///< Of every step ...
  double sigma_per_metre = 0.01;  ///< ... and this share of its length.
  /// Along a direction that the walls leave open and no odometry tells, the robot's speed: from
  /// the one it had it may change as fast as this, ...
  double open_acceleration_m_per_s2 = 0.3;
  double open_speed_m_per_s = 0.5;  ///< ... and be off by this at most (sigmas).
  /// Where odometry tells it: the share of the way.
  double open_sigma_per_metre_by_odometry = 0.05;
  /// Where the walls leave a turn open (OpenTurn) and no odometry tells it: robots begin turns as
  /// fast as this ...
  double open_turn_rad_per_s2 = 1.0;
  double open_turn_rad_per_s = 0.5;  ///< ... and turn at this rate (sigmas).
  /// Where odometry tells it: the share of the turn, unless the scans showed a larger one, ...
  double open_sigma_per_turn_by_odometry = 0.03;
  double open_turn_rad_per_metre_by_odometry = 0.003;  ///< ... and of the way.
  double lost_sigma_m = 0.3;                           ///< Of each lost scan in between.
  double recovered_sigma_m = 0.05;                     ///< Of each scan found again far off.
  double restart_sigma_m = 200.0;                      ///< Of each new start of the submap.

  double step_sigma_rad = rad_from_deg(0.06);  ///< Of every step ...
  double sigma_per_turn = 0.005;               ///< ... and this share of the turn.
  double scan_sigma_rad = rad_from_deg(0.2);   ///< Of one scan's heading among those about it.
  double lost_sigma_rad = 0.05;                ///< Of each lost scan in between.
  /// Of each scan found again far off.
  double recovered_sigma_rad = rad_from_deg(1.5);
  double restart_sigma_rad = 0.5;  ///< Of each new start of the submap.

  // The same where odometry bridges the gap.
  double lost_sigma_m_by_odometry = 0.03;    ///< As lost_sigma_m.
  double restart_sigma_m_by_odometry = 0.3;  ///< As restart_sigma_m.
  /// As lost_sigma_rad.
  double lost_sigma_rad_by_odometry = rad_from_deg(0.5);
  /// As restart_sigma_rad.
  double restart_sigma_rad_by_odometry = rad_from_deg(3.0);

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
