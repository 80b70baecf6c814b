// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Parameters of the mapper and of its steps, in their order.
#pragma once

#include <cstddef>

#include "setsquare/core/angle.hpp"
#include "setsquare/graph/robust_params.hpp"
#include "setsquare/headings/heading_params.hpp"
#include "setsquare/scan/few_beams.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Parameters of ClosureCandidates.
struct ClosureCandidateParams {
  double radius_m = 4.0;           ///< Views farther apart hardly overlap.
  double min_way_m = 5.0;          ///< Tracking has compared what is nearer along the track.
  std::size_t max_num = 4;         ///< Per station.
  std::size_t min_separation = 4;  ///< Stations between two candidates of one station.
  /// The window is this wide ...
  double window_m = 0.3;
  double window_per_metre = 0.02;  ///< ... and this share of the way, by the shortest path.
  double max_window_m = 6.0;       ///< At most; correlation grids can hold no more.
  double slip_way = 50.0;          ///< Metres of way that one metre of possible slip counts for.
  /// A place that may be off along open stretches by more than the widest window, in so many
  /// sigmas, is not looked for in it.
  double max_sigmas_open = 3.0;
  double closure_way_m = 1.0;  ///< Length of a closure in the graph.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of match_submaps.
struct SubmapMatchParams {
  int min_correlation = 15;           ///< Of a proposal's coarse samples with the grid.
  std::size_t max_num_proposals = 8;  ///< Refined, the best by correlation ...
  double min_start_score = -0.1;      ///< ... unless all score less than this as they are.
  /// After one step, in score and in agreement: candidates that lag more are dropped.
  double max_lag = 0.4;
  AlignmentScale catching{.gate_m = 0.30, .scale_m = 0.15};  ///< Of the first steps, which catch.
  AlignmentScale settling{.gate_m = 0.15, .scale_m = 0.07};  ///< Of the later ones, which settle.
  int num_catching_steps = 4;  ///< Gauss-Newton steps at the first scale.
  int num_settling_steps = 6;  ///< And at the second.
  /// Weight of the expected rotation, in points x m^2: the fused headings are better than a few
  /// far points.
  double heading_weight = 2000.0;
  double contradiction_weight = 2.0;  ///< In the score.
  double min_compared = 0.3;          ///< The score refers to at least this share of the points.
  double distinct_m = 0.4;            ///< Poses nearer than this to each other are the same.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// What decides whether two submaps that were matched close a loop.
struct ClosureVerdictParams {
  /// Agreement less weighted contradiction, as SubmapMatchParams weighs them.
  double min_score = 0.35;
  /// Share of the compared points that lie where the other submap saw through.
  double max_contradiction = 0.10;
  double min_margin = 0.10;            ///< Of the score and of the agreement over any other's.
  double min_effective_points = 10.0;  ///< Along the open direction; below, it is left open.
  double max_open_share = 0.2;         ///< Of a direction that is left open, in all points.
  double max_rival_rad = 0.3;  ///< A rival nearer than this to the open direction is ignored.
  double max_askew_rad = rad_from_deg(10.0);  ///< Between the open direction and the map's axis.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of LoopCloser.
struct LoopCloserParams {
  // Both for each of the track's scanners.
  std::size_t station_spacing = 3;    ///< Keyframes from station to station ...
  std::size_t submap_half_width = 3;  ///< ... and to either side of one in its submap.
  ClosureCandidateParams candidates;  ///< Which places are compared.
  SubmapMatchParams match;            ///< How they are.
  ClosureVerdictParams verdict;       ///< Which of them close a loop.
  /// Noise of one point, correlated with its neighbours' noise.
  double point_sigma_m = 0.10;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of join_pieces.
struct PieceJoiningParams {
  std::size_t max_num_queries = 40;     ///< Places of a piece that are looked for.
  std::size_t num_similar = 12;         ///< Places elsewhere that each is compared with.
  double window_m = 0.5;                ///< Of the submaps about a match of two scans.
  std::size_t min_agreeing = 3;         ///< Places that must agree ...
  std::size_t num_across_break = 4;     ///< Keyframes either side of a break that are matched ...
  std::size_t num_across_lost = 8;      ///< ... or so many where steps are not long ...
  double min_votes_across_break = 1.5;  ///< ... and votes that must agree (vote_weight).
  /// Where they are long: the log odds of the surest of the places that agree.
  double min_log_odds_across_break = 3.0;
  /// How far the robot may go from keyframe to keyframe across a break ...
  LongStepParams steps = {};
  StepOddsParams odds = {};                    ///< ... and what that says of a place.
  double joint_sigma_m = 0.05;                 ///< Of such a match, in position ...
  double joint_sigma_rad = rad_from_deg(1.5);  ///< ... and heading, ...
  double joint_open_sigma_m = 0.3;          ///< ... and along a direction that a match leaves open.
  double agreeing_m = 0.5;                  ///< ... on where the piece lies ...
  double agreeing_rad = rad_from_deg(3.0);  ///< ... and how it is turned.
  /// Of another log, or behind open stretches that may be off by more than this, nothing tells in
  /// which of two rooms that are alike it was. The places that agree must lie so far apart ...
  double min_extent_m = 5.0;
  /// ... and, of any piece, no larger share of the keyframes about them may see through the map's
  /// walls, or the map through theirs.
  double max_seen_through = 0.3;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of register_keyframes.
struct RegistrationParams {
  int num_rounds = 2;  ///< Times that all keyframes are compared and moved.
  /// Keyframes just before it that each is compared with, for each of the track's scanners.
  std::size_t num_before = 4;
  std::size_t max_revisits = 6;  ///< Keyframes of earlier visits, by accepted closures.
  /// How distances between their points and surfaces count.
  AlignmentScale scale{.gate_m = 0.12, .scale_m = 0.04};
  double min_explained = 0.3;      ///< Of a keyframe's points; pairs with less are left out.
  double max_contradicted = 0.15;  ///< Of the points compared.
  /// A direction bound by fewer effective points is left open, as in SubmapRefinementParams.
  double min_effective_points = 3.0;
  double point_sigma_m = 0.10;  ///< As in LoopCloserParams.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// How certain the headings of a finished map are (spread_headings).
struct HeadingSpreadParams {
  /// Keyframes so far apart (sigma) see the same walls: in simulated buildings errors of measured
  /// headings are alike over two or three metres of way, and half as much over five.
  double same_walls_m = 2.0;
  /// Tracked rotations err by so many times what registration changes about them, for both are of
  /// the same scans: by 2 to 4 times in simulation, where the truth is known.
  double sigma_per_change = 3.0;
  double max_changes = 3.0;  ///< In stated sigmas, where tracking slipped: counted at most.
  double num_assumed =
      20.0;  ///< Motions that are taken to err as stated, in addition to the log's.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of KnownKeyframes and of forgetting them.
struct ForgettingParams {
  bool is_on = true;           ///< Else memory grows with the way driven, also where all is known.
  std::size_t min_visits = 3;  ///< Earlier visits that cover a keyframe ...
  double near_m = 0.4;         ///< ... with one of their own that stood so near ...
  double near_rad = rad_from_deg(20.0);  ///< ... and looked so much the same way.
  double visit_way_m = 8.0;              ///< Way from one visit to the next, at least.
  /// How distances between its points and what the visits saw count.
  AlignmentScale scale{.gate_m = 0.12, .scale_m = 0.04};
  double min_explained = 0.8;      ///< Of its points; with less it shows something new ...
  double max_contradicted = 0.05;  ///< ... or with more, of the points compared.
  /// A direction bound by fewer effective points is left open, as in SubmapRefinementParams.
  double min_effective_points = 3.0;
  /// The walls may move it by so much against what loops say.
  double max_off_m = 0.2;
  double max_off_rad = rad_from_deg(2.0);  ///< See max_off_m.
  // Both for each of the track's scanners.
  std::size_t margin_keyframes = 3;  ///< Stay on either side of one that shows something new.
  std::size_t shortest_run = 8;      ///< Of keyframes that are forgotten together.
  /// The motion over a run is known at least so well, for both its ends are in known places.
  double known_sigma_m = 0.5;
  double known_sigma_rad = rad_from_deg(2.0);  ///< See known_sigma_m.
  /// So many of the newest scans between keyframes that were forgotten keep their poses, the others
  /// are left out of the map (Map::forgotten_poses): then its memory does not grow with the time at
  /// all. 0: every scan keeps its pose.
  std::size_t max_known_poses = 0;
  /// The same of the sessions of a map that is gone on with, all in all, an hour at 10 Hz.
  std::size_t max_poses_before = 36'000;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of TurnChecks.
struct TurnCheckParams {
  double agreeing_rad = rad_from_deg(2.0);    ///< Rotations that differ less are the same.
  std::size_t min_slip_matches = 3;           ///< Matches that tell the same slip.
  double slip_sigma_rad = rad_from_deg(0.5);  ///< Of a slip that matches have told.
  /// A match that leaves something open, the way along a bare corridor mostly, confirms a rotation
  /// where it is so probable. It measures no slip.
  double min_degenerate_probability = 0.99;
  /// A turn that no match decides is held for another wing where tracking would have slipped by
  /// more than so many standard deviations.
  double unlikely_slip_sigmas = 6.0;
  std::size_t longest_hop = 8;  ///< Keyframes from one scan to the one matched with it.
  int max_rounds = 4;           ///< Of checking and fusing again.
  /// Scans of fewer beams are not asked: a few returns that fit by chance confirm any turn.
  std::size_t min_beams = kFewestBeams;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of outvoted_walls.
struct OutvotedWallsParams {
  bool is_on =
      true;  ///< Else walls alone decide the headings, also where closures contradict them.
  double seen_sigma_rad = rad_from_deg(0.4);  ///< Of a turn that was seen, beside its own.
  double min_turn_rad = rad_from_deg(1.5);    ///< What is off by less contradicts nothing, ...
  double max_sigmas = 3.0;                    ///< ... nor what is by fewer sigmas.
  double max_turn_rad = rad_from_deg(20.0);   ///< What asks for more sees alike corners.
  double min_sigma_rad = rad_from_deg(0.2);   ///< Of a turn of walls.
  double same_place_m = 2.0;   ///< What is seen within this of the same two places is one.
  std::size_t min_places = 3;  ///< That must ask for a turn ...
  double min_majority = 2.0;   ///< ... and how many times more than it would contradict.
  int max_rounds = 2;          ///< Loops are closed again so often.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of MountingTrial.
struct MountingTrialParams {
  /// Scans of a further scanner that must fit what the others saw before it is judged; with 0 every
  /// mounting is believed.
  std::size_t num_sightings = 40;
  double spacing_m = 0.1;                    ///< The robot moves on by this ...
  double spacing_rad = rad_from_deg(5.0);    ///< ... or this from one to the next.
  std::size_t max_tries_per_sighting = 3;    ///< With more, the scanner is unfit.
  double max_off_m = 0.1;                    ///< Beyond this ...
  double max_off_rad = rad_from_deg(1.0);    ///< ... or this a mounting harms a map, ...
  double max_sigmas = 3.0;                   ///< ... if it is certain by so many sigmas.
  double max_sigma_rad = rad_from_deg(0.5);  ///< Judged when the heading is known to this.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of audit_map.
struct AuditParams {
  bool is_on = true;                 ///< Else Map::audit and Map::doubts stay empty.
  double pairs_per_keyframe = 0.75;  ///< Tried at first ...
  std::size_t min_num_pairs = 300;   ///< ... but so many at least ...
  std::size_t max_num_pairs = 1000;  ///< ... and at most.
  double near_m = 3.0;               ///< Pairs that the map has so near see the same.
  double min_way_m = 2.0;  ///< Along the track between the scans of a pair; tracking saw the rest.
  double revisit_way_m = 8.0;  ///< From here on the robot came back.
  /// A match contradicts the map if it is off by this, or by this ...
  double off_m = 0.3;
  /// ... in rotation, either way ...
  double off_rad = rad_from_deg(5.0);
  double max_sigmas = 3.0;  ///< ... and by so many of the map's own spreads.
  double part_m = 12.0;     ///< Of track: contradictions of the same two parts may be one.
  /// Corrections that are alike differ by less than this and this share of their size ...
  double alike_m = 0.3;
  double alike_share = 0.2;              ///< See alike_m.
  double alike_rad = rad_from_deg(5.0);  ///< ... and by less than this.
  /// Places that must ask for the same correction; and how many times more than agree.
  std::size_t min_seconded = 3;
  double min_majority = 2.0;  ///< See min_seconded.
  /// Two places lie over each other where scans see through walls of others along this much way.
  double min_crossed_m = 2.0;
  /// Times that loops are closed again by what contradicts the map, if that explains more.
  int max_mendings = 2;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of closures_anywhere.
struct ClosuresAnywhereParams {
  bool is_on = true;  ///< Else loops behind bare corridors are closed only where they are expected.
  double min_spread_m = 0.5;         ///< Where ways are known better (sigma), it is not needed.
  std::size_t max_num_places = 240;  ///< Of the track, that are looked for ...
  std::size_t num_alike = 8;         ///< ... and places that each is matched with.
  std::size_t min_places = 3;        ///< Independent matches that must tell the same.
  double max_rival_share = 0.5;      ///< Of these, such that tell another place.
  /// Spreads of the position by which the extent of what is told must exceed the correction, where
  /// one room tells it, and where two do; three rooms must extend over one spread.
  double num_sigmas_of_one = 3.0;
  double num_sigmas_of_two = 2.0;    ///< The same where two rooms tell it.
  double extent_share = 1.0;         ///< Of that extent; with 0 extents do not count.
  int max_rounds = 3;                ///< Loops are closed again so often.
  double min_kept = 0.8;             ///< Matches that the new map must agree with.
  std::size_t max_seen_through = 2;  ///< Keyframes that it may contradict more than the old one.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Parameters of the mapper; every default works.
struct MapperParams {
  ScanTrackerParams tracker;           ///< Places scan after scan.
  MountingTrialParams mounting;        ///< Judges where further scanners are mounted.
  SquareDirectionParams direction;     ///< Measures a scan's heading by its walls.
  MotionUncertaintyParams motion;      ///< How certain tracking is.
  HeadingFusionParams heading;         ///< Fuses the headings with the tracked rotations.
  TurnCheckParams turns;               ///< Asks matches about turns in doubt.
  LoopCloserParams closing;            ///< Closes loops.
  OutvotedWallsParams outvoted;        ///< Tells walls that closures outvote.
  ForgettingParams forgetting;         ///< Forgets keyframes that show nothing new.
  PieceJoiningParams joining;          ///< Joins pieces of track.
  RobustPoseGraphParams robust;        ///< Decides which closures to believe.
  RegistrationParams registration;     ///< Moves all keyframes at the end.
  HeadingSpreadParams heading_spread;  ///< How certain the headings are then.
  ClosuresAnywhereParams anywhere;     ///< Closes loops behind corridors.
  AuditParams audit;                   ///< Says where the map may be wrong.
  /// A direction's confidence grows with its margin over the next one: none at 1, full here.
  double confident_margin = 3.0;
  /// Loops are looked for each time the track has grown by this share, and by this many keyframes.
  double closing_growth = 0.1;
  std::size_t min_closing_growth = 64;  ///< See closing_growth.
  std::size_t num_threads = 1;          ///< Any number gives the same map.
  bool leaves_out_robot_parts = true;   ///< What a scanner sees of its own robot (RobotParts).

  /// Throws ParameterError that names the field.
  void validate() const;
};

}  // namespace setsquare
