// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/audit.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/mapping/audit/doubts.hpp"
#include "setsquare/matching/scan_matcher.hpp"

namespace setsquare {
namespace {

/// Places of the track from which the sample is drawn, at most.
constexpr std::size_t kMaxNumPlaces = 240;
/// Contradictions about which more pairs are matched, at most.
constexpr std::size_t kMaxNumFollowed = 24;

/// How hard a match is sought: by rotations from the walls' directions alone, which finds nine in
/// ten and costs an eighth; or over every rotation of the circle where these find nothing.
enum class Effort { kQuick, kThorough };

/// The track's scans, prepared when they are first needed, and the pairs matched so far.
class Auditor {
 public:
  Auditor(const AuditedTrack& track,
          std::span<const ScanSurfacesPtr> surfaces,
          std::size_t num_threads)
      : track_(track), surfaces_(surfaces), num_threads_(num_threads), prepared_(track.size()) {}

  [[nodiscard]] std::vector<AuditedPlace> places() {
    const std::vector<std::size_t> spread = spread_places(track_, kMaxNumPlaces);
    prepare_all(spread);
    std::vector<AuditedPlace> places(spread.size());
    run_in_parallel(spread.size(), num_threads_, [&](std::size_t i) {
      const std::size_t k = spread[i];
      places[i] = {k, place_signature(prepared_[k]->fine, track_.T_map_sensor[k].theta_rad)};
    });
    return places;
  }

  /// Matches those of the pairs that it has not matched.
  void match(const std::vector<AuditPair>& pairs, Effort effort) {
    std::vector<AuditPair> untried;
    std::vector<std::size_t> needed;
    for (const AuditPair& pair : pairs) {
      if (!tried_.insert(pair).second) continue;
      untried.push_back(pair);
      needed.push_back(pair.from);
      needed.push_back(pair.to);
    }
    prepare_all(needed);
    MatchParams params;
    if (effort == Effort::kQuick) params.thorough.num_rotations = 0;
    std::vector<MatchResult> results(untried.size());
    run_in_parallel(untried.size(), num_threads_, [&](std::size_t i) {
      results[i] = setsquare::match(*prepared_[untried[i].from], *prepared_[untried[i].to], params);
    });
    for (std::size_t i = 0; i < untried.size(); ++i) {
      if (results[i].status != MatchStatus::kMatched) continue;
      matches_.push_back({untried[i], *results[i].T_reference_current, results[i].information});
    }
  }

  [[nodiscard]] std::size_t num_tried() const { return tried_.size(); }
  [[nodiscard]] const std::vector<AuditMatch>& matches() const { return matches_; }

 private:
  void prepare_all(std::vector<std::size_t> keyframes) {
    std::sort(keyframes.begin(), keyframes.end());
    keyframes.erase(std::unique(keyframes.begin(), keyframes.end()), keyframes.end());
    std::erase_if(keyframes, [&](std::size_t k) { return prepared_[k].has_value(); });
    run_in_parallel(keyframes.size(), num_threads_, [&](std::size_t i) {
      const std::size_t k = keyframes[i];
      prepared_[k] = prepare(surfaces_[track_.keyframes[k]]);
    });
  }

  const AuditedTrack& track_;
  std::span<const ScanSurfacesPtr> surfaces_;
  std::size_t num_threads_;
  std::vector<std::optional<PreparedScan>> prepared_;  ///< One per keyframe of the track.
  std::set<AuditPair> tried_;
  std::vector<AuditMatch> matches_;
};

/// Pairs about the contradictions, the centres of the greatest groups first.
std::vector<AuditPair> second_opinions(const std::vector<ContradictionGroup>& groups,
                                       const std::vector<AuditMatch>& matches,
                                       const AuditedTrack& track) {
  std::vector<AuditPair> pairs;
  for (std::size_t i = 0; i < std::min(groups.size(), kMaxNumFollowed); ++i) {
    const auto about = pairs_about(track, matches[groups[i].centre].pair);
    pairs.insert(pairs.end(), about.begin(), about.end());
  }
  return pairs;
}

AuditReport report_of(std::size_t num_pairs,
                      std::size_t num_matched,
                      const std::vector<ContradictionGroup>& groups) {
  AuditReport report{.num_pairs = num_pairs, .num_matched = num_matched};
  for (const ContradictionGroup& group : groups) {
    report.num_contradicting += group.members.size();
    if (group.raises_doubt) report.num_seconded += group.members.size();
  }
  report.num_agreeing = num_matched - report.num_contradicting;
  return report;
}

}  // namespace

void AuditParams::validate() const {
  require_positive(pairs_per_keyframe, "audit.pairs_per_keyframe");
  require_at_least_one(min_num_pairs, "audit.min_num_pairs");
  if (max_num_pairs < min_num_pairs) {
    throw ParameterError("audit.max_num_pairs", "must not be below audit.min_num_pairs");
  }
  require_positive(near_m, "audit.near_m");
  require_not_negative(min_way_m, "audit.min_way_m");
  require_not_negative(revisit_way_m, "audit.revisit_way_m");
  require_positive(off_m, "audit.off_m");
  require_positive(off_rad, "audit.off_rad");
  require_not_negative(max_sigmas, "audit.max_sigmas");
  require_positive(part_m, "audit.part_m");
  require_positive(alike_m, "audit.alike_m");
  require_not_negative(alike_share, "audit.alike_share");
  require_positive(alike_rad, "audit.alike_rad");
  require_at_least_one(min_seconded, "audit.min_seconded");
  require_positive(min_majority, "audit.min_majority");
  if (max_mendings < 0) throw ParameterError("audit.max_mendings", "must not be negative");
}

std::vector<MapHypothesis> AuditFindings::hypotheses() const {
  std::vector<MapHypothesis> found;
  for (const ContradictionGroup& group : groups) {
    if (!group.raises_doubt) continue;
    for (const std::size_t i : group.members) {
      found.push_back({.keyframe_from = track.keyframes[matches[i].pair.from],
                       .keyframe_to = track.keyframes[matches[i].pair.to],
                       .T_from_to = matches[i].T_from_to,
                       .information = matches[i].information,
                       .num_places = group.num_places,
                       .num_agreeing = group.num_agreeing});
    }
  }
  return found;
}

AuditFindings audit(const Map& map,
                    std::span<const ScanSurfacesPtr> surfaces,
                    const AuditParams& params,
                    std::size_t num_threads) {
  assert(surfaces.size() == map.keyframes.size());
  params.validate();
  AuditFindings findings;
  findings.track = audited_track(map);
  const AuditedTrack& track = findings.track;
  Auditor auditor(track, surfaces, num_threads);
  auditor.match(sampled_pairs(track, auditor.places(), params), Effort::kQuick);
  const auto first_groups = contradiction_groups(auditor.matches(), track, params);
  auditor.match(second_opinions(first_groups, auditor.matches(), track), Effort::kThorough);
  findings.matches = auditor.matches();
  findings.groups = contradiction_groups(findings.matches, track, params);
  findings.report = report_of(auditor.num_tried(), findings.matches.size(), findings.groups);
  return findings;
}

void add_findings(const AuditFindings& findings, const AuditParams& params, Map& map) {
  map.audit = findings.report;
  map.doubts = doubts_of(map, findings, params);
}

bool explains_more(const AuditReport& mended, const AuditReport& before) {
  return mended.num_seconded < before.num_seconded &&
         mended.num_agreeing * before.num_matched > before.num_agreeing * mended.num_matched;
}

void audit_map(Map& map,
               std::span<const ScanSurfacesPtr> surfaces,
               const AuditParams& params,
               std::size_t num_threads) {
  add_findings(audit(map, surfaces, params, num_threads), params, map);
}

}  // namespace setsquare
