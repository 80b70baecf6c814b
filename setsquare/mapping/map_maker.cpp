// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/map_maker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/robust_pose_graph.hpp"
#include "setsquare/mapping/audit/closures_anywhere.hpp"
#include "setsquare/mapping/audit/seen_through.hpp"
#include "setsquare/mapping/heading_spread.hpp"
#include "setsquare/mapping/open_spread.hpp"
#include "setsquare/mapping/outvoted_walls.hpp"
#include "setsquare/mapping/registration.hpp"
#include "setsquare/mapping/told_turns.hpp"
#include "setsquare/mapping/track_certainty.hpp"

namespace setsquare {
namespace {

/// Tracked motion is made of the scans that registration compares again.
constexpr double kTrackedMotionWeight = 0.05;
/// Of the rotation between two pieces that were joined, by matches of scans.
constexpr double kJointSigma_rad = rad_from_deg(3.0);

/// What the walls measured of the headings, in the map frame.
std::vector<HeadingMeasurement> heading_measurements(const FusedHeadings& headings) {
  std::vector<HeadingMeasurement> measurements;
  for (std::size_t k = 0; k < headings.heading_rad.size(); ++k) {
    if (!(headings.measured_information[k] > 0.0)) continue;
    measurements.push_back(
        {k, wrap_to_pi(headings.measured_heading_rad[k]), headings.measured_information[k]});
  }
  return measurements;
}

/// The evidence with what the joints add to it: pieces that were joined are turned as a whole, and
/// the rotation from one to the next is known again. Pieces in between that were not joined are
/// left out of the map; of the building's walls they say nothing, for nobody knows how they lie.
std::vector<HeadingEvidence> evidence_of_joined(std::vector<HeadingEvidence> evidence,
                                                const KeyframeTrack& track,
                                                const JoinedPieces& joined) {
  for (std::size_t k = 0; k < track.size(); ++k) {
    const std::size_t piece = track.pieces[k];
    evidence[k].tracked_heading_rad += joined.turn_rad[piece];
    if (!joined.is_joined[piece]) evidence[k].proposals.clear();
    const bool is_begin = k > 0 && track.pieces[k - 1] != piece;
    if (is_begin) evidence[k].step_sigma_rad = kJointSigma_rad;
  }
  return evidence;
}

/// Whether a constraint of graph_along() is a closure that establishes that two keyframes see the
/// same place.
bool is_revisit(const Constraint& constraint, const LoopCloser& closer) {
  return constraint.kind == ConstraintKind::kLoopClosure &&
         constraint.weight >= kMinRevisitWeight &&
         closer.compared()[constraint.source].verdict.axes == ClosureAxes::kXY;
}

/// The track laid out along its headings, with the closures accepted so far; the source of a
/// closure's constraint is its index in LoopCloser::compared().
PoseGraph graph_along(const KeyframeTrack& track,
                      std::span<const double> headings_rad,
                      const LoopCloser& closer,
                      std::span<const Slips> slips = {}) {
  PoseGraph graph = pose_graph_of(track, headings_rad);
  for (const Slips& of_mending : slips) loosen_slipped(of_mending, graph);
  const std::vector<ComparedPlaces>& compared = closer.compared();
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (!is_accepted(compared[i].verdict.reason)) continue;
    graph.constraints.push_back(closure_constraint(compared[i]));
    graph.constraints.back().source = i;
  }
  return graph;
}

}  // namespace

void close_loops(const KeyframeTrack& track,
                 std::span<const double> headings_rad,
                 std::size_t num_keyframes,
                 const MapperParams& params,
                 LoopCloser& closer,
                 std::span<const Slips> slips) {
  PoseGraph graph = graph_along(track, headings_rad, closer, slips);
  loosen_across(track.size() - 1, false, graph);
  const std::vector<Eigen::Vector2d> positions_m = solve_positions(graph);
  for (std::size_t k = 0; k < positions_m.size(); ++k) {
    graph.T_map_node[k].x_m = positions_m[k].x();
    graph.T_map_node[k].y_m = positions_m[k].y();
  }
  closer.extend(track, num_keyframes, graph.T_map_node, params.num_threads);
}

PoseGraph robust_graph(const KeyframeTrack& track,
                       std::span<const double> headings_rad,
                       const LoopCloser& closer,
                       const MapperParams& params) {
  PoseGraph graph = graph_along(track, headings_rad, closer);
  loosen_across(track.size() - 1, false, graph);
  solve_robustly(graph, {}, params.robust);
  return graph;
}

std::vector<Constraint> revisits_in(const PoseGraph& graph, const LoopCloser& closer) {
  std::vector<Constraint> revisits;
  for (const Constraint& constraint : graph.constraints) {
    if (is_revisit(constraint, closer)) revisits.push_back(constraint);
  }
  return revisits;
}

std::size_t next_closing(std::size_t num_closed, const MapperParams& params) {
  const auto growth =
      static_cast<std::size_t>(params.closing_growth * static_cast<double>(num_closed));
  return num_closed + std::max(params.min_closing_growth, growth);
}

template <typename Close>
Map MapMaker::make_of(const Close& close) const {
  try {
    return map_closed_by(close());
  } catch (const Error& error) {
    return track_alone(error.what());
  }
}

Map MapMaker::make() const {
  return make_of([&] {
    if (log_.track.pieces.back() == 0) return close_one_piece();
    return close_across_pieces(LoopCloser(params_.closing), log_.turn_checks);
  });
}

Map MapMaker::make_next(std::optional<SettledLoops>& settled) const {
  return make_of([&] {
    if (log_.track.pieces.back() == 0) return close_one_piece();
    if (settled && is_settled(*settled)) return close_further(*settled);
    TurnChecks checks = settled ? std::move(settled->turn_checks) : log_.turn_checks;
    Closed closed = close_across_pieces(closer_of_first_session(), std::move(checks));
    settled = {closed.joined, closed.closer, closed.turn_checks};
    return closed;
  });
}

MapParts MapMaker::parts_of_log() const {
  return {.scans = log_.scans,
          .num_scans = log_.num_scans,
          .kept_scans = log_.kept_scans,
          .track = log_.track,
          .shares_of_place = log_.shares_of_place,
          .hung_scans = log_.hung_scans,
          .sessions = log_.sessions,
          .gaps = log_.gaps};
}

Map MapMaker::track_alone(const std::string& reason) const {
  std::vector<double> headings_rad;
  std::vector<std::size_t> sizes(log_.track.pieces.back() + 1, 0);
  for (std::size_t k = 0; k < log_.track.size(); ++k) {
    headings_rad.push_back(log_.track.keyframes[k]->T_odom_sensor.theta_rad);
    ++sizes[log_.track.pieces[k]];
  }
  std::vector<bool> is_largest(sizes.size(), false);
  is_largest[static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin())] = true;
  MapParts parts = parts_of_log();
  parts.is_joined = std::move(is_largest);
  parts.graph = pose_graph_of(log_.track, headings_rad);
  Map map = assemble_map(parts);
  log_.add_sensors(map);
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  for (MappedScan& scan : map.scans) {
    scan.position_sigma_m = scan.heading_sigma_rad = kUnknown;
    scan.position_covariance_m2 = Eigen::Vector2d::Constant(kUnknown).asDiagonal();
  }
  map.doubts.push_back(
      {.kind = DoubtKind::kNotClosed,
       .place_m = map.scans.front().T_map_base.translation(),
       .first_scan = 0,
       .num_scans = map.scans.size(),
       .first_stamp = map.scans.front().stamp,
       .last_stamp = map.scans.back().stamp,
       .reason =
           "loops could not be closed, the map is the track as it was driven (" + reason + ")"});
  return map;
}

Map MapMaker::map_closed_by(Closed closed) const {
  Map map = map_of(closed);
  if (params_.outvoted.is_on) outvote_walls(closed, map);
  if (params_.anywhere.is_on) close_anywhere(closed, map);
  if (params_.audit.is_on) audit_and_mend(closed, map);
  return map;
}

MapMaker::Closed MapMaker::close_one_piece() const {
  Closed closed{.turn_checks = log_.turn_checks,
                .headings = {},
                .closer = log_.closer,
                .joined = {.turn_rad = {0.0}, .is_joined = {true}, .joints = {}, .searches = {}}};
  closed.headings = closed.turn_checks.fuse(log_.track, log_.evidence, params_.heading);
  close_loops(log_.track, closed.headings.heading_rad, log_.track.size(), params_, closed.closer);
  return closed;
}

MapMaker::Closed MapMaker::close_across_pieces(LoopCloser closer, TurnChecks checks) const {
  const FusedHeadings apart = checks.fuse(log_.track, log_.evidence, params_.heading);
  PoseGraph graph = pose_graph_of(log_.track, apart.heading_rad);
  std::span<const AnchoredKeyframe> known;
  if (log_.stays_joined) {
    // What is known lies without drift; so does what is compared with it.
    LoopCloser laid(params_.closing);
    laid.add_joints(log_.loops_of_last);
    graph = robust_graph(log_.track, apart.heading_rad, laid, params_);
    known = log_.anchors;
  }
  JoinedPieces joined = join_pieces(
      log_.track, graph.T_map_node, known, params_.closing, params_.joining, params_.num_threads);
  Closed closed{.turn_checks = std::move(checks),
                .headings = {},
                .closer = std::move(closer),
                .joined = std::move(joined)};
  closed.headings =
      closed.turn_checks.fuse(log_.track, evidence_of(closed.joined), params_.heading);
  closed.closer.add_joints(closed.joined.joints);
  close_all_loops(closed);
  return closed;
}

bool MapMaker::is_settled(const SettledLoops& settled) const {
  const std::vector<bool>& is_joined = settled.joined.is_joined;
  return is_joined.size() == log_.track.pieces.back() + 1 &&
         std::ranges::all_of(is_joined, [](bool joined) { return joined; });
}

MapMaker::Closed MapMaker::close_further(SettledLoops& settled) const {
  FusedHeadings headings =
      settled.turn_checks.fuse(log_.track, evidence_of(settled.joined), params_.heading);
  Closed closed{.turn_checks = settled.turn_checks,
                .headings = std::move(headings),
                .closer = settled.closer,
                .joined = settled.joined};
  close_loops(log_.track, closed.headings.heading_rad, log_.track.size(), params_, closed.closer);
  settled.closer = closed.closer;
  return closed;
}

LoopCloser MapMaker::closer_of_first_session() const {
  const auto& begins = log_.track.session_begins;
  const bool is_one_piece = !begins.empty() && log_.track.pieces[begins.front() - 1] == 0;
  return is_one_piece ? log_.closer : LoopCloser(params_.closing);
}

Map MapMaker::map_of(const Closed& closed) const {
  PoseGraph graph =
      graph_along(log_.track, closed.headings.heading_rad, closed.closer, closed.slips);
  graph.headings = heading_measurements(closed.headings);
  if (log_.track.size() > 1) {
    loosen_across(log_.track.size() - 1, true, graph);
    solve_robustly(graph, {}, params_.robust);
    graph.T_map_node = registered_poses(closed.closer, graph);
  }
  // The poses took each measurement as independent; covariances come from this graph.
  spread_headings(log_.track, closed.headings, log_.shares_of_place, params_.heading_spread, graph);
  MapParts parts = parts_of_log();
  parts.headings = closed.headings;
  parts.compared = closed.closer.compared();
  parts.is_joined = closed.joined.is_joined;
  parts.graph = std::move(graph);
  if (!log_.anchors.empty()) {
    move_by(motion_to_anchors(parts.graph, log_.anchors), parts.graph, parts.headings);
  }
  Map map = assemble_map(parts);
  log_.add_sensors(map);
  add_searches(closed, map);
  add_certainty(map, params_.motion);
  return map;
}

void MapMaker::add_searches(const Closed& closed, Map& map) const {
  for (std::size_t s = 1; s < map.sessions.size(); ++s) {
    SessionSearch& search = map.sessions[s].search;
    search = {};
    const std::size_t first = log_.track.session_begins[s - 1];
    const std::size_t end =
        s < log_.track.session_begins.size() ? log_.track.session_begins[s] : log_.track.size();
    for (std::size_t piece = log_.track.pieces[first]; piece <= log_.track.pieces[end - 1];
         ++piece) {
      const SessionSearch& of_piece = closed.joined.searches[piece];
      search.num_pairs += of_piece.num_pairs;
      search.num_matched += of_piece.num_matched;
      search.num_agreeing = std::max(search.num_agreeing, of_piece.num_agreeing);
    }
  }
}

std::size_t MapMaker::num_seen_through_in(const Map& map) const {
  std::vector<Pose2> T_map_sensor;
  for (const std::size_t scan : map.keyframes) T_map_sensor.push_back(map.scans[scan].T_map_sensor);
  return num_seen_through(log_.track, T_map_sensor, params_.num_threads);
}

void MapMaker::close_anywhere(Closed& closed, Map& map) const {
  for (int round = 0; round < params_.anywhere.max_rounds; ++round) {
    const std::vector<MapHypothesis> told = closures_anywhere(
        map, surfaces_of(log_.track), params_.anywhere, params_.audit, params_.num_threads);
    if (told.empty()) return;
    Closed again = closed_with(closed, told);
    Map closed_map = map_of(again);
    if (!has_kept(closed_map, told, params_.anywhere, params_.audit)) return;
    if (num_seen_through_in(closed_map) >
        num_seen_through_in(map) + params_.anywhere.max_seen_through)
      return;
    closed = std::move(again);
    map = std::move(closed_map);
  }
}

void MapMaker::audit_and_mend(Closed& closed, Map& map) const {
  const std::vector<ScanSurfacesPtr> of_keyframes = surfaces_of(log_.track);
  const auto audited = [&](const Map& audited_map) {
    return audit(audited_map, of_keyframes, params_.audit, params_.num_threads);
  };
  AuditFindings findings = audited(map);
  for (int round = 0; round < params_.audit.max_mendings; ++round) {
    bool is_mended = false;
    const auto keep_if_better = [&](Closed story, bool is_of_walls) {
      Map told = map_of(story);
      AuditFindings of_told = audited(told);
      const bool mends_headings =
          is_of_walls && explains_as_much(of_told.report, findings.report) &&
          num_places_against_in(story, &of_told) < num_places_against_in(closed, &findings);
      if (!mends_headings && !explains_more(of_told.report, findings.report)) return;
      closed = std::move(story);
      map = std::move(told);
      findings = std::move(of_told);
      is_mended = true;
    };
    const std::vector<MapHypothesis> hypotheses = findings.hypotheses();
    std::vector<TurnedWalls> turned;
    if (params_.outvoted.is_on) turned = outvoted_in(closed, &findings);
    if (hypotheses.empty() && turned.empty()) break;
    const Closed before = closed;
    Slips slips = slipped_steps(findings, map.graph);
    if (!hypotheses.empty()) {
      for (Closed& story : closed_with_turns(before, hypotheses)) {
        keep_if_better(std::move(story), false);
      }
      keep_if_better(closed_with(before, hypotheses), false);
    }
    if (!is_mended && !slips.empty()) {
      keep_if_better(closed_with_slips(before, std::move(slips), hypotheses), false);
    }
    if (!turned.empty()) keep_if_better(closed_with_walls(before, turned, hypotheses), true);
    if (!is_mended) break;
  }
  if (!findings.unseconded.empty() || !findings.astray.empty()) {
    add_certainty(map, params_.motion, findings.unseconded, findings.astray);
  }
  add_findings(findings, params_.audit, map);
}

MapMaker::Closed MapMaker::closed_with(const Closed& closed,
                                       const std::vector<MapHypothesis>& hypotheses) const {
  Closed mended{.turn_checks = closed.turn_checks,
                .headings = closed.headings,
                .closer = LoopCloser(params_.closing),
                .joined = closed.joined,
                .slips = closed.slips};
  for (const MapHypothesis& hypothesis : hypotheses) {
    mended.joined.joints.push_back(matched_places(hypothesis.keyframe_from,
                                                  hypothesis.keyframe_to,
                                                  hypothesis.T_from_to,
                                                  hypothesis.information));
  }
  mended.closer.add_joints(mended.joined.joints);
  close_all_loops(mended);
  return mended;
}

MapMaker::Closed MapMaker::closed_with_slips(const Closed& closed,
                                             Slips slips,
                                             const std::vector<MapHypothesis>& hypotheses) const {
  Closed slipped = closed;
  slipped.slips.push_back(std::move(slips));
  return closed_with(slipped, hypotheses);
}

std::vector<TurnedWalls> MapMaker::outvoted_in(const Closed& closed,
                                               const AuditFindings* findings) const {
  return outvoted_walls(closed.headings,
                        evidence_of(closed.joined),
                        ways_m_of(log_.track),
                        seen_turns(closed.closer, findings),
                        params_.outvoted);
}

MapMaker::Closed MapMaker::closed_with_walls(const Closed& closed,
                                             std::span<const TurnedWalls> turned,
                                             const std::vector<MapHypothesis>& hypotheses) const {
  Closed with_turned = closed;
  with_turned.turn_checks.turn_walls(turned);
  with_turned.headings =
      with_turned.turn_checks.fuse(log_.track, evidence_of(closed.joined), params_.heading);
  return closed_with(with_turned, hypotheses);
}

std::size_t MapMaker::num_places_against_in(const Closed& closed,
                                            const AuditFindings* findings) const {
  return num_places_against(closed.headings,
                            ways_m_of(log_.track),
                            seen_turns(closed.closer, findings),
                            params_.outvoted);
}

void MapMaker::outvote_walls(Closed& closed, Map& map) const {
  for (int round = 0; round < params_.outvoted.max_rounds; ++round) {
    const std::vector<TurnedWalls> turned = outvoted_in(closed, nullptr);
    if (turned.empty()) return;
    Closed again = closed_with_walls(closed, turned, {});
    if (num_places_against_in(again, nullptr) >= num_places_against_in(closed, nullptr)) return;
    Map turned_map = map_of(again);
    if (num_seen_through_in(turned_map) > num_seen_through_in(map)) return;
    closed = std::move(again);
    map = std::move(turned_map);
  }
}

std::vector<HeadingEvidence> MapMaker::evidence_of(const JoinedPieces& joined) const {
  return evidence_of_joined(log_.evidence, log_.track, joined);
}

std::vector<MapMaker::Closed> MapMaker::closed_with_turns(
    const Closed& closed, const std::vector<MapHypothesis>& hypotheses) const {
  std::vector<Closed> turned;
  for (const ToldTurn& told : told_turns(closed.headings, hypotheses, params_.turns)) {
    Closed decided = closed;
    decided.turn_checks.decide(told.turn, told.beyond_rad);
    decided.headings =
        decided.turn_checks.fuse(log_.track, evidence_of(closed.joined), params_.heading);
    turned.push_back(closed_with(decided, hypotheses));
  }
  return turned;
}

void MapMaker::close_all_loops(Closed& closed) const {
  for (std::size_t end = closed.closer.num_looked_at(); end < log_.track.size();) {
    end = std::min(next_closing(end, params_), log_.track.size());
    close_loops(log_.track, closed.headings.heading_rad, end, params_, closed.closer, closed.slips);
  }
}

std::vector<Pose2> MapMaker::registered_poses(const LoopCloser& closer,
                                              const PoseGraph& graph) const {
  // Registration compares the places that closures name again. Apart from its own comparisons
  // it gives little weight to the tracked motion, which is made of the same scans, and to the other
  // closures.
  PoseGraph to_register{
      .T_map_node = graph.T_map_node, .constraints = {}, .headings = graph.headings};
  const std::vector<Constraint> revisits = revisits_in(graph, closer);
  for (const Constraint& constraint : graph.constraints) {
    if (is_revisit(constraint, closer)) continue;
    to_register.constraints.push_back(constraint);
    if (constraint.kind != ConstraintKind::kLoopClosure) {
      to_register.constraints.back().weight *= kTrackedMotionWeight;
    }
  }
  register_keyframes(log_.track, revisits, to_register, params_.registration, params_.num_threads);
  return std::move(to_register.T_map_node);
}

}  // namespace setsquare
