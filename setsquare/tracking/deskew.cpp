// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/deskew.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <limits>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/surfaces/surface_points.hpp"

namespace setsquare {
namespace {

/// Beams apart that the motion has spread: what lies between two of them was seen by neither, if
/// they do not show one surface.
constexpr double kWidestGap_steps = 2.0;

/// (sin(angle), 1 - cos(angle)) / angle.
Eigen::Vector2d chord_factors(double angle_rad) {
  if (std::abs(angle_rad) < 1e-9) return {1.0, 0.5 * angle_rad};
  const double half_sin = std::sin(0.5 * angle_rad);
  return {std::sin(angle_rad) / angle_rad, 2.0 * half_sin * half_sin / angle_rad};
}

/// Where a sensor is that went a way along an arc, `way_m` at its begin and the angle in all.
Pose2 along_arc(const Eigen::Vector2d& way_m, double angle_rad) {
  const Eigen::Vector2d f = chord_factors(angle_rad);
  return {f.x() * way_m.x() - f.y() * way_m.y(), f.y() * way_m.x() + f.x() * way_m.y(), angle_rad};
}

/// A beam taken to the middle of the sweep.
struct MovedBeam {
  BeamOutcome outcome = BeamOutcome::kInvalid;
  double place = 0.0;    ///< Among the beams of the scan, in steps; -0.3 is before the first.
  double range_m = 0.0;  ///< From where the sensor was in the middle; codes stay.
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  double share = 0.0;
};

MovedBeam moved_beam(const Scan& scan, std::size_t beam, const SweepMotion& motion) {
  MovedBeam moved{.outcome = scan.outcome(beam),
                  .range_m = scan.ranges_m[beam],
                  .share = sweep_share(beam, scan.num_beams())};
  const double bearing_rad = scan.bearing_rad(beam);
  double turned_rad = motion.turn_at(moved.share);
  if (moved.outcome == BeamOutcome::kReturn) {
    const Eigen::Vector2d direction{std::cos(bearing_rad), std::sin(bearing_rad)};
    moved.point_m = motion.pose_at(moved.share) * Eigen::Vector2d(moved.range_m * direction);
    moved.range_m = moved.point_m.norm();
    turned_rad = wrap_to_pi(std::atan2(moved.point_m.y(), moved.point_m.x()) - bearing_rad);
  }
  moved.place = static_cast<double>(beam) + turned_rad / scan.bearing_step_rad;
  return moved;
}

/// Which beams show the same surface as the next one.
std::vector<bool> joined_to_next(const Scan& scan, const SurfaceParams& params) {
  std::vector<bool> is_joined(scan.num_beams(), false);
  const SurfacePoints points = surface_points_from_scan(scan, params);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool is_next = points.beam[i + 1] == points.beam[i] + 1;
    is_joined[static_cast<std::size_t>(points.beam[i])] = points.joined[i] != 0 && is_next;
  }
  return is_joined;
}

/// The range of a ray to the line through two points; nothing sensible where it runs along it.
double range_to_line(double bearing_rad, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d normal{a.y() - b.y(), b.x() - a.x()};
  return normal.dot(a) / (normal.x() * std::cos(bearing_rad) + normal.y() * std::sin(bearing_rad));
}

/// The ranges of the deskewed scan, each with the beam that it is of.
class Resampling {
 public:
  Resampling(const Scan& scan, std::vector<float>& share)
      : scan_(scan),
        ranges_m_(scan.num_beams(), std::numeric_limits<double>::quiet_NaN()),
        lap_(scan.num_beams(), 0),
        share_(share) {
    for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
      share_.push_back(static_cast<float>(sweep_share(beam, scan.num_beams())));
    }
    num_steps_around_ = kTwoPi / std::abs(scan.bearing_step_rad);
    const bool is_all_around = static_cast<double>(scan.num_beams()) > num_steps_around_ - 0.5;
    num_laps_ = is_all_around ? 1 : 0;
  }

  /// Fills the beams between two that follow each other.
  void add(const MovedBeam& before, const MovedBeam& after, bool is_joined) {
    const double gap_steps = after.place - before.place;
    if (!is_joined && gap_steps > kWidestGap_steps) return;
    for (int lap = -num_laps_; lap <= num_laps_; ++lap) {
      const double shift = lap * num_steps_around_;
      const auto last = static_cast<double>(ranges_m_.size() - 1);
      const double end = std::min(after.place + shift, last + 1.0);
      for (double beam = std::max(0.0, std::ceil(before.place + shift)); beam < end; ++beam) {
        put(static_cast<std::size_t>(beam), lap, before, after, is_joined, shift);
      }
    }
  }

  [[nodiscard]] std::vector<double>& ranges_m() { return ranges_m_; }

 private:
  void put(std::size_t beam,
           int lap,
           const MovedBeam& before,
           const MovedBeam& after,
           bool is_joined,
           double shift) {
    const double from_before = static_cast<double>(beam) - before.place - shift;
    const double to_after = after.place + shift - static_cast<double>(beam);
    const MovedBeam& nearer = from_before <= to_after ? before : after;
    if (nearer.outcome == BeamOutcome::kInvalid) return;
    const double range_m =
        is_joined ? range_to_line(scan_.bearing_rad(beam), before.point_m, after.point_m)
                  : nearer.range_m;
    if (!is_better(beam, lap, nearer, range_m)) return;
    ranges_m_[beam] = range_m;
    lap_[beam] = lap;
    share_[beam] = static_cast<float>(nearer.share);
  }

  /// Of two measurements of a beam: in another lap the one nearer to the middle of the sweep, else
  /// what stands in front.
  [[nodiscard]] bool is_better(std::size_t beam,
                               int lap,
                               const MovedBeam& source,
                               double range_m) const {
    if (std::isnan(ranges_m_[beam])) return true;
    if (lap != lap_[beam]) return std::abs(source.share) < std::abs(share_[beam]);
    return range_m < ranges_m_[beam];
  }

  const Scan& scan_;
  std::vector<double> ranges_m_;
  std::vector<int> lap_;  ///< Of the beam that each range is of.
  std::vector<float>& share_;
  double num_steps_around_ = 0.0;
  int num_laps_ = 0;  ///< That a beam may have been taken forward or back by: 1 all around.
};

}  // namespace

double sweep_time_s(const Scan& scan) {
  return scan.num_beams() < 2 ? 0.0
                              : scan.time_increment_s * static_cast<double>(scan.num_beams() - 1);
}

double sweep_share(std::size_t beam, std::size_t num_beams) {
  if (num_beams < 2) return 0.0;
  return 2.0 * static_cast<double>(beam) / static_cast<double>(num_beams - 1) - 1.0;
}

Pose2 SweepMotion::pose_at(double share) const { return along_arc(share * way_m, turn_at(share)); }

SweepMotion even_motion(const Pose2& T_from_to, double elapsed_s, double sweep_s) {
  if (!(elapsed_s > 0.0)) return {};
  const double half_sweeps = 0.5 * sweep_s / elapsed_s;
  const Eigen::Vector2d f = chord_factors(T_from_to.theta_rad);
  const Eigen::Matrix2d chord = (Eigen::Matrix2d() << f.x(), -f.y(), f.y(), f.x()).finished();
  const double turn_rad = half_sweeps * T_from_to.theta_rad;
  return {half_sweeps * (chord.inverse() * T_from_to.translation()), turn_rad, turn_rad};
}

double change_rad(const SweepMotion& a, const SweepMotion& b) {
  return std::max(std::abs(a.turn_before_rad - b.turn_before_rad),
                  std::abs(a.turn_after_rad - b.turn_after_rad));
}

DeskewedScan deskewed(const Scan& scan, const SweepMotion& motion, const SurfaceParams& surfaces) {
  DeskewedScan result{.scan = scan, .share = {}};
  Resampling resampling(scan, result.share);
  if (motion.is_rest() || scan.num_beams() < 2) return result;
  const std::vector<bool> is_joined = joined_to_next(scan, surfaces);
  MovedBeam before = moved_beam(scan, 0, motion);
  for (std::size_t beam = 1; beam < scan.num_beams(); ++beam) {
    const MovedBeam after = moved_beam(scan, beam, motion);
    resampling.add(before, after, is_joined[beam - 1]);
    before = after;
  }
  result.scan.ranges_m = std::move(resampling.ranges_m());
  return result;
}

}  // namespace setsquare
