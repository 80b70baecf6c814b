// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/agreed_place.hpp"
#include "setsquare/tracking/deskew.hpp"
#include "setsquare/tracking/gyro.hpp"
#include "setsquare/tracking/keyframe.hpp"
#include "setsquare/tracking/long_steps.hpp"
#include "setsquare/tracking/motion_prediction.hpp"
#include "setsquare/tracking/odometry_trial.hpp"
#include "setsquare/tracking/prepared_keyframes.hpp"
#include "setsquare/tracking/repeated_scan.hpp"
#include "setsquare/tracking/scan_gap.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/submap_refinement.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

class ArrivedScan;
struct SuddenTurn;

/// Places scan after scan against a submap of the latest keyframes. The scans may come from several
/// scanners (Scan::scanner) in the order of time: each is expected where the last one, of whichever
/// scanner, left the robot's body (BodyMounting).
///
/// 1. Predict: from the odometry if there is any that has not been refuted (OdometryTrial), else
/// from
///    the last motion and the gyro. A scan that fits poorly where the odometry has it is placed as
///    if there were none, too.
/// 2. Refine: Gauss-Newton, point to line, against the surfaces of every keyframe of the submap.
/// 3. Where steps from scan to scan are long (LongSteps): the place that several keyframes, matched
///    with the scan without a guess, agree upon (agreed_place).
/// 4. Recover where the scan does not fit, or where the log has a gap that no odometry bridges: the
///    guess-free matcher, anywhere and at any turn. After a gap no other answer counts.
/// 5. Search along the corridor where the walls leave a direction free.
/// 6. Keep the scan as a keyframe where it is far enough from the last one.
///
/// A scan that says how long it swept is deskewed before each refinement, first by the motion that
/// is expected, then by the turns that the walls show (refined_turns); its pose is that of the
/// middle of its sweep.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParams& params = {});

  /// Places the next scan. `T_wheels_base` is the pose of the robot by wheel odometry, in any
  /// frame that stays put. The first scan stands at the identity. A scan with fewer than min_points
  /// returns is lost, at the predicted pose, and leaves the submap as it was; until one has more,
  /// there is no submap.
  TrackedPose track(const Scan& scan, const std::optional<Pose2>& T_wheels_base);

  /// A sample of a gyro about the robot's vertical axis, in the order of time with the scans.
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s) { gyro_.add(stamp, turn_rad_per_s); }
  [[nodiscard]] const GyroReport& gyro() const { return gyro_.report(); }
  [[nodiscard]] const OdometryReport& odometry() const { return odometry_.report(); }

  /// What the odometry was found to be, and the same for a tracker that begins with it.
  [[nodiscard]] OdometryTrial judged_odometry() const { return odometry_.judged(); }
  void judge_odometry_by(OdometryTrial judged) { odometry_ = std::move(judged); }

  /// Where a scan fits the submap, for a scanner whose mounting is not believed. Tracking goes on
  /// as if the scan had not come. Nothing where it fits nowhere, or there is no submap.
  [[nodiscard]] std::optional<MountingSighting> sight(const Scan& scan,
                                                      const std::optional<Pose2>& T_wheels_base);
  /// Where a scan is expected, which is not mapped. Not to be called before the first track().
  [[nodiscard]] TrackedPose expected(const Scan& scan,
                                     const std::optional<Pose2>& T_wheels_base) const;

  /// The last scan as it was placed where it was deskewed, else nothing.
  [[nodiscard]] const std::optional<Scan>& deskewed_scan() const { return deskewed_scan_; }

  /// How its sensor moved while it swept; rest where it was not deskewed.
  [[nodiscard]] const SweepMotion& sweep_motion() const { return sweep_motion_; }

  /// The scans kept that the next one is compared with, the latest at the back.
  [[nodiscard]] const std::vector<KeyframePtr>& submap() const { return submap_; }

  /// Scanners that the submap has keyframes of.
  [[nodiscard]] std::size_t num_scanners() const;

 private:
  /// What is known of a scan before it is placed.
  enum class Situation {
    kSeesTooLittle,   ///< Fewer than min_points returns: lost; the submap stays as it is.
    kSeesNothingNew,  ///< The last scan again though the wheels moved (RepeatedScan): the same.
    kNoSubmap,        ///< Nothing to place it against: it begins a submap where it is predicted.
    kExpected,        ///< Near the predicted pose, but for a slip of tracking.
    kAnywhere,        ///< A gap in the log, and no odometry: it may be anywhere.
  };
  /// What is expected of a scan.
  struct Expectation {
    Situation situation;
    Pose2 T_odom_sensor;
    bool has_odometry = false;  ///< Which predicted the pose.
  };

  /// Whether a scan speaks for or against the submap.
  [[nodiscard]] static bool is_evidence(Situation situation) {
    return situation != Situation::kSeesTooLittle && situation != Situation::kSeesNothingNew;
  }

  [[nodiscard]] Pose2 expected_body(const Scan& scan,
                                    const std::optional<Pose2>& T_believed_base) const;
  [[nodiscard]] std::optional<Pose2> body_by_wheels(
      const std::optional<Pose2>& T_believed_base) const {
    if (!T_believed_base) return std::nullopt;
    return *T_believed_base * T_base_body_;
  }
  [[nodiscard]] Expectation expectation_of(const ArrivedScan& scan,
                                           const std::optional<Pose2>& T_believed_base,
                                           bool is_gap) const;
  TrackedPose place(ArrivedScan& scan, const Expectation& expected);
  /// Whether a scan does not fit where the odometry has it.
  [[nodiscard]] bool is_poor(const TrackedPose& tracked) const;
  /// The scan, `tracked` by odometry where it fits poorly, as if there were none, and what is
  /// expected then; as it is where that is no better. Behind a gap in the log odometry that stood
  /// still bridges nothing: what was seen before it would be seen again.
  TrackedPose place_without_odometry(ArrivedScan& scan,
                                     bool is_gap,
                                     bool is_at_rest,
                                     const TrackedPose& tracked,
                                     Expectation& expected);
  [[nodiscard]] Situation situation_of(std::size_t num_points, bool is_behind_gap) const;
  /// As the scan is, from a place near the predicted one.
  TrackedPose place_expected(ArrivedScan& scan,
                             const Pose2& start,
                             const Pose2& predicted,
                             bool has_odometry);
  /// The same of a scan that is deskewed meanwhile.
  TrackedPose place_swept(ArrivedScan& scan, const Pose2& predicted, bool has_odometry);
  /// A place that a sudden turn leads to, with the sweep's motion; nothing where none is better
  /// than `tracked`. The scan is left deskewed by that motion, or by `motion`.
  std::optional<SweepMotion> place_turned(ArrivedScan& scan,
                                          const Pose2& predicted,
                                          bool has_odometry,
                                          const SweepMotion& motion,
                                          TrackedPose& tracked);
  /// The same of a scan that is not deskewed.
  TrackedPose place_taken_at_once(ArrivedScan& scan, const Pose2& predicted, bool has_odometry);
  /// The turn since the last scan, at which `unturned` was its heading, that explains a scan best.
  [[nodiscard]] SuddenTurn sudden_turn_from(const ArrivedScan& scan, const Pose2& unturned) const;
  /// Whether a scan fits better where a sudden turn leads to. Then `tracked` becomes that.
  bool improves(const TrackedPose& turned, TrackedPose& tracked) const;
  /// The motion by which the walls see a sweep bent least (refined_turns).
  [[nodiscard]] SweepMotion turns_seen(const ArrivedScan& scan,
                                       const Pose2& T_odom_sensor,
                                       const SweepMotion& motion,
                                       const SweepMotion& expected,
                                       bool is_first);
  /// Where the scan's sensor was at the last scan.
  [[nodiscard]] Pose2 last_sensor(const Scan& scan) const;
  /// How the sensor moves during its sweep if it moved evenly to a place since the last scan.
  [[nodiscard]] SweepMotion motion_to(const ArrivedScan& scan, const Pose2& T_odom_sensor) const;
  /// How uncertain the turns are that it is expected to make.
  [[nodiscard]] double turn_sigma_rad(const ArrivedScan& scan) const;
  /// For the kind of scan that clutter, people or noise pull aside in the submap: a step unlike
  /// what was expected (is_jolt) needs the last scan, matched with this one without a guess, for a
  /// witness. Where that contradicts it, its own place is tried, and believed where it fits better;
  /// else one of the two is wrong, and the scan departs by what they differ.
  TrackedPose seconded_by_last_scan(ArrivedScan& scan, const Pose2& predicted, TrackedPose tracked);
  TrackedPose place_anywhere(ArrivedScan& scan, const Pose2& predicted);
  /// Whether the robot can be there: no robot is metres ahead of where it was a scan ago.
  [[nodiscard]] bool is_within_reach(const SubmapFit& found, const Pose2& predicted) const;
  /// Whether several keyframes agree upon a place that is far from the expected one.
  [[nodiscard]] bool is_seconded(ArrivedScan& scan, const SubmapFit& found);
  /// Where a scan may be by the robot's motion alone: by the odometry, or as far as it went lately.
  [[nodiscard]] ExpectedStep expected_step(const ArrivedScan& scan,
                                           const Pose2& predicted,
                                           bool has_odometry) const;
  /// What the scan's place says against the odometry.
  void add_departure(const ExpectedStep& step, TrackedPose& tracked) const;
  /// A scan's points where matches have them, held there where the walls leave a direction open.
  [[nodiscard]] SubmapFit refined_at(const Pose2& place, const SurfaceSamples& points);
  /// The same, which may not carry the scan to another place.
  [[nodiscard]] SubmapFit held_at(const Pose2& place, const SurfaceSamples& points);
  /// The scan at the place that keyframes agree upon, matched with it one by one. `tracked`: the
  /// fit about the predicted pose, which stays where it is the same place.
  TrackedPose place_as_agreed(const TrackingProblem& problem,
                              const Pose2& place,
                              const std::optional<SubmapFit>& tracked);
  /// The scan at a likely place. What its matches leave open is as uncertain as they may be wrong
  /// by; where that is the turn, the scan counts as found again. `tracked`: as of place_as_agreed.
  [[nodiscard]] TrackedPose place_as_probable(const TrackingProblem& problem,
                                              const ProbablePlace& place,
                                              const SubmapFit& tracked);
  /// The scan where its walls fit, though nothing tells how far it is along them: among key frames
  /// in a corridor the last motion does not. Its heading, unless that was predicted, is what the
  /// keyframes' matches tell, which do not tell one way along a corridor from the other; a robot
  /// that does not turn that far does. Nothing where the walls fit nowhere, or determine the place.
  [[nodiscard]] std::optional<TrackedPose> place_along_walls(const TrackingProblem& problem,
                                                             std::span<const PlaceVote> votes,
                                                             const SubmapFit& tracked);
  /// A fit as an answer: lost where it is poor, searched along the corridor where one is open.
  TrackedPose judged(const TrackingProblem& problem, SubmapFit fit, bool is_recovered);
  /// A fit that scores less is looked at again. In a bare corridor the walls fit; where they leave
  /// a direction open and do not, the place is wrong.
  [[nodiscard]] double least_score(const SubmapFit& fit) const;
  /// Counts scans that are lost in a row. A scan that sees next to nothing, or the same again, is
  /// no evidence against the submap.
  void count_lost(TrackStatus status, Situation situation);
  /// Whether the submap restarts with the scan that was counted last.
  [[nodiscard]] bool is_restart(Situation situation) const;
  void start_anew();
  /// The step to the scan that was placed last, for what comes.
  void add_step(const TrackedPose& tracked, Situation situation);
  /// Compares the gyro with the turn from the last scan to this one, where both were tracked.
  void compare_gyro(const Scan& scan, const TrackedPose& tracked);
  void compare_odometry(const Scan& scan,
                        const TrackedPose& tracked,
                        Situation situation,
                        const std::optional<Pose2>& T_wheels_base);
  [[nodiscard]] bool is_to_be_kept(const Scan& scan, const TrackedPose& tracked) const;
  void keep(const Scan& scan, ScanSurfacesPtr surfaces, const TrackedPose& tracked);

  ScanTrackerParams params_;
  MotionPrediction motion_;
  ScanGap gap_;
  RepeatedScan repeated_;
  Gyro gyro_;
  OdometryTrial odometry_;
  Pose2 T_base_body_;
  std::vector<KeyframePtr> submap_;
  std::vector<PlacedImage> submap_images_;  ///< Of the same keyframes.
  PreparedKeyframes prepared_;              ///< The same keyframes.
  LongSteps long_steps_;
  PointMarks marks_;
  /// Of the last scan.
  struct Placed {
    Timestamp stamp;
    Pose2 T_odom_sensor;
    Pose2 T_odom_body;
    bool is_tracked = false;  ///< Without a jump.
  } last_;
  TrackedPose answer_;        ///< The last one.
  Scan last_scan_;            ///< As it was placed.
  double usual_score_ = 0.8;  ///< Of scans that are not lost, the latest above all.
  std::optional<Scan> deskewed_scan_;
  SweepMotion sweep_motion_;
  std::size_t num_scans_ = 0;
  std::size_t num_lost_ = 0;  ///< In a row, of the scans that see enough.
};

}  // namespace setsquare
