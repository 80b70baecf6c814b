// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/doubts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// A stretch is of unknown length from this standard deviation on.
constexpr double kWideSigma_m = 0.5;
constexpr double kShortEnd_m = 1.0;
/// Walls that turn by less are hardly another wing, nor is it much of a slip.
constexpr double kTurned_rad = rad_from_deg(3.0);
/// Outvoted closures between the same two parts of the track that raise a doubt.
constexpr std::size_t kMinOutvoted = 3;
/// Those whose ends are no more scans apart are of the same part.
constexpr double kOutvotedPart_m = 12.0;

/// Matches that tell whether a map is right.
constexpr std::size_t kFewestMatches = 6;

/// Lost scans in a row are in doubt from so long, and such spreads, on.
constexpr double kLongUnseen_s = 2.0;
constexpr double kUnseenSigma_m = 1.0;
constexpr double kUnseenSigma_rad = rad_from_deg(10.0);

/// A first and a last scan.
struct ScanRange {
  std::size_t first = 0;
  std::size_t last = 0;

  void add(const ScanRange& other) {
    first = std::min(first, other.first);
    last = std::max(last, other.last);
  }
};

std::string text_of(const ScanRange& range) {
  if (range.first == range.last) return "scan " + std::to_string(range.first);
  return "scans " + std::to_string(range.first) + " to " + std::to_string(range.last);
}

MapDoubt doubt_at(const Map& map,
                  DoubtKind kind,
                  const ScanRange& range,
                  const Eigen::Vector2d& place_m,
                  std::string reason) {
  return {.kind = kind,
          .place_m = place_m,
          .first_scan = range.first,
          .num_scans = range.last - range.first + 1,
          .first_stamp = map.scans[range.first].stamp,
          .last_stamp = map.scans[range.last].stamp,
          .reason = std::move(reason)};
}

Eigen::Vector2d middle_of(const Map& map, const ScanRange& range) {
  return map.scans[range.first + (range.last - range.first) / 2].T_map_base.translation();
}

/// Groups of contradictions between the same two parts of the track: the same error, where the map
/// is bent and not broken.
struct ContradictedParts {
  ScanRange from;
  ScanRange to;
  std::size_t centre = 0;  ///< Of the greatest of the groups: a match.
  std::size_t num_places = 0;
  std::size_t num_agreeing = 0;
};

ContradictedParts parts_of(const ContradictionGroup& group,
                           const Map& map,
                           const AuditFindings& findings) {
  const auto scan_of = [&](std::size_t k) { return map.keyframes[findings.track.keyframes[k]]; };
  ContradictedParts parts{.from = {},
                          .to = {},
                          .centre = group.centre,
                          .num_places = group.num_places,
                          .num_agreeing = group.num_agreeing};
  const AuditPair& first = findings.matches[group.centre].pair;
  parts.from = {scan_of(first.from), scan_of(first.from)};
  parts.to = {scan_of(first.to), scan_of(first.to)};
  for (const std::size_t i : group.members) {
    const AuditPair& pair = findings.matches[i].pair;
    parts.from.add({scan_of(pair.from), scan_of(pair.from)});
    parts.to.add({scan_of(pair.to), scan_of(pair.to)});
  }
  return parts;
}

std::vector<ContradictedParts> contradicted_parts(const Map& map, const AuditFindings& findings) {
  std::vector<ContradictedParts> all;
  const auto overlap = [](const ScanRange& a, const ScanRange& b) {
    return a.first <= b.last && b.first <= a.last;
  };
  for (const ContradictionGroup& group : findings.groups) {
    if (!group.raises_doubt) continue;
    const ContradictedParts parts = parts_of(group, map, findings);
    const auto same = std::find_if(all.begin(), all.end(), [&](const ContradictedParts& other) {
      return overlap(parts.from, other.from) && overlap(parts.to, other.to);
    });
    if (same == all.end()) {
      all.push_back(parts);
      continue;
    }
    same->from.add(parts.from);
    same->to.add(parts.to);
    same->num_places += parts.num_places;
    same->num_agreeing = std::max(same->num_agreeing, parts.num_agreeing);
  }
  return all;
}

/// The piece of track that a scan is of, from 0.
std::size_t piece_of(const Map& map, std::size_t scan) {
  std::size_t piece = 0;
  while (piece + 1 < map.pieces.size() && map.pieces[piece + 1].first_scan <= scan) ++piece;
  return piece;
}

/// The last scan that hangs on what is between `before` and `after` (scans): up to where a match
/// that agrees ties the track to what was before.
std::size_t last_that_hangs(const Map& map,
                            const AuditFindings& findings,
                            std::size_t before,
                            std::size_t after,
                            const AuditParams& params) {
  const auto scan_of = [&](std::size_t k) { return map.keyframes[findings.track.keyframes[k]]; };
  std::size_t last = map.scans.size() - 1;
  for (const AuditMatch& match : findings.matches) {
    const std::size_t tied = scan_of(match.pair.to);
    if (tied <= after || scan_of(match.pair.from) > before) continue;
    const AuditOffset offset = audit_offset(match, findings.track, params);
    if (!offset.contradicts_map) last = std::min(last, tied - 1);
  }
  return last;
}

/// What is in doubt where scans of `parts.to` match those of `parts.from` otherwise than the map
/// has them. What follows hangs on them; and where the one part is of a piece that was joined to
/// the other's, it is that joint, and the piece lies wrong from its begin.
ScanRange doubted_scans(const Map& map,
                        const AuditFindings& findings,
                        const ContradictedParts& parts,
                        const AuditParams& params) {
  const std::size_t last = last_that_hangs(map, findings, parts.from.last, parts.to.last, params);
  ScanRange doubted{parts.to.first, last};
  const std::size_t piece = piece_of(map, parts.to.first);
  if (piece_of(map, parts.from.last) != piece) doubted.first = map.pieces[piece].first_scan;
  return doubted;
}

void add_contradictions(const Map& map,
                        const AuditFindings& findings,
                        const AuditParams& params,
                        std::vector<MapDoubt>& doubts) {
  for (const ContradictedParts& parts : contradicted_parts(map, findings)) {
    const AuditMatch& centre = findings.matches[parts.centre];
    const AuditOffset offset = audit_offset(centre, findings.track, params);
    const std::size_t scan = map.keyframes[findings.track.keyframes[centre.pair.to]];
    doubts.push_back(doubt_at(
        map,
        DoubtKind::kContradictingPairs,
        doubted_scans(map, findings, parts, params),
        map.scans[scan].T_map_base.translation(),
        fmt::format(
            "{} match {} {:.2f} m and {:.1f} deg off where the map has them: {} independent "
            "pairs say so, {} agree with the map",
            text_of(parts.to),
            text_of(parts.from),
            offset.off_m,
            deg_from_rad(offset.off_rad),
            parts.num_places,
            parts.num_agreeing)));
  }
}

/// Matches that look alike contradict a map one by one; where no fewer contradict it than agree, it
/// is the map, though no two of them say the same of it.
void add_few_agreeing(const Map& map, const AuditReport& report, std::vector<MapDoubt>& doubts) {
  const bool is_agreed = report.num_agreeing > report.num_contradicting;
  if (is_agreed || report.num_matched < kFewestMatches) return;
  const ScanRange all{0, map.scans.size() - 1};
  doubts.push_back(doubt_at(map,
                            DoubtKind::kContradictingPairs,
                            all,
                            map.scans.front().T_map_base.translation(),
                            fmt::format("of {} independent matches only {} agree with the map",
                                        report.num_matched,
                                        report.num_agreeing)));
}

bool was_odometry_refused(const Map& map) {
  const OdometryVerdict verdict = map.odometry.verdict;
  return verdict == OdometryVerdict::kStill || verdict == OdometryVerdict::kMirrored ||
         verdict == OdometryVerdict::kUnlike;
}

ScanRange range_of(const OpenStretch& stretch) {
  return {stretch.first_scan, stretch.first_scan + stretch.num_scans - 1};
}

/// Whether the log ends in the stretch, and hardly moves in it: nothing hangs on its length.
bool is_standing_end(const OpenStretch& stretch, const Map& map) {
  return range_of(stretch).last + 1 == map.scans.size() && stretch.way_m < kShortEnd_m;
}

/// The open stretches whose length tracking and closures leave unknown.
std::vector<OpenStretch> wide_stretches(const Map& map) {
  std::vector<OpenStretch> wide;
  for (const OpenStretch& stretch : map.open_stretches) {
    if (stretch.num_scans == 0 || !(stretch.length_sigma_m > kWideSigma_m)) continue;
    if (!map.scans[stretch.first_scan].is_placed || is_standing_end(stretch, map)) continue;
    wide.push_back(stretch);
  }
  return wide;
}

/// Whether pairs of scans from before and after the stretch, and no other such stretch between
/// them, agree with the map: then its length is known after all.
bool is_measured(const ScanRange& range,
                 const std::vector<OpenStretch>& wide,
                 const Map& map,
                 const AuditFindings& findings,
                 const AuditParams& params) {
  constexpr std::size_t kMinPairs = 2;
  const std::size_t nearly_last = range.last - (range.last - range.first) / 4;
  std::size_t num_pairs = 0;
  for (const AuditMatch& match : findings.matches) {
    const ScanRange between{map.keyframes[findings.track.keyframes[match.pair.from]],
                            map.keyframes[findings.track.keyframes[match.pair.to]]};
    if (between.first >= range.first || between.last < nearly_last) continue;
    const auto num_inside = std::count_if(wide.begin(), wide.end(), [&](const OpenStretch& other) {
      const ScanRange inside = range_of(other);
      return inside.last > between.first && inside.first < between.last;
    });
    if (num_inside > 1) continue;
    num_pairs += agrees(audit_offset(match, findings.track, params), params) ? 1 : 0;
  }
  return num_pairs >= kMinPairs;
}

void add_unknown_lengths(const Map& map,
                         const AuditFindings& findings,
                         const AuditParams& params,
                         std::vector<MapDoubt>& doubts) {
  const std::vector<OpenStretch> wide = wide_stretches(map);
  for (const OpenStretch& stretch : wide) {
    const ScanRange range = range_of(stretch);
    if (is_measured(range, wide, map, findings, params)) continue;
    const bool is_refused = !stretch.has_odometry && was_odometry_refused(map);
    const std::string sigma = std::isfinite(stretch.length_sigma_m)
                                  ? fmt::format("to {:.2f} m (sigma)", stretch.length_sigma_m)
                                  : "to nothing";
    const std::string refused =
        is_refused ? fmt::format("; the odometry, refused as {}, could not stand in",
                                 to_string(map.odometry.verdict))
                   : "";
    doubts.push_back(doubt_at(
        map,
        is_refused ? DoubtKind::kRefusedOdometry : DoubtKind::kUnknownLength,
        range,
        middle_of(map, range),
        fmt::format("the walls leave a direction open along {:.1f} m, whose length is known "
                    "{}{}",
                    stretch.way_m,
                    sigma,
                    refused)));
  }
}

/// A mirrored map agrees with itself: no match contradicts it, odometry and gyro alone do.
void add_mirrored(const Map& map, std::vector<MapDoubt>& doubts) {
  const bool by_odometry = map.odometry.verdict == OdometryVerdict::kMirrored;
  if (map.scans.empty() || !(by_odometry || map.gyro.turns_other_way())) return;
  const ScanRange all{0, map.scans.size() - 1};
  doubts.push_back(doubt_at(map,
                            DoubtKind::kMirrored,
                            all,
                            map.scans.front().T_map_base.translation(),
                            fmt::format("the {} turns the other way than the scans: a scanner "
                                        "mounted upside down mirrors the whole map, or the {} is "
                                        "wrong",
                                        by_odometry ? "odometry" : "gyro",
                                        by_odometry ? "odometry" : "gyro")));
}

/// What follows hangs on the turn.
void add_undecided_turns(const Map& map,
                         const AuditFindings& findings,
                         const AuditParams& params,
                         std::vector<MapDoubt>& doubts) {
  for (const UndecidedTurn& turn : map.undecided_turns) {
    if (std::abs(turn.turned_rad) < kTurned_rad) continue;
    if (!map.scans[turn.first_scan].is_placed || !map.scans[turn.last_scan].is_placed) continue;
    const ScanRange range{turn.first_scan, turn.last_scan};
    const std::size_t last =
        last_that_hangs(map, findings, turn.first_scan, turn.last_scan, params);
    doubts.push_back(doubt_at(
        map,
        DoubtKind::kUndecidedTurn,
        {turn.first_scan, last},
        middle_of(map, range),
        fmt::format("the walls turn by {:.1f} deg: tracking slipped, or another wing begins; "
                    "no match of {} tells which",
                    deg_from_rad(std::abs(turn.turned_rad)),
                    text_of(range))));
  }
}

/// Pieces that follow each other make one doubt, where the track was last in the map.
void add_unjoined(const Map& map, std::vector<MapDoubt>& doubts) {
  for (std::size_t i = 0; i < map.pieces.size(); ++i) {
    if (map.pieces[i].is_joined || map.pieces[i].num_scans == 0) continue;
    const std::size_t first = i;
    while (i + 1 < map.pieces.size() && !map.pieces[i + 1].is_joined) ++i;
    const std::size_t begin = map.pieces[first].first_scan;
    const ScanRange range{begin, map.pieces[i].first_scan + map.pieces[i].num_scans - 1};
    const std::size_t after = range.last + 1;
    const std::size_t last_placed = begin > 0 ? begin - 1 : std::min(after, map.scans.size() - 1);
    const std::size_t num_pieces = i - first + 1;
    doubts.push_back(doubt_at(map,
                              DoubtKind::kUnjoinedPiece,
                              range,
                              map.scans[last_placed].T_map_base.translation(),
                              std::to_string(num_pieces) +
                                  (num_pieces == 1 ? " piece" : " pieces") +
                                  " of track after this place could not be joined to the map"));
  }
}

/// Scans that stand where they were expected, for long: a scanner that hung, was covered, or lost.
void add_unseen(const Map& map, std::vector<MapDoubt>& doubts) {
  const auto is_unseen = [](const MappedScan& scan) {
    return scan.is_placed && scan.status == TrackStatus::kLost;
  };
  for (std::size_t first = 0; first < map.scans.size(); ++first) {
    double sigma_m = 0.0;
    double sigma_rad = 0.0;
    std::size_t end = first;
    for (; end < map.scans.size() && is_unseen(map.scans[end]); ++end) {
      sigma_m = std::max(sigma_m, map.scans[end].position_sigma_m);
      sigma_rad = std::max(sigma_rad, map.scans[end].heading_sigma_rad);
    }
    if (end == first) continue;
    const ScanRange range{first, end - 1};
    first = end;
    const double time_s =
        seconds_between(map.scans[range.first].stamp, map.scans[range.last].stamp);
    const bool is_wide = sigma_m > kUnseenSigma_m || sigma_rad > kUnseenSigma_rad;
    if (time_s < kLongUnseen_s || !is_wide) continue;
    doubts.push_back(
        doubt_at(map,
                 DoubtKind::kNotSeen,
                 range,
                 middle_of(map, range),
                 fmt::format("{} scans in a row, over {:.0f} s, tell nothing of where "
                             "the robot was; it may be off by {}",
                             range.last - range.first + 1,
                             time_s,
                             std::isfinite(sigma_m) ? fmt::format("{:.1f} m (sigma)", sigma_m)
                                                    : "any distance")));
  }
}

/// Two places that were taken for one: floors, twins, rooms behind a slip.
void add_crossed_walls(const Map& map,
                       const AuditFindings& findings,
                       std::vector<MapDoubt>& doubts) {
  const auto scan_of = [&](std::size_t k) { return map.keyframes[findings.track.keyframes[k]]; };
  for (const CrossedWalls& crossed : findings.crossed) {
    const ScanRange range{scan_of(crossed.first), scan_of(crossed.last)};
    const ScanRange by{scan_of(crossed.first_by), scan_of(crossed.last_by)};
    doubts.push_back(doubt_at(
        map,
        DoubtKind::kCrossedWalls,
        range,
        middle_of(map, range),
        fmt::format(
            "{} see walls along {:.1f} m of the way that {} saw through: two places may lie "
            "over each other",
            text_of(range),
            findings.track.way_m[crossed.last] - findings.track.way_m[crossed.first],
            text_of(by))));
  }
}

/// Whether two closures are between the same two parts of the track.
bool are_of_same_parts(const MappedClosure& a, const MappedClosure& b, const Map& map) {
  const auto near = [&](std::size_t scan, std::size_t other) {
    const auto [first, last] = std::minmax(scan, other);
    double way_m = 0.0;
    for (std::size_t i = first + 1; i <= last && way_m < kOutvotedPart_m; ++i) {
      way_m += (map.scans[i].T_map_base.translation() - map.scans[i - 1].T_map_base.translation())
                   .norm();
    }
    return way_m < kOutvotedPart_m;
  };
  return near(a.scan_i, b.scan_i) && near(a.scan_j, b.scan_j);
}

/// Closures that were outvoted, in groups: some are the closures' own errors, but where they are
/// many and outnumber those that hold between the same parts of the track it may be the map's.
void add_outvoted_closures(const Map& map, std::vector<MapDoubt>& doubts) {
  std::vector<const MappedClosure*> left;
  std::vector<const MappedClosure*> held;
  for (const MappedClosure& closure : map.closures) {
    if (!closure.closure.is_accepted) continue;
    (closure.closure.is_outvoted() ? left : held).push_back(&closure);
  }
  while (!left.empty()) {
    const MappedClosure& centre = *left.front();
    ScanRange from{centre.scan_i, centre.scan_i};
    ScanRange to{centre.scan_j, centre.scan_j};
    const auto is_same = [&](const MappedClosure* other) {
      return are_of_same_parts(centre, *other, map);
    };
    const auto num_held =
        static_cast<std::size_t>(std::count_if(held.begin(), held.end(), is_same));
    std::size_t num = 0;
    std::erase_if(left, [&](const MappedClosure* other) {
      if (!is_same(other)) return false;
      from.add({other->scan_i, other->scan_i});
      to.add({other->scan_j, other->scan_j});
      ++num;
      return true;
    });
    if (num < kMinOutvoted || num <= num_held) continue;
    doubts.push_back(
        doubt_at(map,
                 DoubtKind::kOutvotedClosures,
                 to,
                 map.scans[centre.scan_j].T_map_base.translation(),
                 fmt::format("{} loop closures of {} with {} were outvoted, {} between the same "
                             "places hold",
                             num,
                             text_of(to),
                             text_of(from),
                             num_held)));
  }
}

}  // namespace

std::vector<MapDoubt> doubts_of(const Map& map,
                                const AuditFindings& findings,
                                const AuditParams& params) {
  std::vector<MapDoubt> doubts;
  add_mirrored(map, doubts);
  add_contradictions(map, findings, params, doubts);
  add_few_agreeing(map, findings.report, doubts);
  add_outvoted_closures(map, doubts);
  add_crossed_walls(map, findings, doubts);
  add_unknown_lengths(map, findings, params, doubts);
  add_unseen(map, doubts);
  add_undecided_turns(map, findings, params, doubts);
  add_unjoined(map, doubts);
  return doubts;
}

}  // namespace setsquare
