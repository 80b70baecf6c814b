// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper, its only caller, which gathers what is tracked.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "setsquare/mapping/anchored_keyframes.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/map_assembly.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/pieces/piece_joining.hpp"
#include "setsquare/mapping/slipped_steps.hpp"
#include "setsquare/mapping/turn_checks.hpp"

namespace setsquare {

/// Closes loops of a track's first keyframes while it grows.
///
/// 1. The track is laid out along its headings, with the closures accepted so far, and positions
///    are solved.
/// 2. The places of the first `num_keyframes` that the closer has not seen are compared with those
///    near by.
/// `slips`: of each mending; see loosen_slipped().
void close_loops(const KeyframeTrack& track,
                 std::span<const double> headings_rad,
                 std::size_t num_keyframes,
                 const MapperParams& params,
                 LoopCloser& closer,
                 std::span<const Slips> slips = {});

/// The track laid out along its headings, positions and weights of the closures accepted so far by
/// graduated non-convexity. The source of a closure's constraint is its index in
/// LoopCloser::compared().
[[nodiscard]] PoseGraph robust_graph(const KeyframeTrack& track,
                                     std::span<const double> headings_rad,
                                     const LoopCloser& closer,
                                     const MapperParams& params);

/// The closures that establish that two keyframes see the same place: of both axes, and not
/// outvoted. `graph`: of robust_graph().
[[nodiscard]] std::vector<Constraint> revisits_in(const PoseGraph& graph, const LoopCloser& closer);

/// Keyframes at which loops are looked for again.
[[nodiscard]] std::size_t next_closing(std::size_t num_closed, const MapperParams& params);

/// What was tracked and found on the way, of which a map is made. Everything must outlive the maker
/// of the map.
struct TrackedLog {
  const TrackedScans& scans;
  std::size_t num_scans = 0;  ///< The first ones, of which the map is made.
  std::span<const KeptScan> kept_scans;
  const KeyframeTrack& track;
  std::span<const double> shares_of_place;  ///< One per keyframe.
  std::span<const HungScan> hung_scans;     ///< Of forgotten keyframes, in their order.
  std::span<const MapSession> sessions;
  std::span<const ForgottenPoses> gaps;  ///< Where poses were forgotten.
  /// The map's frame is the one in which these lie, as well as can be, where they lay. Empty: the
  /// first keyframe stands at the origin.
  const std::vector<AnchoredKeyframe>& anchors;
  /// What is anchored stays joined as it lies: of what it was joined by, some is forgotten.
  bool stays_joined = false;
  /// Loops that the last session closed by itself: then it is looked for as it lies by these.
  std::span<const ComparedPlaces> loops_of_last;
  const std::vector<HeadingEvidence>& evidence;  ///< One per keyframe.
  const TurnChecks& turn_checks;                 ///< As far as turns have been checked.
  const LoopCloser& closer;                      ///< As far as loops have been closed.
  std::function<void(Map&)> add_sensors;         ///< Writes what the sensors turned out to be.
};

/// What a map settled, for the next one of the same track when it has grown: where pieces of track
/// lie, which loops are closed, what matches say of turns.
struct SettledLoops {
  JoinedPieces joined;
  LoopCloser closer;
  TurnChecks turn_checks;
};

/// Makes the map of a track.
///
/// 1. Pieces of track between which tracking was lost are joined where they overlap (join_pieces),
///    and the loops that are left are closed.
/// 2. Weights of the closures by graduated non-convexity (solve_robustly), all keyframes registered
///    with their neighbours (register_keyframes), scans laid out between them (assemble_map).
/// 3. Where closures agree on how walls are turned that the headings took for others, these are
///    outvoted (outvoted_walls), and all loops closed again.
/// 4. The map is audited; where scans contradict it alike, its loops are closed again by them.
class MapMaker {
 public:
  MapMaker(const TrackedLog& log, const MapperParams& params) : log_(log), params_(params) {}

  /// Where the loops cannot be closed or the graph cannot be solved, for its figures are beyond
  /// what can be computed, the track as it was driven, with that doubt: nothing tracked is lost.
  [[nodiscard]] Map make() const;
  /// One of several on the way: what an earlier one settled is not looked for again. The maps are
  /// not those that make() gives, to the last digit; each is as good. Where pieces are still to be
  /// joined, or more have come, nothing is settled.
  [[nodiscard]] Map make_next(std::optional<SettledLoops>& settled) const;

 private:
  /// The headings and loops of the whole track.
  struct Closed {
    TurnChecks turn_checks;
    FusedHeadings headings;
    LoopCloser closer;
    JoinedPieces joined;
    std::vector<Slips> slips = {};  ///< That audits found, of each mending.
  };

  /// The map, or the track alone where it throws; `close`: the loops.
  template <typename Close>
  [[nodiscard]] Map make_of(const Close& close) const;
  [[nodiscard]] Map map_closed_by(Closed closed) const;
  /// What every map of this log is made of, before it is closed.
  [[nodiscard]] MapParts parts_of_log() const;
  /// The map without any loop, its spreads unknown; `reason`: why.
  [[nodiscard]] Map track_alone(const std::string& reason) const;
  /// Tracks of one piece: the loops that are left to close.
  [[nodiscard]] Closed close_one_piece() const;
  /// Joins the pieces of the track, by quarter turns of the headings, and closes the loops that
  /// `closer` has not: one of none closes all again.
  [[nodiscard]] Closed close_across_pieces(LoopCloser closer, TurnChecks checks) const;
  /// The evidence for the headings, where the pieces were joined.
  [[nodiscard]] std::vector<HeadingEvidence> evidence_of(const JoinedPieces& joined) const;
  /// Of pieces that were joined, the loops that are left to close.
  [[nodiscard]] Closed close_further(SettledLoops& settled) const;
  [[nodiscard]] bool is_settled(const SettledLoops& settled) const;
  /// Where pieces are joined for the first time: the loops of the first session, if it is one
  /// piece.
  [[nodiscard]] LoopCloser closer_of_first_session() const;
  /// From where the closer ended, as the track grows.
  void close_all_loops(Closed& closed) const;
  /// All loops closed again along its headings, with those that the hypotheses tell.
  [[nodiscard]] Closed closed_with(const Closed& closed,
                                   const std::vector<MapHypothesis>& hypotheses) const;
  /// The same where tracking slipped as the hypotheses tell.
  [[nodiscard]] Closed closed_with_slips(const Closed& closed,
                                         Slips slips,
                                         const std::vector<MapHypothesis>& hypotheses) const;
  /// The same with a turn that the walls left undecided as the hypotheses tell it: tracking slipped
  /// there, or it did not. One for each such turn that would explain what they say of the headings.
  [[nodiscard]] std::vector<Closed> closed_with_turns(
      const Closed& closed, const std::vector<MapHypothesis>& hypotheses) const;
  /// Walls that the closures outvote, and matches of an audit, if there is one.
  [[nodiscard]] std::vector<TurnedWalls> outvoted_in(const Closed& closed,
                                                     const AuditFindings* findings) const;
  /// All loops closed again with these walls turned.
  [[nodiscard]] Closed closed_with_walls(const Closed& closed,
                                         std::span<const TurnedWalls> turned,
                                         const std::vector<MapHypothesis>& hypotheses) const;
  /// Places at which closures, and matches of an audit, contradict the headings.
  [[nodiscard]] std::size_t num_places_against_in(const Closed& closed,
                                                  const AuditFindings* findings) const;
  /// Turns walls that the closures outvote; a new map stays if fewer places contradict its
  /// headings, and no more keyframes the map.
  void outvote_walls(Closed& closed, Map& map) const;
  /// The map by the loops that were closed.
  [[nodiscard]] Map map_of(const Closed& closed) const;
  /// How the session whose keyframes these are was looked for.
  void add_searches(const Closed& closed, Map& map) const;
  /// The graph's poses after registration of all keyframes.
  [[nodiscard]] std::vector<Pose2> registered_poses(const LoopCloser& closer,
                                                    const PoseGraph& graph) const;
  /// Closes loops behind open stretches, wherever they are (closures_anywhere).
  void close_anywhere(Closed& closed, Map& map) const;
  /// Matches scans of the map, and where they contradict it alike closes the loops again by them,
  /// decides turns and turns walls by them, and loosens steps over which tracking slipped; the new
  /// map stays if it explains more of all matches. Then the doubts that are left.
  void audit_and_mend(Closed& closed, Map& map) const;

  /// Keyframes that the map contradicts.
  [[nodiscard]] std::size_t num_seen_through_in(const Map& map) const;

  const TrackedLog& log_;
  const MapperParams& params_;
};

}  // namespace setsquare
