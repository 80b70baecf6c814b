// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/forgetting.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace setsquare {
namespace {

/// Of each keyframe, whether it and those beside it, up to `reach`, are known and of one piece.
std::vector<bool> well_inside(const KeyframeTrack& track,
                              std::span<const std::optional<KnownPlace>> places,
                              std::size_t reach) {
  std::vector<bool> is_inside(track.size(), false);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const std::size_t first = k > reach ? k - reach : 0;
    const std::size_t last = std::min(k + reach, places.size() - 1);
    is_inside[k] = track.pieces[first] == track.pieces[last] &&
                   std::all_of(places.begin() + static_cast<std::ptrdiff_t>(first),
                               places.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                               [](const auto& place) { return place.has_value(); });
  }
  return is_inside;
}

/// Elements of these indices, which ascend, and no others.
template <typename Element>
void keep_elements(std::span<const std::size_t> kept, std::vector<Element>& elements) {
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != i) elements[i] = std::move(elements[kept[i]]);
  }
  elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(kept.size()), elements.end());
}

/// Where keyframes would stand in the odom frame, had tracking followed the map over the runs that
/// are forgotten: from keyframe `first` on, with which the first of these begins.
std::vector<Pose2> poses_without_drift(const KeyframeTrack& track,
                                       std::span<const std::size_t> kept,
                                       std::size_t first,
                                       std::span<const Pose2> T_map_sensor) {
  std::vector<Pose2> T_odom_sensor;
  Pose2 T_new_old;
  auto next = std::ranges::lower_bound(kept, first);
  std::optional<std::size_t> run_begin;
  for (std::size_t k = first; k < track.size(); ++k) {
    const bool is_left = next != kept.end() && *next == k;
    if (!run_begin) {
      T_odom_sensor.push_back(T_new_old * track.keyframes[k]->T_odom_sensor);
    } else {
      const Pose2 seen = T_map_sensor[*run_begin].inverse() * T_map_sensor[k];
      T_odom_sensor.push_back(T_odom_sensor[*run_begin - first] * seen);
      T_new_old = T_odom_sensor.back() * track.keyframes[k]->T_odom_sensor.inverse();
    }
    if (is_left) {
      run_begin.reset();
      ++next;
    } else if (!run_begin) {
      run_begin = k;
    }
  }
  return T_odom_sensor;
}

Eigen::Matrix2d turned(const Eigen::Matrix2d& covariance, double turn_rad) {
  const Eigen::Matrix2d R = rotation_matrix(turn_rad);
  return R * covariance * R.transpose();
}

/// The first of `hung` that is not before a scan.
std::size_t hung_from(std::span<const HungScan> hung, std::size_t scan) {
  return static_cast<std::size_t>(std::ranges::lower_bound(hung, scan, {}, &HungScan::scan_index) -
                                  hung.begin());
}

}  // namespace

MotionCovariance joined_motion(const KeyframeTrack& track,
                               std::size_t first,
                               std::size_t last,
                               const ForgettingParams& params) {
  double translation_m2 = 0.0;
  double rotation_rad2 = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    translation_m2 += 0.5 * track.motions[k].translation_m2.trace();
    rotation_rad2 += track.motions[k].rotation_rad2;
  }
  MotionCovariance joined;
  joined.translation_m2 = std::min(translation_m2, params.known_sigma_m * params.known_sigma_m) *
                          Eigen::Matrix2d::Identity();
  joined.rotation_rad2 = std::min(rotation_rad2, params.known_sigma_rad * params.known_sigma_rad);
  joined.open_stretch = track.motions[last].open_stretch;
  joined.has_odometry = track.motions[last].has_odometry;
  return joined;
}

std::vector<bool> held_keyframes(std::span<const std::optional<KnownPlace>> places,
                                 std::span<const Constraint> closures) {
  std::vector<bool> is_held(places.size(), false);
  for (const Constraint& closure : closures) {
    const auto [earlier, later] = std::minmax(closure.from, closure.to);
    if (later < places.size() && !places[earlier]) is_held[later] = true;
  }
  return is_held;
}

std::vector<std::size_t> keyframes_to_keep(const KeyframeTrack& track,
                                           std::span<const std::optional<KnownPlace>> places,
                                           std::span<const Constraint> closures,
                                           const ForgettingParams& params) {
  const std::size_t num_scanners = track.num_scanners();
  const std::vector<bool> is_inside =
      well_inside(track, places, params.margin_keyframes * num_scanners);
  const std::vector<bool> is_held = held_keyframes(places, closures);
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < track.size();) {
    std::size_t goes_on = k;  // The keyframe from which the track goes on.
    for (std::size_t end = k; end < track.size() && is_inside[end]; ++end) {
      if (is_held[end]) goes_on = end;
    }
    if (goes_on - k >= params.shortest_run * num_scanners) k = goes_on;
    kept.push_back(k++);
    while (goes_on > k) kept.push_back(k++);
  }
  return kept;
}

void hang_forgotten(const KeyframeTrack& track,
                    std::span<const std::size_t> kept,
                    std::span<const std::optional<KnownPlace>> places,
                    std::vector<HungScan>& hung) {
  const auto num_before = static_cast<std::ptrdiff_t>(hung.size());
  auto next = kept.begin();
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (next != kept.end() && *next == k) {
      ++next;
      continue;
    }
    const KnownPlace& place = *places[k];
    hung.push_back({track.keyframes[k]->scan_index, place.reference_scan, place.T_reference_this});
  }
  if (static_cast<std::ptrdiff_t>(hung.size()) == num_before) return;
  // Most lie behind all those before: no more than the tail is sorted again.
  const auto middle = hung.begin() + num_before;
  const auto first =
      std::ranges::lower_bound(hung.begin(), middle, middle->scan_index, {}, &HungScan::scan_index);
  std::ranges::sort(first, hung.end(), {}, &HungScan::scan_index);
}

Pose2 forget_keyframes(std::span<const std::size_t> kept,
                       std::span<const Pose2> T_map_sensor,
                       const ForgettingParams& params,
                       TrackedParts parts) {
  KeyframeTrack& track = parts.track;
  std::size_t from = 0;  // The last keyframe of `kept` before the first run.
  while (from + 1 < kept.size() && kept[from + 1] == kept[from] + 1) ++from;
  const std::size_t first = kept[from] + 1;
  const std::size_t first_scan = track.keyframes[first]->scan_index;
  const std::vector<Pose2> T_odom_sensor = poses_without_drift(track, kept, first, T_map_sensor);
  const Pose2 T_new_old = T_odom_sensor.back() * track.keyframes.back()->T_odom_sensor.inverse();

  std::vector<MappedKeyframe> keyframes;
  for (std::size_t k = first; k < track.size(); ++k) {
    const bool begins_piece = k > first && track.pieces[k] != track.pieces[k - 1];
    keyframes.push_back(
        {track.keyframes[k]->scan_index - first_scan, T_odom_sensor[k - first], begins_piece});
  }
  std::vector<Pose2> T_old_sensor;
  for (std::size_t i = first_scan; i < parts.scans.size(); ++i) {
    T_old_sensor.push_back(parts.scans.T_odom_sensor(i));
  }
  const std::vector<Pose2> T_new_sensor = assemble_track(T_old_sensor, keyframes);
  for (std::size_t i = 0; i < T_new_sensor.size(); ++i) {
    parts.scans.move_to_odom(first_scan + i, T_new_sensor[i]);
  }

  std::vector<MotionCovariance> joined(kept.size());
  std::size_t num_runs = 0;
  std::vector<std::pair<std::size_t, std::size_t>> runs;  // Scans about each.
  for (std::size_t i = from + 1; i < kept.size(); ++i) {
    const bool is_joined = kept[i] != kept[i - 1] + 1;
    if (is_joined) {
      ++num_runs;
      runs.emplace_back(track.keyframes[kept[i - 1]]->scan_index,
                        track.keyframes[kept[i]]->scan_index);
    }
    MotionCovariance motion =
        is_joined ? joined_motion(track, kept[i - 1] + 1, kept[i], params) : track.motions[kept[i]];
    track.keyframes[kept[i]] =
        moved_to_odom(*track.keyframes[kept[i]], T_odom_sensor[kept[i] - first], motion);
    joined[i] = motion;
    track.stretches[kept[i]] += num_runs;
    HeadingEvidence& evidence = parts.evidence[kept[i]];
    evidence.tracked_heading_rad = track.keyframes[kept[i]]->T_odom_sensor.theta_rad;
    if (is_joined) evidence.step_sigma_rad = std::sqrt(motion.rotation_rad2);
  }
  for (std::size_t i = from + 1; i < kept.size(); ++i) track.motions[kept[i]] = joined[i];
  keep_elements(kept, track.keyframes);
  keep_elements(kept, track.motions);
  keep_elements(kept, track.stretches);
  keep_elements(kept, track.pieces);
  keep_elements(kept, parts.shares_of_place);
  keep_elements(kept, parts.evidence);
  std::erase_if(parts.kept_scans, [&](const KeptScan& scan) {
    return std::ranges::any_of(
        runs, [&](const auto& run) { return run.first < scan.index && scan.index < run.second; });
  });
  return T_new_old;
}

std::vector<KnownScans> oldest_known_scans(const KeyframeTrack& track,
                                           std::span<const HungScan> hung,
                                           std::size_t max_num) {
  std::vector<KnownScans> known;  // Between two keyframes between which others were.
  std::size_t num_known = 0;
  for (std::size_t k = 1; k < track.size(); ++k) {
    const KnownScans between{track.keyframes[k - 1]->scan_index + 1,
                             track.keyframes[k]->scan_index};
    const std::size_t first_hung = hung_from(hung, between.first);
    if (first_hung == hung.size() || hung[first_hung].scan_index >= between.end) continue;
    known.push_back(between);
    num_known += between.end - between.first;
  }
  std::vector<KnownScans> oldest;
  for (const KnownScans& between : known) {
    if (num_known <= max_num) break;
    const std::size_t num = std::min(num_known - max_num, between.end - between.first);
    const std::size_t anchor = hung_from(hung, between.first + num);
    const std::size_t end =
        anchor < hung.size() ? std::min(hung[anchor].scan_index, between.end) : between.end;
    oldest.push_back({between.first, end});
    num_known -= end - between.first;
  }
  return oldest;
}

void add_gap(const KnownScans& range,
             const TrackedScans& scans,
             std::vector<ForgottenPoses>& gaps) {
  ForgottenPoses told{range.first, range.end - range.first, 0.0};
  const auto base = [&](std::size_t i) {
    return (scans.T_odom_sensor(i) * scans[i].T_base_sensor.inverse()).translation();
  };
  // Gaps within the range are part of the new one: no step leads over them.
  const auto first = std::ranges::lower_bound(gaps, range.first, {}, &ForgottenPoses::next_scan);
  const auto last = std::ranges::upper_bound(gaps, range.end, {}, &ForgottenPoses::next_scan);
  auto within = first;
  for (std::size_t i = range.first; i <= range.end; ++i) {
    if (within != last && within->next_scan == i) {
      told.num_scans += within->num_scans;
      told.way_m += within->way_m;
      ++within;
    } else {
      told.way_m += (base(i) - base(i - 1)).norm();
    }
  }
  for (auto behind = last; behind != gaps.end(); ++behind) {
    behind->next_scan -= range.end - range.first;
  }
  gaps.insert(gaps.erase(first, last), told);
}

void renumber_behind(const KnownScans& range,
                     KeyframeTrack& track,
                     std::vector<KeptScan>& kept_scans,
                     std::vector<HungScan>& hung) {
  const std::size_t num_gone = range.end - range.first;
  const auto is_behind = [&](std::size_t scan) { return scan >= range.end; };
  for (KeyframePtr& keyframe : track.keyframes) {
    if (!is_behind(keyframe->scan_index)) continue;
    Keyframe numbered = *keyframe;
    numbered.scan_index -= num_gone;
    keyframe = std::make_shared<const Keyframe>(std::move(numbered));
  }
  for (KeptScan& kept : kept_scans) {
    if (is_behind(kept.index)) kept.index -= num_gone;
  }
  hung.erase(hung.begin() + static_cast<std::ptrdiff_t>(hung_from(hung, range.first)),
             hung.begin() + static_cast<std::ptrdiff_t>(hung_from(hung, range.end)));
  for (HungScan& scan : hung) {
    if (is_behind(scan.scan_index)) scan.scan_index -= num_gone;
    if (is_behind(scan.reference_scan)) scan.reference_scan -= num_gone;
  }
}

void turn_by(double turn_rad, MotionCovariance& motion) {
  motion.translation_m2 = turned(motion.translation_m2, turn_rad);
  motion.open_sigma_m = turned(motion.open_sigma_m, turn_rad);
}

KeyframePtr moved_to_odom(const Keyframe& keyframe,
                          const Pose2& T_odom_sensor,
                          MotionCovariance& motion) {
  const double turn_rad = T_odom_sensor.theta_rad - keyframe.T_odom_sensor.theta_rad;
  turn_by(turn_rad, motion);
  Keyframe moved = keyframe;
  moved.T_odom_sensor = T_odom_sensor;
  moved.T_odom_body = T_odom_sensor * (keyframe.T_odom_sensor.inverse() * keyframe.T_odom_body);
  return std::make_shared<const Keyframe>(std::move(moved));
}

}  // namespace setsquare
