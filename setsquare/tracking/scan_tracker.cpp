// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/tracking/agreed_place.hpp"
#include "setsquare/tracking/arrived_scan.hpp"
#include "setsquare/tracking/jolt.hpp"
#include "setsquare/tracking/known_place.hpp"
#include "setsquare/tracking/recovery.hpp"
#include "setsquare/tracking/robot_body.hpp"
#include "setsquare/tracking/submap_answer.hpp"
#include "setsquare/tracking/submap_refinement.hpp"

namespace setsquare {
namespace {

/// Where it is expected, for it fits nowhere.
TrackedPose lost_at(const TrackingProblem& problem, const SubmapFit& fit) {
  return {.status = TrackStatus::kLost,
          .T_odom_sensor = problem.T_odom_predicted,
          .score = fit.alignment.score(),
          .open = fit.open};
}

/// Whether tracking followed a scan, without a jump.
bool is_followed(TrackStatus status) {
  return status == TrackStatus::kTracked || status == TrackStatus::kDegenerate;
}

}  // namespace

ScanTracker::ScanTracker(const ScanTrackerParams& params)
    : params_(params),
      motion_(params.num_scans_averaged),
      gap_(params.gap),
      gyro_(params.gyro),
      odometry_(params.odometry),
      long_steps_(params.long_steps) {
  params_.validate();
}

TrackedPose ScanTracker::track(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  ArrivedScan arrived(scan, params_);
  if (num_scans_ == 0) T_base_body_ = scan.T_base_sensor;
  const BodyMounting mounting(T_base_body_, scan.T_base_sensor);
  const bool is_gap = gap_.add(scan);
  const bool is_at_rest = odometry_.is_at_rest(T_wheels_base);
  const std::optional<Pose2> T_believed_base = odometry_.believed(T_wheels_base, scan.stamp);
  Expectation expected = expectation_of(arrived, T_believed_base, is_gap);
  if (repeated_.add(scan, T_believed_base)) expected.situation = Situation::kSeesNothingNew;
  // The same scan is of the same place, unless the wheels tell otherwise.
  const bool is_same_again = !T_believed_base && repeated_.is_same();
  if (is_same_again && expected.situation != Situation::kSeesTooLittle) {
    ++num_scans_;
    return told_again(answer_);
  }
  TrackedPose tracked = place(arrived, expected);
  if (expected.has_odometry && is_poor(tracked) && is_evidence(expected.situation)) {
    tracked = place_without_odometry(arrived, is_gap, is_at_rest, tracked, expected);
  }
  const Situation situation = expected.situation;
  tracked.T_odom_body = mounting.body_of(tracked.T_odom_sensor);
  tracked.has_odometry = expected.has_odometry;
  add_departure(expected_step(arrived, expected.T_odom_sensor, expected.has_odometry), tracked);
  tracked.is_long_step = long_steps_.are_usual();
  tracked.odometry_turn_deviation = odometry_.report().turn.deviation;
  tracked.sees_nothing_new = situation == Situation::kSeesNothingNew;
  count_lost(tracked.status, situation);
  tracked.is_restart = is_restart(situation);
  // Many scans in a row do not see again what was seen before: the robot was carried. Among key
  // frames one says so: none is taken where the robot stands.
  const bool is_carried = long_steps_.are_usual()
                              ? tracked.is_restart && odometry_.has_not_moved(T_wheels_base)
                              : num_lost_ >= params_.max_lost_scans && is_at_rest;
  if (is_carried) tracked.has_odometry = false;
  if (tracked.is_restart) start_anew();
  tracked.is_keyframe = is_evidence(situation) && is_to_be_kept(scan, tracked);
  if (tracked.is_keyframe) keep(arrived.scan(), arrived.surfaces(), tracked);
  last_scan_ = arrived.scan();
  sweep_motion_ = arrived.motion();
  deskewed_scan_ = arrived.take_deskewed();
  motion_.add(tracked.T_odom_body, body_by_wheels(T_believed_base), {scan.scanner, scan.stamp});
  if (tracked.status == TrackStatus::kRecovered || tracked.is_restart) motion_.restart();
  add_step(tracked, situation);
  compare_gyro(scan, tracked);
  compare_odometry(scan, tracked, situation, T_wheels_base);
  ++num_scans_;
  answer_ = tracked;
  if (tracked.status != TrackStatus::kLost) usual_score_ += 0.1 * (tracked.score - usual_score_);
  return tracked;
}

ScanTracker::Expectation ScanTracker::expectation_of(const ArrivedScan& scan,
                                                     const std::optional<Pose2>& T_believed_base,
                                                     bool is_gap) const {
  const bool has_odometry = motion_.has_odometry(body_by_wheels(T_believed_base));
  return {.situation = situation_of(scan.num_points(), is_gap && !has_odometry),
          .T_odom_sensor = BodyMounting(T_base_body_, scan.arrived().T_base_sensor)
                               .sensor_of(expected_body(scan.arrived(), T_believed_base)),
          .has_odometry = has_odometry};
}

TrackedPose ScanTracker::place(ArrivedScan& scan, const Expectation& expected) {
  const Pose2& predicted = expected.T_odom_sensor;
  switch (expected.situation) {
    case Situation::kSeesTooLittle:
    case Situation::kSeesNothingNew:
      return {.status = TrackStatus::kLost, .T_odom_sensor = predicted, .score = 0.0, .open = {}};
    case Situation::kNoSubmap:
      return {.T_odom_sensor = predicted, .open = {}};
    case Situation::kExpected:
      return seconded_by_last_scan(
          scan, predicted, place_swept(scan, predicted, expected.has_odometry));
    case Situation::kAnywhere:
      return place_anywhere(scan, predicted);
  }
  return {};
}

bool ScanTracker::is_poor(const TrackedPose& tracked) const {
  const RecoveryParams& recovery = params_.recovery;
  const bool is_open = tracked.status == TrackStatus::kDegenerate;
  return tracked.status == TrackStatus::kLost || tracked.status == TrackStatus::kRecovered ||
         tracked.score < (is_open ? recovery.below_score_if_open : recovery.below_score);
}

TrackedPose ScanTracker::place_without_odometry(ArrivedScan& scan,
                                                bool is_gap,
                                                bool is_at_rest,
                                                const TrackedPose& tracked,
                                                Expectation& expected) {
  const bool is_on = params_.odometry.is_on && (!is_gap || is_at_rest);
  if (!is_on || expected.situation != Situation::kExpected) return tracked;
  const SweepMotion motion = scan.motion();
  const Expectation other = expectation_of(scan, std::nullopt, is_gap);
  const TrackedPose without = place(scan, other);
  const bool is_same = tracked.status == TrackStatus::kRecovered && !is_poor(without) &&
                       is_same_place(without.T_odom_sensor, tracked.T_odom_sensor, params_.votes);
  const bool is_better = without.status != TrackStatus::kLost &&
                         without.score > tracked.score + params_.recovery.min_gain;
  if (is_gap || is_same || is_better) {
    expected = other;
    return without;
  }
  if (scan.sweep_s() != 0.0) scan.deskew(motion);
  return tracked;
}

void ScanTracker::compare_odometry(const Scan& scan,
                                   const TrackedPose& tracked,
                                   Situation situation,
                                   const std::optional<Pose2>& T_wheels_base) {
  if (situation == Situation::kSeesNothingNew) return;  // Until the next scan is new.
  const OdometryTrialParams& params = params_.odometry;
  const bool is_certain = situation == Situation::kExpected &&
                          tracked.status == TrackStatus::kTracked &&
                          tracked.score >= params.min_score &&
                          tracked.open.effective_points >= params.min_effective_points;
  odometry_.add(T_wheels_base,
                {.stamp = scan.stamp,
                 .T_odom_base = tracked.T_odom_body * T_base_body_.inverse(),
                 .is_placed = tracked.status != TrackStatus::kLost || tracked.is_restart,
                 .is_restart = tracked.is_restart && !tracked.has_odometry,
                 .is_certain = is_certain});
}

std::optional<MountingSighting> ScanTracker::sight(const Scan& scan,
                                                   const std::optional<Pose2>& T_wheels_base) {
  ArrivedScan arrived(scan, params_);
  if (situation_of(arrived.num_points(), false) != Situation::kExpected) return std::nullopt;
  const TrackedPose start = expected(scan, T_wheels_base);
  const TrackedPose seen = place_swept(arrived, start.T_odom_sensor, start.has_odometry);
  if (seen.status == TrackStatus::kLost) return std::nullopt;
  return MountingSighting{seen.T_odom_sensor, seen.status != TrackStatus::kDegenerate};
}

TrackedPose ScanTracker::expected(const Scan& scan,
                                  const std::optional<Pose2>& T_wheels_base) const {
  const std::optional<Pose2> T_believed_base = odometry_.believed(T_wheels_base, scan.stamp);
  TrackedPose expected;
  expected.is_mapped = false;
  expected.has_odometry = motion_.has_odometry(body_by_wheels(T_believed_base));
  expected.T_odom_body = expected_body(scan, T_believed_base);
  expected.T_odom_sensor =
      BodyMounting(T_base_body_, scan.T_base_sensor).sensor_of(expected.T_odom_body);
  return expected;
}

Pose2 ScanTracker::expected_body(const Scan& scan,
                                 const std::optional<Pose2>& T_believed_base) const {
  if (num_scans_ == 0) return {};
  return motion_.next(body_by_wheels(T_believed_base),
                      {scan.scanner, scan.stamp},
                      gyro_.turn_rad(last_.stamp, scan.stamp));
}

void ScanTracker::add_step(const TrackedPose& tracked, Situation situation) {
  if (situation != Situation::kExpected || tracked.status == TrackStatus::kLost) return;
  long_steps_.add(last_.T_odom_body.inverse() * tracked.T_odom_body);
}

void ScanTracker::compare_gyro(const Scan& scan, const TrackedPose& tracked) {
  const Placed now{
      scan.stamp, tracked.T_odom_sensor, tracked.T_odom_body, is_followed(tracked.status)};
  if (last_.is_tracked && now.is_tracked) {
    gyro_.compare(last_.stamp,
                  now.stamp,
                  wrap_to_pi(now.T_odom_body.theta_rad - last_.T_odom_body.theta_rad));
  }
  last_ = now;
}

ScanTracker::Situation ScanTracker::situation_of(std::size_t num_points, bool is_behind_gap) const {
  if (num_points < params_.min_points) return Situation::kSeesTooLittle;
  if (submap_.empty()) return Situation::kNoSubmap;
  return is_behind_gap ? Situation::kAnywhere : Situation::kExpected;
}

Pose2 ScanTracker::last_sensor(const Scan& scan) const {
  return BodyMounting(T_base_body_, scan.T_base_sensor).sensor_of(last_.T_odom_body);
}

TrackedPose ScanTracker::place_expected(ArrivedScan& scan,
                                        const Pose2& start,
                                        const Pose2& predicted,
                                        bool has_odometry) {
  const SurfaceSamples points = scan.all_points();
  const PredictionTrust& trust =
      has_odometry ? params_.trust_in_odometry : params_.trust_in_last_motion;
  const TrackingProblem problem{submap_images_, points, predicted, trust, marks_};
  SubmapFit fit = refine_in_submap(problem, start, params_.refinement);
  // In a round hall keyframes agree upon any turn.
  const bool fits_at_any_turn =
      fit.turn.bound_share < 1.0 && fit.alignment.score() >= least_score(fit);
  if (long_steps_.are_expected() && !fits_at_any_turn) {
    const std::vector<PlaceVote>& votes = scan.votes(prepared_);
    const ExpectedStep step = expected_step(scan, predicted, has_odometry);
    const auto agreed = agreed_place(votes, step, params_.votes);
    const bool fits_as_driven =
        fit.alignment.score() >= least_score(fit) && is_within(step, fit.T_odom_sensor);
    if (agreed && !is_refuted(*agreed, step, fits_as_driven, params_.votes)) {
      return place_as_agreed(problem, agreed->T_odom_sensor, fit);
    }
    if (!has_odometry) {
      const bool is_poor = fit.alignment.score() < least_score(fit);
      const auto probable = is_poor ? probable_place(votes, step, params_.votes) : std::nullopt;
      if (probable) return place_as_probable(problem, *probable, fit);
      if (long_steps_.are_usual()) {
        const auto along = place_along_walls(problem, votes, fit);
        if (along) return *along;
        if (is_poor) return lost_at(problem, fit);
      }
    }
  }
  bool is_recovered = false;
  if (fit.alignment.score() < least_score(fit)) {
    const auto found =
        recover(problem, submap_, scan.surfaces(), fit, params_.recovery, params_.refinement);
    const bool is_believed = found && (!found->is_far || (is_within_reach(found->fit, predicted) &&
                                                          is_seconded(scan, found->fit)));
    if (is_believed) fit = found->fit;
    is_recovered = is_believed && found->is_far;
  }
  return judged(problem, std::move(fit), is_recovered);
}

TrackedPose ScanTracker::place_anywhere(ArrivedScan& scan, const Pose2& predicted) {
  const SurfaceSamples points = scan.all_points();
  const TrackingProblem problem{
      submap_images_, points, predicted, params_.trust_in_last_motion, marks_};
  if (long_steps_.are_usual()) {
    // Among key frames a pause says nothing of how far the robot went.
    const auto agreed = agreed_place(scan.votes(prepared_), std::nullopt, params_.votes);
    if (agreed) return place_as_agreed(problem, agreed->T_odom_sensor, std::nullopt);
  }
  const auto found = recover(
      problem, submap_, scan.surfaces(), std::nullopt, params_.recovery, params_.refinement);
  if (found && is_seconded(scan, found->fit)) return judged(problem, found->fit, found->is_far);
  const SubmapFit fit = refine_in_submap(problem, predicted, params_.refinement);
  return {.status = TrackStatus::kLost, .T_odom_sensor = predicted, .score = 0.0, .open = fit.open};
}

bool ScanTracker::is_within_reach(const SubmapFit& found, const Pose2& predicted) const {
  const double reach_m = (1.0 + static_cast<double>(num_lost_)) * long_steps_.reach().distance_m;
  return (found.T_odom_sensor.translation() - predicted.translation()).norm() <= reach_m;
}

bool ScanTracker::is_seconded(ArrivedScan& scan, const SubmapFit& found) {
  const auto agreed = agreed_place(scan.votes(prepared_), std::nullopt, params_.votes);
  return agreed && agreed->votes >= params_.votes.min_votes_for_jump &&
         is_same_place(agreed->T_odom_sensor, found.T_odom_sensor, params_.votes);
}

ExpectedStep ScanTracker::expected_step(const ArrivedScan& scan,
                                        const Pose2& predicted,
                                        bool has_odometry) const {
  using By = ExpectedStep::By;
  if (!has_odometry) return {last_.T_odom_sensor, long_steps_.reach()};
  const Pose2 step = last_sensor(scan.arrived()).inverse() * predicted;
  const StepReach near{params_.recovery.near_m, params_.recovery.near_rad};
  if (!moves(step)) return {predicted, near};  // A counter may have hung.
  const auto proved = odometry_.proved_reach(step);
  if (proved) return {predicted, *proved, By::kProvedOdometry};
  return {predicted, near, By::kOdometry};
}

void ScanTracker::add_departure(const ExpectedStep& step, TrackedPose& tracked) const {
  const auto departure = departure_from(step, tracked.T_odom_sensor);
  if (!departure || tracked.status == TrackStatus::kLost) return;
  if (step.by == ExpectedStep::By::kProvedOdometry) tracked.departure = *departure;
  if (long_steps_.are_usual()) tracked.has_odometry = false;  // It did not predict this one.
}

SubmapFit ScanTracker::refined_at(const Pose2& place, const SurfaceSamples& points) {
  const TrackingProblem at_place{submap_images_, points, place, params_.trust_in_odometry, marks_};
  return refine_in_submap(at_place, place, params_.refinement);
}

SubmapFit ScanTracker::held_at(const Pose2& place, const SurfaceSamples& points) {
  SubmapFit fit = refined_at(place, points);
  if (!is_same_place(place, fit.T_odom_sensor, params_.votes)) fit.T_odom_sensor = place;
  return fit;
}

TrackedPose ScanTracker::place_as_agreed(const TrackingProblem& problem,
                                         const Pose2& place,
                                         const std::optional<SubmapFit>& tracked) {
  const bool is_where_expected = tracked && tracked->alignment.score() >= least_score(*tracked) &&
                                 is_same_place(place, tracked->T_odom_sensor, params_.votes);
  if (is_where_expected) return judged(problem, *tracked, false);
  return answer_of(held_at(place, problem.points), params_.refinement);
}

TrackedPose ScanTracker::place_as_probable(const TrackingProblem& problem,
                                           const ProbablePlace& place,
                                           const SubmapFit& tracked) {
  if (!place.is_open) return place_as_agreed(problem, place.T_odom_sensor, tracked);
  TrackedPose answer = answer_of(held_at(place.T_odom_sensor, problem.points), params_.refinement);
  if (!place.open_direction_rad) {
    answer.status = TrackStatus::kRecovered;
    return answer;
  }
  const double wrong_sigma_m = std::sqrt(1.0 - place.probability) * long_steps_.reach().distance_m;
  answer.status = TrackStatus::kDegenerate;
  answer.open.direction = {std::cos(*place.open_direction_rad),
                           std::sin(*place.open_direction_rad)};
  answer.open_sigma_m = std::hypot(params_.votes.least_open_sigma_m, wrong_sigma_m);
  return answer;
}

std::optional<TrackedPose> ScanTracker::place_along_walls(const TrackingProblem& problem,
                                                          std::span<const PlaceVote> votes,
                                                          const SubmapFit& tracked) {
  const StepReach reach = long_steps_.reach();
  SubmapFit best = tracked;
  const auto try_heading = [&](double heading_rad) {
    if (std::abs(wrap_to_pi(heading_rad - last_.T_odom_sensor.theta_rad)) > reach.turn_rad) return;
    const Pose2 start{
        problem.T_odom_predicted.x_m, problem.T_odom_predicted.y_m, wrap_to_pi(heading_rad)};
    const SubmapFit fit = refine_in_submap(problem, start, params_.refinement);
    if (fit.alignment.score() > best.alignment.score()) best = fit;
  };
  for (const PlaceVote& vote : votes) {
    if (vote.status != MatchStatus::kDegenerate) continue;
    try_heading(vote.T_odom_sensor.theta_rad);
    try_heading(vote.T_odom_sensor.theta_rad + kPi);
  }
  if (!is_open(best, params_.refinement) ||
      best.alignment.score() < params_.recovery.below_score_if_open) {
    return std::nullopt;
  }
  return TrackedPose{.status = TrackStatus::kDegenerate,
                     .T_odom_sensor = best.T_odom_sensor,
                     .score = best.alignment.score(),
                     .open = best.open,
                     .open_bound_share = params_.refinement.bound_share(best.open.effective_points),
                     .open_sigma_m = reach.distance_m};
}

TrackedPose ScanTracker::judged(const TrackingProblem& problem, SubmapFit fit, bool is_recovered) {
  if (fit.alignment.score() < params_.lost_below_score) return lost_at(problem, fit);
  if (fit.open.effective_points < params_.corridor.below_effective_points) {
    fit = search_along_corridor(problem, fit, params_.corridor, params_.refinement);
  }
  TrackedPose tracked = answer_of(fit, params_.refinement);
  if (is_recovered) tracked.status = TrackStatus::kRecovered;
  return tracked;
}

TrackedPose ScanTracker::seconded_by_last_scan(ArrivedScan& scan,
                                               const Pose2& predicted,
                                               TrackedPose tracked) {
  const JoltParams& params = params_.jolts;
  const bool is_asked = is_followed(tracked.status) && last_.is_tracked &&
                        !long_steps_.are_usual() &&
                        is_jolt(predicted, tracked.T_odom_sensor, params);
  if (!is_asked) return tracked;
  const ScanSurfacesPtr last = scan_surfaces(
      last_scan_, surface_points_from_scan(last_scan_, params_.surfaces), params_.image);
  const MatchResult match =
      setsquare::match(prepare(last), prepare(scan.surfaces()), params_of_a_known_place());
  if (!match.T_reference_current) return tracked;
  const Pose2 place = last_.T_odom_sensor * *match.T_reference_current;
  if (!is_contradicted(predicted, tracked.T_odom_sensor, place, params)) return tracked;
  if (match.status == MatchStatus::kMatched && scan.scan().num_beams() >= params.min_beams) {
    const SurfaceSamples points = scan.all_points();
    const SubmapFit fit = refined_at(place, points);
    const bool stays =
        !is_beyond(place.inverse() * fit.T_odom_sensor, params.same_m, params.same_rad);
    if (stays && fit.alignment.score() > tracked.score) return answer_of(fit, params_.refinement);
  }
  tracked.departure = reach_of(place.inverse() * tracked.T_odom_sensor);
  return tracked;
}

double ScanTracker::least_score(const SubmapFit& fit) const {
  return is_open(fit, params_.refinement) ? params_.recovery.below_score_if_open
                                          : params_.recovery.below_score;
}

void ScanTracker::count_lost(TrackStatus status, Situation situation) {
  if (!is_evidence(situation)) return;
  const std::size_t num_new = repeated_.is_same() ? 0 : 1;
  num_lost_ = status == TrackStatus::kLost ? num_lost_ + num_new : 0;
}

bool ScanTracker::is_restart(Situation situation) const {
  if (!is_evidence(situation) || num_lost_ == 0) return false;
  if (situation == Situation::kAnywhere || long_steps_.are_usual()) return true;
  return num_lost_ >= params_.max_lost_scans;
}

/// The old keyframes' poses no longer mean anything to the coming scans.
void ScanTracker::start_anew() {
  submap_.clear();
  submap_images_.clear();
  prepared_.clear();
  num_lost_ = 0;
}

bool ScanTracker::is_to_be_kept(const Scan& scan, const TrackedPose& tracked) const {
  if (submap_.empty()) return true;
  if (tracked.status == TrackStatus::kLost) return false;  // It would stand at a guessed place.
  if (tracked.open_sigma_m > 0.0) return true;             // How far it is off is not known.
  const auto last = std::find_if(submap_.rbegin(), submap_.rend(), [&](const KeyframePtr& kept) {
    return kept->scan->scanner == scan.scanner;
  });
  if (last == submap_.rend()) return true;
  const Pose2 moved = (*last)->T_odom_body.inverse() * tracked.T_odom_body;
  return is_beyond(moved, params_.keyframe_distance_m, params_.keyframe_turn_rad);
}

std::size_t ScanTracker::num_scanners() const {
  std::set<std::uint32_t> scanners;
  for (const KeyframePtr& keyframe : submap_) scanners.insert(keyframe->scan->scanner);
  return scanners.size();
}

void ScanTracker::keep(const Scan& scan, ScanSurfacesPtr surfaces, const TrackedPose& tracked) {
  if (submap_.size() >= params_.num_keyframes * std::max<std::size_t>(1, num_scanners())) {
    submap_.erase(submap_.begin());
    submap_images_.erase(submap_images_.begin());
    prepared_.drop_first();
  }
  submap_.push_back(std::make_shared<Keyframe>(Keyframe{.scan_index = num_scans_,
                                                        .T_odom_sensor = tracked.T_odom_sensor,
                                                        .T_odom_body = tracked.T_odom_body,
                                                        .scan = std::make_shared<const Scan>(scan),
                                                        .surfaces = std::move(surfaces)}));
  submap_images_.push_back({&submap_.back()->image(), tracked.T_odom_sensor});
  prepared_.add(submap_.back());
}

}  // namespace setsquare
