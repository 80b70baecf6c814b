// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/graph/linear_pose_graph.hpp"
#include "setsquare/graph/robust_pose_graph.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/mapping/kept_scans.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/map_assembly.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/open_spread.hpp"
#include "setsquare/mapping/pieces/piece_joining.hpp"
#include "setsquare/mapping/registration.hpp"
#include "setsquare/mapping/robot_part_search.hpp"
#include "setsquare/mapping/scanners/scanners.hpp"
#include "setsquare/mapping/sweep_search.hpp"
#include "setsquare/mapping/track_certainty.hpp"
#include "setsquare/mapping/turn_checks.hpp"
#include "setsquare/mapping/unjudged_inputs.hpp"
#include "setsquare/scan/isolated_returns.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/odometry_watch.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {
namespace {

/// A closure of less weight does not establish that two scans see the same place.
constexpr double kMinRevisitWeight = 0.5;
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

void require_finite(const Pose2& pose, const char* name) {
  if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad)) return;
  throw ParameterError(name, "must be finite");
}

}  // namespace

class Mapper::Parts {
 public:
  explicit Parts(const MapperParams& params)
      : params_(params),
        sweeps_(params.tracker),
        robot_parts_(params.leaves_out_robot_parts),
        tracker_(params.tracker),
        scanners_(params.mounting),
        uncertainty_(params.motion),
        turn_checks_(params.turns),
        closer_(params.closing) {
    params_.validate();
  }

  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
    sweeps_.add_turn_rate(stamp, turn_rad_per_s);
    robot_parts_.add_turn_rate(stamp, turn_rad_per_s);
    turn(stamp, turn_rad_per_s);
  }
  /// Where the sweep time was found meanwhile, or parts of the robot, or the odometry was found
  /// wrong: what came so far mapped again by it, and the last scan's pose. Else null, and `last`
  /// stays.
  [[nodiscard]] std::unique_ptr<Parts> mapped_again(TrackedPose& last);
  [[nodiscard]] Map finish() const;
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }

 private:
  /// The headings and loops of the whole track.
  struct Closed {
    FusedHeadings headings;
    LoopCloser closer;
    JoinedPieces joined;
  };

  /// add_turn_rate() of a rate that the search for the sweep time has seen.
  void turn(Timestamp stamp, double turn_rad_per_s) {
    unjudged_.add(MapperTurnRate{stamp, turn_rad_per_s});
    tracker_.add_turn_rate(stamp, turn_rad_per_s);
  }
  /// add() of a scan whose sweep time has been looked for.
  TrackedPose map(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  /// The same of a scan without isolated returns and of odometry that is one.
  TrackedPose add_cleared(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  /// The scan that was tracked last. Where several scanners leave keyframes, each is one of as many
  /// that show a place: the same walls (share_place) and one step of the track.
  void add_keyframe(const Scan& scan);
  /// Tracks of one piece: the loops that are left to close.
  [[nodiscard]] Closed close_one_piece() const;
  /// Joins the pieces of the track, by quarter turns of the headings, and closes all loops again.
  [[nodiscard]] Closed close_across_pieces() const;
  /// Compares the places of the first `num_keyframes` that the closer has not seen.
  void close_loops(std::span<const double> headings_rad,
                   std::size_t num_keyframes,
                   LoopCloser& closer) const;
  /// The track laid out along its headings, with the closures accepted so far; the source of a
  /// closure's constraint is its index in LoopCloser::compared().
  [[nodiscard]] PoseGraph graph_along(std::span<const double> headings_rad,
                                      const LoopCloser& closer) const;
  /// Keyframes at which loops are looked for again.
  [[nodiscard]] std::size_t next_closing(std::size_t num_closed) const;
  /// What the log's sensors turned out to be, whatever is mapped.
  void add_sensors(Map& map) const;
  /// The map by the loops that were closed.
  [[nodiscard]] Map map_of(const Closed& closed) const;
  /// Matches scans of the map, and where they contradict it alike closes the loops again by them;
  /// the new map stays if it explains more of all matches. Then the doubts that are left.
  void audit_and_mend(Closed& closed, Map& map) const;
  /// All loops closed again, with those that the hypotheses tell.
  [[nodiscard]] Closed closed_with(const Closed& closed,
                                   const std::vector<MapHypothesis>& hypotheses) const;
  /// From the first keyframe on, as the track grows.
  void close_all_loops(Closed& closed) const;
  /// The graph's poses after registration of all keyframes.
  [[nodiscard]] std::vector<Pose2> registered_poses(const LoopCloser& closer,
                                                    const PoseGraph& graph) const;

  MapperParams params_;
  SweepSearch sweeps_;
  RobotPartSearch robot_parts_;
  UnjudgedInputs unjudged_;
  OdometryWatch odometry_;
  ScanTracker tracker_;
  Scanners scanners_;
  MotionUncertainty uncertainty_;
  TurnChecks turn_checks_;
  LoopCloser closer_;
  std::vector<TrackedScan> scans_;
  std::size_t num_with_odometry_ = 0;
  KeptScans kept_;
  KeyframeTrack track_;
  std::vector<HeadingEvidence> evidence_;
  std::size_t num_closed_ = 0;  ///< Keyframes when loops were last looked for.
};

TrackedPose Mapper::Parts::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  scan.validate();
  require_finite(scan.T_base_sensor, "T_base_sensor");
  if (T_wheels_base) require_finite(*T_wheels_base, "T_wheels_base");
  sweeps_.add(scan, T_wheels_base);
  robot_parts_.add(scan, T_wheels_base);
  return map(scan, T_wheels_base);
}

TrackedPose Mapper::Parts::map(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  unjudged_.add(MapperScan{scan, T_wheels_base});
  const std::optional<Scan> mended = sweeps_.mended(scan);
  const Scan& timed = mended ? *mended : scan;
  const std::optional<Scan> without_parts = robot_parts_.cleared(timed);
  const Scan& seen = without_parts ? *without_parts : timed;
  const std::optional<Scan> cleared = without_isolated_returns(seen);
  return add_cleared(cleared ? *cleared : seen, odometry_.believed(seen, T_wheels_base));
}

std::unique_ptr<Mapper::Parts> Mapper::Parts::mapped_again(TrackedPose& last) {
  std::vector<MapperInput> inputs = sweeps_.take_to_map_again();
  if (inputs.empty()) inputs = robot_parts_.take_to_map_again();
  const bool has_other_scans = !inputs.empty();
  if (!has_other_scans) inputs = unjudged_.take_to_map_again(tracker_.odometry().verdict);
  if (inputs.empty()) return nullptr;
  auto again = std::make_unique<Parts>(params_);
  again->sweeps_ = sweeps_;
  again->robot_parts_ = robot_parts_;
  if (!has_other_scans) {
    again->tracker_.judge_odometry_by(tracker_.judged_odometry());
    again->unjudged_.close();
  }
  for (const MapperInput& input : inputs) {
    if (const auto* rate = std::get_if<MapperTurnRate>(&input)) {
      again->turn(rate->stamp, rate->turn_rad_per_s);
    } else {
      const auto& [scan, T_wheels_base] = std::get<MapperScan>(input);
      last = again->map(scan, T_wheels_base);
    }
  }
  return again;
}

TrackedPose Mapper::Parts::add_cleared(const Scan& scan,
                                       const std::optional<Pose2>& T_wheels_base) {
  if (!scanners_.admit(scan, T_wheels_base, tracker_)) {
    return tracker_.expected(scan, T_wheels_base);
  }
  num_with_odometry_ += T_wheels_base.has_value();
  const TrackedPose tracked = tracker_.track(scan, T_wheels_base);
  const double open_sigma_m = uncertainty_.add(tracked, {scan.scanner, scan.stamp});
  scans_.push_back(
      {scan.stamp, tracked, scan.T_base_sensor, open_sigma_m, uncertainty_.open_turn_sigma_rad()});
  const Scan& placed = tracker_.deskewed_scan() ? *tracker_.deskewed_scan() : scan;
  kept_.add(tracked, scan.scanner, [&]() -> std::shared_ptr<const Scan> {
    if (!tracked.is_keyframe) return std::make_shared<const Scan>(placed);
    const KeyframePtr& keyframe = tracker_.submap().back();
    return {keyframe, &keyframe->scan};
  });
  if (!tracked.is_keyframe) return tracked;

  add_keyframe(placed);
  if (track_.size() >= next_closing(num_closed_)) {
    close_loops(
        turn_checks_.fuse(track_, evidence_, params_.heading).heading_rad, track_.size(), closer_);
    num_closed_ = track_.size();
  }
  return tracked;
}

void Mapper::Parts::add_keyframe(const Scan& scan) {
  const TrackedPose& tracked = scans_.back().tracked;
  const bool is_first = track_.keyframes.empty();
  track_.keyframes.push_back(tracker_.submap().back());
  const double share_of_place = 1.0 / static_cast<double>(tracker_.num_scanners());
  track_.motions.push_back(uncertainty_.take(share_of_place));
  const bool is_restart = tracked.is_restart && !is_first;
  const bool is_tied = track_.motions.back().has_odometry;
  const std::size_t stretch = is_first ? 0 : track_.stretches.back();
  const std::size_t piece = is_first ? 0 : track_.pieces.back();
  track_.stretches.push_back(stretch + (is_restart ? 1 : 0));
  track_.pieces.push_back(piece + (is_restart && !is_tied ? 1 : 0));

  evidence_.push_back(
      {.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
       .step_sigma_rad = std::sqrt(track_.motions.back().rotation_rad2),
       .proposals = heading_proposals(scan, params_.direction, params_.confident_margin)});
  share_place(share_of_place, evidence_.back());
}

PoseGraph Mapper::Parts::graph_along(std::span<const double> headings_rad,
                                     const LoopCloser& closer) const {
  PoseGraph graph = pose_graph_of(track_, headings_rad);
  const std::vector<ComparedPlaces>& compared = closer.compared();
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (!is_accepted(compared[i].verdict.reason)) continue;
    graph.constraints.push_back(closure_constraint(compared[i]));
    graph.constraints.back().source = i;
  }
  return graph;
}

void Mapper::Parts::close_loops(std::span<const double> headings_rad,
                                std::size_t num_keyframes,
                                LoopCloser& closer) const {
  PoseGraph graph = graph_along(headings_rad, closer);
  loosen_across(track_.size() - 1, false, graph);
  const std::vector<Eigen::Vector2d> positions_m = solve_positions(graph);
  for (std::size_t k = 0; k < positions_m.size(); ++k) {
    graph.T_map_node[k].x_m = positions_m[k].x();
    graph.T_map_node[k].y_m = positions_m[k].y();
  }
  closer.extend(track_, num_keyframes, graph.T_map_node, params_.num_threads);
}

std::size_t Mapper::Parts::next_closing(std::size_t num_closed) const {
  const auto growth =
      static_cast<std::size_t>(params_.closing_growth * static_cast<double>(num_closed));
  return num_closed + std::max(params_.min_closing_growth, growth);
}

Mapper::Parts::Closed Mapper::Parts::close_one_piece() const {
  TurnChecks checks = turn_checks_;
  Closed closed{.headings = checks.fuse(track_, evidence_, params_.heading),
                .closer = closer_,
                .joined = {.turn_rad = {0.0}, .is_joined = {true}, .joints = {}}};
  close_loops(closed.headings.heading_rad, track_.size(), closed.closer);
  return closed;
}

Mapper::Parts::Closed Mapper::Parts::close_across_pieces() const {
  TurnChecks checks = turn_checks_;
  const FusedHeadings apart = checks.fuse(track_, evidence_, params_.heading);
  const PoseGraph graph = pose_graph_of(track_, apart.heading_rad);
  JoinedPieces joined =
      join_pieces(track_, graph.T_map_node, params_.closing, params_.joining, params_.num_threads);
  Closed closed{.headings = checks.fuse(
                    track_, evidence_of_joined(evidence_, track_, joined), params_.heading),
                .closer = LoopCloser(params_.closing),
                .joined = std::move(joined)};
  closed.closer.add_joints(closed.joined.joints);
  close_all_loops(closed);
  return closed;
}

Map Mapper::Parts::finish() const {
  if (track_.size() == 0) {
    Map map = assemble_map({.scans = scans_, .kept_scans = kept_.kept(), .track = track_});
    add_sensors(map);
    return map;
  }
  Closed closed = track_.pieces.back() > 0 ? close_across_pieces() : close_one_piece();
  Map map = map_of(closed);
  if (params_.audit.is_on) audit_and_mend(closed, map);
  return map;
}

Map Mapper::Parts::map_of(const Closed& closed) const {
  PoseGraph graph = graph_along(closed.headings.heading_rad, closed.closer);
  graph.headings = heading_measurements(closed.headings);
  if (track_.size() > 1) {
    loosen_across(track_.size() - 1, true, graph);
    solve_robustly(graph, {}, params_.robust);
    graph.T_map_node = registered_poses(closed.closer, graph);
  }
  // Errors of neighbours are correlated: num_alike measurements have the information of one.
  // Registration takes each as independent, which serves the poses; covariances come from this
  // graph.
  for (HeadingMeasurement& heading : graph.headings) {
    heading.information_per_rad2 /= params_.heading.num_alike;
  }
  Map map = assemble_map({.scans = scans_,
                          .kept_scans = kept_.kept(),
                          .track = track_,
                          .headings = closed.headings,
                          .compared = closed.closer.compared(),
                          .is_joined = closed.joined.is_joined,
                          .graph = graph});
  add_sensors(map);
  add_certainty(map, params_.motion);
  return map;
}

void Mapper::Parts::add_sensors(Map& map) const {
  map.scanners = scanners_.results();
  map.gyro = tracker_.gyro();
  map.odometry = tracker_.odometry();
  map.odometry.num_ignored += odometry_.num_ignored();
  map.sweep = sweeps_.report();
  map.num_with_odometry = num_with_odometry_;
}

void Mapper::Parts::audit_and_mend(Closed& closed, Map& map) const {
  std::vector<ScanSurfacesPtr> surfaces;
  surfaces.reserve(track_.size());
  for (const KeyframePtr& keyframe : track_.keyframes) surfaces.push_back(keyframe->surfaces);
  const auto audited = [&](const Map& audited_map) {
    return audit(audited_map, surfaces, params_.audit, params_.num_threads);
  };
  AuditFindings findings = audited(map);
  for (int round = 0; round < params_.audit.max_mendings; ++round) {
    const std::vector<MapHypothesis> hypotheses = findings.hypotheses();
    if (hypotheses.empty()) break;
    Closed mended = closed_with(closed, hypotheses);
    Map mended_map = map_of(mended);
    AuditFindings of_mended = audited(mended_map);
    if (!explains_more(of_mended.report, findings.report)) break;
    closed = std::move(mended);
    map = std::move(mended_map);
    findings = std::move(of_mended);
  }
  add_findings(findings, params_.audit, map);
}

Mapper::Parts::Closed Mapper::Parts::closed_with(
    const Closed& closed, const std::vector<MapHypothesis>& hypotheses) const {
  Closed mended{
      .headings = closed.headings, .closer = LoopCloser(params_.closing), .joined = closed.joined};
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

void Mapper::Parts::close_all_loops(Closed& closed) const {
  for (std::size_t end = 0; end < track_.size();) {
    end = std::min(next_closing(end), track_.size());
    close_loops(closed.headings.heading_rad, end, closed.closer);
  }
}

std::vector<Pose2> Mapper::Parts::registered_poses(const LoopCloser& closer,
                                                   const PoseGraph& graph) const {
  // Registration compares the places that closures name again. Apart from its own comparisons
  // it gives little weight to the tracked motion, which is made of the same scans, and to the other
  // closures.
  PoseGraph to_register{
      .T_map_node = graph.T_map_node, .constraints = {}, .headings = graph.headings};
  std::vector<Constraint> revisits;
  for (const Constraint& constraint : graph.constraints) {
    const bool is_closure = constraint.kind == ConstraintKind::kLoopClosure;
    if (is_closure && constraint.weight >= kMinRevisitWeight &&
        closer.compared()[constraint.source].verdict.axes == ClosureAxes::kXY) {
      revisits.push_back(constraint);
      continue;
    }
    to_register.constraints.push_back(constraint);
    if (!is_closure) to_register.constraints.back().weight *= kTrackedMotionWeight;
  }
  register_keyframes(track_, revisits, to_register, params_.registration, params_.num_threads);
  return std::move(to_register.T_map_node);
}

Mapper::Mapper() : Mapper(MapperParams{}) {}
Mapper::Mapper(const MapperParams& params) : parts_(std::make_unique<Parts>(params)) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

TrackedPose Mapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  TrackedPose tracked = parts_->add(scan, T_wheels_base);
  if (auto again = parts_->mapped_again(tracked)) parts_ = std::move(again);
  return tracked;
}

void Mapper::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  parts_->add_turn_rate(stamp, turn_rad_per_s);
}

Map Mapper::finish() const { return parts_->finish(); }

std::size_t Mapper::num_scans() const { return parts_->num_scans(); }

}  // namespace setsquare
