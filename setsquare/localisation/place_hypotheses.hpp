// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localisation_params.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/localisation/place_probability.hpp"
#include "setsquare/localisation/place_search.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// The second half of Localizer: where tracking has each scan in, where the robot is in the map
/// out. Places where it may be are weighed by scan after scan, laid onto the map, and dropped.
///
/// What it does depends on the scans and poses alone, not on when they come: it may run behind
/// tracking, on another thread.
class PlaceHypotheses {
 public:
  /// Throws ParameterError that names the field.
  PlaceHypotheses(std::shared_ptr<const KnownMap> map, const LocalisationParams& params);

  /// The next scan, as LocalizerTracker gives it.
  LocalisedPose add(const TrackedPose& tracked, const Scan& scan);
  /// As Localizer::set_pose().
  void set_pose(const Pose2& T_map_base);

 private:
  /// A place where the robot may be: where tracking's frame lies in the grid's.
  struct Hypothesis {
    Pose2 T_grid_odom;
    double log_odds = 0.0;           ///< Against "elsewhere", of all scans so far.
    double unjudged_log_odds = 0.0;  ///< Of these what scans said for it that the map cannot judge.
    /// Of the sensor's pose (x, y, theta) in the grid's frame.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

    /// A scan says something for or against it. All that the map cannot judge say no more for it
    /// than one may (kUnsure): a corridor whose end is not mapped looks the same from its other
    /// end, however often.
    void hear(double said_log_odds, bool is_judged);
  };

  /// A scan that spoke for or against places.
  struct PastScan {
    SoughtScan scan;
    Pose2 T_odom_sensor;
    PlaceScale scale;
    double weight = 0.0;
  };
  static constexpr std::size_t kMaxPast = 8;

  /// The hypotheses moved to where tracking has the scan.
  void move(const TrackedPose& tracked);
  /// Compares the scan with the map at each hypothesis and, if `searches`, at the best places of
  /// the whole map, which become hypotheses, too. `weight`: of what the scan says.
  void weigh(const SoughtScan& sought, double weight, bool searches);
  /// Whether a place that was found is another than those of the hypotheses, whose log odds by this
  /// scan are given.
  [[nodiscard]] bool is_another_place(const VerifiedPlace& place,
                                      double log_odds,
                                      std::span<const double> log_odds_of_hypotheses) const;
  /// What the scans of before say for a place that was not among their best.
  [[nodiscard]] double log_odds_of_past(const Hypothesis& hypothesis) const;
  /// Lays a hypothesis onto the map where the scan agrees.
  void fix(const VerifiedPlace& place, Hypothesis& hypothesis);
  /// Keeps what is near the pose that was said, and adds that pose if nothing is.
  void believe_said(const Scan& scan, const SoughtScan& sought);
  void drop_unlikely();
  /// Of the hypotheses, in their order.
  [[nodiscard]] std::vector<double> probabilities() const;
  [[nodiscard]] bool is_certain() const;
  [[nodiscard]] LocalisedPose answer(const Scan& scan) const;

  std::shared_ptr<const KnownMap> map_;
  LocalisationParams params_;
  std::vector<Hypothesis> hypotheses_;  ///< The most probable first.
  std::vector<PastScan> past_;          ///< The latest of them.
  std::optional<Pose2> said_;
  Pose2 T_odom_sensor_;   ///< Of the last scan.
  Pose2 T_odom_fixed_;    ///< Of the last scan that was laid onto the map.
  Pose2 T_odom_weighed_;  ///< Of the last one that spoke for or against places.
  bool has_weighed_ = false;
  bool is_confirmed_ = false;
  double certain_m_ = 0.0;  ///< Driven since one place became certain.
  double unconfirmed_m_ = 0.0;
  std::size_t num_scans_ = 0;
};

}  // namespace setsquare
