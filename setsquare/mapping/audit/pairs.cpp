// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// Shares of the sample.
constexpr double kBreakShare = 0.15;
constexpr double kOutvotedShare = 0.15;
constexpr double kRevisitShare = 0.4;
constexpr double kSamePassShare = 0.2;
/// Scanners that look ahead see the same of near places where they look the same way.
constexpr double kSameView_rad = rad_from_deg(60.0);
/// Ways to either side of a break that are matched with each other.
constexpr std::array<double, 3> kAboutBreak_m = {0.4, 1.2, 3.0};

/// The sample as it grows.
class PairSample {
 public:
  explicit PairSample(const AuditedTrack& track) : track_(track) {}

  void add(std::size_t a, std::size_t b) {
    if (a == b || a >= track_.size() || b >= track_.size()) return;
    pairs_.insert({std::min(a, b), std::max(a, b)});
  }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  [[nodiscard]] std::vector<AuditPair> in_order() const { return {pairs_.begin(), pairs_.end()}; }

 private:
  const AuditedTrack& track_;
  std::set<AuditPair> pairs_;
};

/// The keyframe nearest to so many metres from the track's begin.
std::size_t keyframe_at(const AuditedTrack& track, double way_m) {
  const auto after = std::lower_bound(track.way_m.begin(), track.way_m.end(), way_m);
  if (after == track.way_m.begin()) return 0;
  const auto k = static_cast<std::size_t>(after - track.way_m.begin());
  if (after == track.way_m.end()) return track.size() - 1;
  return *after - way_m < way_m - track.way_m[k - 1] ? k : k - 1;
}

/// Any `max_num` of the breaks, evenly.
void add_breaks(const AuditedTrack& track, std::size_t max_num, PairSample& sample) {
  constexpr std::size_t kPerBreak = kAboutBreak_m.size() * kAboutBreak_m.size();
  const std::size_t num_breaks = std::min(track.breaks.size(), 1 + max_num / kPerBreak);
  for (std::size_t i = 0; i < num_breaks; ++i) {
    const auto [before, after] = track.breaks[i * track.breaks.size() / num_breaks];
    for (const double before_m : kAboutBreak_m) {
      for (const double after_m : kAboutBreak_m) {
        const std::size_t from = keyframe_at(track, track.way_m[before] - before_m);
        const std::size_t to = keyframe_at(track, track.way_m[after] + after_m);
        sample.add(std::min(from, before), std::max(to, after));
      }
    }
  }
}

void add_outvoted(const AuditedTrack& track, std::size_t max_num, PairSample& sample) {
  const std::size_t num = std::min(track.outvoted.size(), max_num);
  for (std::size_t i = 0; i < num; ++i) {
    const AuditPair& pair = track.outvoted[i * track.outvoted.size() / num];
    sample.add(pair.from, pair.to);
  }
}

/// 0 to `num` - 1: every `stride`-th, then those after them, and so on.
std::vector<std::size_t> strided(std::size_t num, std::size_t stride) {
  std::vector<std::size_t> order;
  for (std::size_t first = 0; first < stride; ++first) {
    for (std::size_t i = first; i < num; i += stride) order.push_back(i);
  }
  return order;
}

/// Adds one pair for each of the places while the sample has fewer than `num`: with a keyframe near
/// by the map whose way along the track is at least `min_way_m` and less than `max_way_m`.
void add_near(const AuditedTrack& track,
              std::span<const AuditedPlace> places,
              double near_m,
              double min_way_m,
              double max_way_m,
              std::size_t num,
              std::mt19937& random,
              PairSample& sample) {
  // Every few places at first, so that the sample covers the whole track however small it is.
  const std::size_t wanted = std::max<std::size_t>(num - std::min(num, sample.size()), 1);
  const std::size_t stride = 1 + places.size() / wanted;
  constexpr int kMaxRounds = 4;
  for (int round = 0; round < kMaxRounds && sample.size() < num; ++round) {
    for (const std::size_t i : strided(places.size(), stride)) {
      const AuditedPlace& place = places[i];
      const Eigen::Vector2d here = track.T_map_sensor[place.keyframe].translation();
      std::vector<std::size_t> near;
      for (std::size_t k = 0; k < track.size(); ++k) {
        const double way_m = std::abs(track.way_m[k] - track.way_m[place.keyframe]);
        if (way_m < min_way_m || way_m >= max_way_m) continue;
        if ((track.T_map_sensor[k].translation() - here).norm() < near_m) near.push_back(k);
      }
      const auto looks_elsewhere = [&](std::size_t k) {
        return std::abs(wrap_to_pi(track.T_map_sensor[k].theta_rad -
                                   track.T_map_sensor[place.keyframe].theta_rad)) > kSameView_rad;
      };
      if (!std::all_of(near.begin(), near.end(), looks_elsewhere)) {
        std::erase_if(near, looks_elsewhere);
      }
      if (near.empty()) continue;
      sample.add(place.keyframe, near[random() % near.size()]);
      if (sample.size() >= num) return;
    }
  }
}

/// Places that look alike and are not near each other by the map.
void add_alike(const AuditedTrack& track,
               std::span<const AuditedPlace> places,
               const AuditParams& params,
               std::size_t num,
               PairSample& sample) {
  constexpr std::size_t kNumSimilar = 12;
  std::vector<PlaceSignature> signatures;
  for (const AuditedPlace& place : places) signatures.push_back(place.signature);
  std::vector<std::pair<double, AuditPair>> alike;
  for (const AuditedPlace& place : places) {
    for (const std::size_t k : nearest_signatures(place.signature, signatures, kNumSimilar)) {
      const std::size_t other = places[k].keyframe;
      const double way_m = std::abs(track.way_m[other] - track.way_m[place.keyframe]);
      const double apart_m = (track.T_map_sensor[other].translation() -
                              track.T_map_sensor[place.keyframe].translation())
                                 .norm();
      if (way_m < params.revisit_way_m || apart_m < params.near_m) continue;
      alike.push_back({signature_distance(place.signature, places[k].signature),
                       {std::min(place.keyframe, other), std::max(place.keyframe, other)}});
      break;
    }
  }
  std::sort(alike.begin(), alike.end());
  for (const auto& [distance, pair] : alike) {
    if (sample.size() >= num) return;
    sample.add(pair.from, pair.to);
  }
}

/// Those of the scans at which tracking began anew, and knows nothing of what came before.
std::vector<bool> begins_pieces(const Map& map) {
  std::vector<bool> begins(map.scans.size(), false);
  for (const TrackPiece& piece : map.pieces) {
    if (piece.first_scan > 0 && piece.first_scan < begins.size()) begins[piece.first_scan] = true;
  }
  return begins;
}

/// Those that tracking lost or found again.
std::vector<bool> lost_scans(const Map& map) {
  std::vector<bool> is_lost;
  for (const MappedScan& scan : map.scans) {
    is_lost.push_back(scan.status == TrackStatus::kLost || scan.status == TrackStatus::kRecovered);
  }
  return is_lost;
}

/// Ranges of scans that tracking did not hold, first and last: lost or found again, the begin of a
/// piece, or one direction open.
std::vector<std::pair<std::size_t, std::size_t>> weak_ranges(const Map& map) {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  const std::vector<bool> is_lost = lost_scans(map);
  for (std::size_t i = 0; i < is_lost.size(); ++i) {
    if (!is_lost[i]) continue;
    if (!ranges.empty() && ranges.back().second + 1 == i) {
      ranges.back().second = i;
    } else {
      ranges.emplace_back(i, i);
    }
  }
  for (const TrackPiece& piece : map.pieces) {
    if (piece.first_scan > 0) ranges.emplace_back(piece.first_scan, piece.first_scan);
  }
  for (const OpenStretch& stretch : map.open_stretches) {
    if (stretch.num_scans == 0) continue;
    ranges.emplace_back(stretch.first_scan, stretch.first_scan + stretch.num_scans - 1);
  }
  return ranges;
}

/// The last keyframe before each range of scans, and the first after it.
std::vector<AuditPair> breaks_of(const Map& map, const std::vector<std::size_t>& keyframes) {
  std::vector<AuditPair> breaks;
  for (const auto& [first, last] : weak_ranges(map)) {
    const auto before = std::lower_bound(keyframes.begin(), keyframes.end(), first);
    const auto after = std::lower_bound(keyframes.begin(), keyframes.end(), last);
    if (before == keyframes.begin()) continue;
    const auto k = static_cast<std::size_t>(before - keyframes.begin()) - 1;
    const auto next = static_cast<std::size_t>(after - keyframes.begin());
    breaks.push_back({k, std::min(next, keyframes.size() - 1)});
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// Keyframes before which, and after the one before, one of these scans came.
std::vector<std::size_t> keyframes_after(const std::vector<bool>& is_named,
                                         const std::vector<std::size_t>& keyframes) {
  std::vector<std::size_t> found;
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    const auto begin = is_named.begin() + static_cast<std::ptrdiff_t>(keyframes[k - 1] + 1);
    const auto end = is_named.begin() + static_cast<std::ptrdiff_t>(keyframes[k] + 1);
    if (std::find(begin, end, true) != end) found.push_back(k);
  }
  return found;
}

/// Variance of the way to each keyframe that the map admits: of the open stretches before it.
std::vector<double> admitted_m2(const Map& map, const std::vector<std::size_t>& scans) {
  std::vector<double> variances;
  for (const std::size_t scan : scans) {
    double sum_m2 = 0.0;
    for (const OpenStretch& stretch : map.open_stretches) {
      if (stretch.num_scans == 0 || scan < stretch.first_scan) continue;
      const double share = std::min(1.0,
                                    static_cast<double>(scan - stretch.first_scan + 1) /
                                        static_cast<double>(stretch.num_scans));
      sum_m2 += share * stretch.length_sigma_m * stretch.length_sigma_m;
    }
    variances.push_back(sum_m2);
  }
  return variances;
}

/// AuditedTrack::long_steps; `keyframes`: those of the track.
std::vector<std::size_t> long_steps_of(const Map& map, const std::vector<std::size_t>& keyframes) {
  // After so many steps tracking knows that long ones are usual.
  constexpr std::size_t kUntilUsual = LongStepParams{}.num_steps;
  const std::vector<TrackedMotion>& motions = map.track.motions;
  if (motions.size() != map.keyframes.size()) return {};
  const auto is_usual = [&](std::size_t k) {
    const std::size_t end = std::min(k + kUntilUsual, motions.size());
    for (std::size_t i = k; i < end && motions[i].stretch == motions[k].stretch; ++i) {
      if (motions[i].covariance.is_long_step) return true;
    }
    return false;
  };
  std::vector<std::size_t> steps;
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    const std::size_t k = keyframes[i];
    if (keyframes[i - 1] + 1 != k || motions[k].stretch != motions[k - 1].stretch) continue;
    if (is_usual(k)) steps.push_back(i);
  }
  return steps;
}

/// Keyframes before which tracking may have lost its way. Scans that only repeat the one before, as
/// drivers send them, are lost, too, where the robot drove on; they add nothing to what its motion
/// may be off by.
std::vector<std::size_t> losses_of(const Map& map,
                                   const std::vector<std::size_t>& scans,
                                   const std::vector<std::size_t>& keyframes) {
  std::vector<std::size_t> losses = keyframes_after(lost_scans(map), scans);
  const std::vector<TrackedMotion>& motions = map.track.motions;
  if (motions.size() != map.keyframes.size()) return losses;  // Of a trajectory, or an old file.
  std::erase_if(losses, [&](std::size_t i) {
    return !(motions[keyframes[i]].covariance.slip_sigma_m > 0.0);
  });
  return losses;
}

}  // namespace

AuditedTrack audited_track(const Map& map) {
  AuditedTrack track;
  std::vector<std::size_t> scans;
  for (std::size_t k = 0; k < map.keyframes.size(); ++k) {
    const MappedScan& scan = map.scans[map.keyframes[k]];
    if (!scan.is_placed || scan.status == TrackStatus::kLost) continue;
    const double step_m =
        track.keyframes.empty()
            ? 0.0
            : (scan.T_map_sensor.translation() - track.T_map_sensor.back().translation()).norm();
    track.way_m.push_back(track.way_m.empty() ? 0.0 : track.way_m.back() + step_m);
    track.keyframes.push_back(k);
    track.T_map_sensor.push_back(scan.T_map_sensor);
    track.is_open.push_back(scan.status == TrackStatus::kDegenerate);
    scans.push_back(map.keyframes[k]);
  }
  track.open_m2 = admitted_m2(map, scans);
  track.breaks = breaks_of(map, scans);
  track.losses = losses_of(map, scans, track.keyframes);
  track.restarts = keyframes_after(begins_pieces(map), scans);
  track.long_steps = long_steps_of(map, track.keyframes);
  for (const MappedClosure& closure : map.closures) {
    if (!closure.closure.is_outvoted()) continue;
    const auto from = std::lower_bound(scans.begin(), scans.end(), closure.scan_i);
    const auto to = std::lower_bound(scans.begin(), scans.end(), closure.scan_j);
    if (from == scans.end() || to == scans.end() || *from != closure.scan_i ||
        *to != closure.scan_j) {
      continue;
    }
    track.outvoted.push_back({static_cast<std::size_t>(from - scans.begin()),
                              static_cast<std::size_t>(to - scans.begin())});
  }
  return track;
}

std::vector<std::size_t> spread_places(const AuditedTrack& track, std::size_t max_num) {
  const std::size_t num = std::min(track.size(), max_num);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < num; ++i) places.push_back(i * track.size() / num);
  return places;
}

std::vector<std::size_t> telling_places(const AuditedTrack& track, std::size_t max_num) {
  std::vector<std::size_t> telling;
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (!track.is_open[k]) telling.push_back(k);
  }
  const std::size_t num = std::min(telling.size(), max_num);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < num; ++i) places.push_back(telling[i * telling.size() / num]);
  return places;
}

std::vector<AuditPair> pairs_within_spread(const AuditedTrack& track,
                                           std::span<const AuditedPlace> places,
                                           const AuditParams& params,
                                           std::size_t num_alike) {
  PairSample sample(track);
  for (const AuditedPlace& place : places) {
    std::vector<std::size_t> admitted;
    std::vector<PlaceSignature> signatures;
    for (const AuditedPlace& other : places) {
      if (track.way_m[place.keyframe] - track.way_m[other.keyframe] < params.revisit_way_m) break;
      const double variance_m2 = track.open_m2[place.keyframe] - track.open_m2[other.keyframe];
      if (!(variance_m2 > params.off_m * params.off_m)) break;
      const double apart_m = (track.T_map_sensor[place.keyframe].translation() -
                              track.T_map_sensor[other.keyframe].translation())
                                 .norm();
      if (apart_m > params.max_sigmas * std::sqrt(variance_m2) + params.near_m) continue;
      admitted.push_back(other.keyframe);
      signatures.push_back(other.signature);
    }
    // A few of each part of the track: a rival of the most alike is to be found, too.
    constexpr std::size_t kPerPart = 2;
    std::vector<std::size_t> chosen;
    for (const std::size_t i : nearest_signatures(place.signature, signatures, signatures.size())) {
      const std::size_t other = admitted[i];
      const auto num_beside = std::count_if(chosen.begin(), chosen.end(), [&](std::size_t k) {
        return std::abs(track.way_m[k] - track.way_m[other]) < params.part_m;
      });
      if (static_cast<std::size_t>(num_beside) >= kPerPart) continue;
      sample.add(other, place.keyframe);
      chosen.push_back(other);
      if (chosen.size() == num_alike) break;
    }
  }
  return sample.in_order();
}

std::vector<AuditPair> sampled_pairs(const AuditedTrack& track,
                                     std::span<const AuditedPlace> places,
                                     const AuditParams& params) {
  constexpr std::uint32_t kSeed = 1;
  std::mt19937 random(kSeed);
  const std::size_t num = std::clamp(
      static_cast<std::size_t>(params.pairs_per_keyframe * static_cast<double>(track.size())),
      params.min_num_pairs,
      params.max_num_pairs);
  const auto share = [&](double part) {
    return static_cast<std::size_t>(part * static_cast<double>(num));
  };
  PairSample sample(track);
  add_breaks(track, share(kBreakShare), sample);
  add_outvoted(track, share(kOutvotedShare), sample);
  const double everywhere_m = track.size() == 0 ? 0.0 : track.way_m.back() + 1.0;
  add_near(track,
           places,
           params.near_m,
           params.min_way_m,
           params.revisit_way_m,
           sample.size() + share(kSamePassShare),
           random,
           sample);
  add_near(track,
           places,
           params.near_m,
           params.revisit_way_m,
           everywhere_m,
           sample.size() + share(kRevisitShare),
           random,
           sample);
  add_alike(track, places, params, std::max(num, sample.size()), sample);
  return sample.in_order();
}

std::vector<AuditPair> pairs_about(const AuditedTrack& track, const AuditPair& pair) {
  // Metres along the track from either scan of the pair.
  constexpr std::array<std::pair<double, double>, 8> kOffsets_m = {{{0.8, 0.8},
                                                                    {-0.8, -0.8},
                                                                    {0.8, -0.8},
                                                                    {-0.8, 0.8},
                                                                    {2.0, 2.0},
                                                                    {-2.0, -2.0},
                                                                    {2.0, -2.0},
                                                                    {-2.0, 2.0}}};
  PairSample sample(track);
  for (const auto& [from_m, to_m] : kOffsets_m) {
    sample.add(keyframe_at(track, track.way_m[pair.from] + from_m),
               keyframe_at(track, track.way_m[pair.to] + to_m));
  }
  return sample.in_order();
}

}  // namespace setsquare
