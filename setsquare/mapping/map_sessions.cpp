// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/map_sessions.hpp"

#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <memory>
#include <optional>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/is_beyond.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare {
namespace {

/// Of a scan, its keyframe or what else is kept of it; null where nothing is.
std::shared_ptr<const Scan> kept_scan(const Map& map, std::size_t scan) {
  const auto found = std::ranges::lower_bound(map.kept_scans, scan, {}, &KeptScan::index);
  return found != map.kept_scans.end() && found->index == scan ? found->scan : nullptr;
}

/// Goes over a session's scans, and knows which scan of the log each is.
class LogWalk {
 public:
  explicit LogWalk(const LoggedScans& scans)
      : scans_(scans),
        index_(scans.session.first_scan),
        end_(index_ + scans.session.num_scans),
        gap_(std::ranges::upper_bound(scans.gaps, index_, {}, &ForgottenPoses::next_scan)) {}

  [[nodiscard]] bool is_at_end() const { return index_ == end_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] LoggedScans::Scan scan() const { return scans_.scan_at(index_); }
  void step() {
    ++index_;
    ++number_;
    if (gap_ == scans_.gaps.end() || gap_->next_scan != index_ || is_at_end()) return;
    number_ += gap_->num_scans;
    ++gap_;
  }

 private:
  const LoggedScans& scans_;
  std::size_t index_;
  std::size_t end_;
  std::span<const ForgottenPoses>::iterator gap_;
  std::size_t number_ = 0;  ///< In the log, from 0.
};

bool is_same_motion(const Pose2& a, const Pose2& b) {
  constexpr double kRounding = 1e-6;  // In m and rad.
  return !is_beyond(a.inverse() * b, kRounding, kRounding);
}

}  // namespace

void require_track(const Map& map) {
  const bool has_track = !map.sessions.empty() &&
                         map.track.T_odom_sensor.size() == map.scans.size() &&
                         map.track.motions.size() == map.keyframes.size();
  if (!has_track) {
    throw ParameterError("map", "does not tell its track: the preset \"paper\" makes none");
  }
  validate(map);
  const bool is_in_order = std::ranges::adjacent_find(
                               map.keyframes, std::ranges::greater_equal{}) == map.keyframes.end();
  if (!is_in_order) throw ParameterError("keyframes", "are not in the order of the scans");
  if (!std::ranges::is_sorted(map.kept_scans, {}, &KeptScan::index)) {
    throw ParameterError("kept_scans", "are not in the order of the scans");
  }
  for (const TrackedMotion& motion : map.track.motions) {
    const MotionCovariance& covariance = motion.covariance;
    if (covariance.translation_m2.determinant() > 0.0 && covariance.rotation_rad2 > 0.0) continue;
    throw ParameterError("track.motions", "have a covariance that is none");
  }
}

std::size_t keyframe_at(const Map& map, std::size_t scan) {
  return static_cast<std::size_t>(std::ranges::lower_bound(map.keyframes, scan) -
                                  map.keyframes.begin());
}

std::vector<std::size_t> pieces_of_keyframes(const Map& map) {
  std::vector<std::size_t> pieces;
  std::size_t piece = 0;
  for (const std::size_t scan : map.keyframes) {
    while (piece + 1 < map.pieces.size() && map.pieces[piece + 1].first_scan <= scan) ++piece;
    pieces.push_back(piece);
  }
  return pieces;
}

TrackedScan tracked_scan(const Map& map, std::size_t scan) {
  const MappedScan& mapped = map.scans[scan];
  const Pose2& T_odom_sensor = map.track.T_odom_sensor[scan];
  const auto whole = kept_scan(map, scan);
  const Eigen::Rotation2Dd to_odom(T_odom_sensor.theta_rad - mapped.T_map_sensor.theta_rad);
  TrackedScan tracked{.stamp = mapped.stamp,
                      .status = mapped.status,
                      .has_odometry = mapped.has_odometry,
                      .score = static_cast<float>(mapped.score),
                      .T_odom_sensor = T_odom_sensor,
                      .T_base_sensor = whole ? whole->T_base_sensor
                                             : mapped.T_map_base.inverse() * mapped.T_map_sensor,
                      .open = {.sigma_m = mapped.open_sigma_m.norm(),
                               .is_turn_open = mapped.is_turn_open,
                               .turn_sigma_rad = mapped.open_turn_sigma_rad,
                               .turn_motion_m = to_odom * mapped.open_turn_motion_m}};
  if (tracked.open.sigma_m > 0.0) {
    tracked.open.direction = to_odom * mapped.open_sigma_m / tracked.open.sigma_m;
  }
  return tracked;
}

std::vector<KeyframePtr> keyframes_of(const Map& map,
                                      std::size_t first,
                                      std::size_t end,
                                      const MapperParams& params) {
  std::vector<KeyframePtr> keyframes(end - first);
  run_in_parallel(keyframes.size(), params.num_threads, [&](std::size_t i) {
    const std::size_t scan_index = map.keyframes[first + i];
    const auto whole = kept_scan(map, scan_index);
    if (!whole) return;
    auto surfaces = scan_surfaces(*whole, params.tracker.surfaces, params.tracker.image);
    keyframes[i] = std::make_shared<const Keyframe>(
        Keyframe{.scan_index = scan_index,
                 .T_odom_sensor = map.track.T_odom_sensor[scan_index],
                 .T_odom_body = map.track.motions[first + i].T_odom_body,
                 .scan = whole,
                 .surfaces = std::move(surfaces)});
  });
  if (std::ranges::find(keyframes, nullptr) != keyframes.end()) {
    throw ParameterError("map", "does not keep the scan of a keyframe");
  }
  return keyframes;
}

bool is_same_log(const LoggedScans& a, const LoggedScans& b) {
  LogWalk walk_a(a);
  LogWalk walk_b(b);
  std::size_t num_steps = 0;
  std::size_t num_alike = 0;
  std::optional<std::size_t> last;  // In the log, of the scans that both have.
  Pose2 T_odom_last_a;
  Pose2 T_odom_last_b;
  while (!walk_a.is_at_end() && !walk_b.is_at_end()) {
    const std::size_t number = walk_a.number();
    if (number != walk_b.number()) {
      (number < walk_b.number() ? walk_a : walk_b).step();
      continue;
    }
    const auto [stamp_a, T_odom_a] = walk_a.scan();
    const auto [stamp_b, T_odom_b] = walk_b.scan();
    if (stamp_a != stamp_b) return false;
    if (last && *last + 1 == number) {
      ++num_steps;
      num_alike +=
          is_same_motion(T_odom_last_a.inverse() * T_odom_a, T_odom_last_b.inverse() * T_odom_b);
    }
    last = number;
    T_odom_last_a = T_odom_a;
    T_odom_last_b = T_odom_b;
    walk_a.step();
    walk_b.step();
  }
  return walk_a.number() == walk_b.number() && last && 2 * num_alike >= num_steps;
}

}  // namespace setsquare
