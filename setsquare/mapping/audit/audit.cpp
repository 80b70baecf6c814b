// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/audit.hpp"

#include <cassert>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/mapping/audit/doubts.hpp"
#include "setsquare/mapping/audit/matched_pairs.hpp"
#include "setsquare/mapping/audit/unseconded_steps.hpp"

namespace setsquare {
namespace {

/// Places of the track from which the sample is drawn, at most.
constexpr std::size_t kMaxNumPlaces = 240;
/// Contradictions about which more pairs are matched, at most.
constexpr std::size_t kMaxNumFollowed = 24;

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

std::vector<CrossedWalls> crossed_in(const AuditedTrack& track,
                                     std::span<const ScanSurfacesPtr> surfaces,
                                     const AuditParams& params,
                                     std::size_t num_threads) {
  std::vector<ScanSurfacesPtr> of_track;
  of_track.reserve(track.size());
  for (const std::size_t keyframe : track.keyframes) of_track.push_back(surfaces[keyframe]);
  return crossed_walls(seen_through(of_track, track.T_map_sensor, track.way_m, num_threads),
                       track.way_m,
                       params.min_crossed_m);
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
  require_positive(min_crossed_m, "audit.min_crossed_m");
  if (max_mendings < 0) throw ParameterError("audit.max_mendings", "must not be negative");
}

MapHypothesis hypothesis_by(const AuditMatch& match,
                            const AuditedTrack& track,
                            std::size_t num_places,
                            std::size_t num_agreeing) {
  return {.keyframe_from = track.keyframes[match.pair.from],
          .keyframe_to = track.keyframes[match.pair.to],
          .T_from_to = match.T_from_to,
          .information = match.information,
          .num_places = num_places,
          .num_agreeing = num_agreeing};
}

std::vector<MapHypothesis> AuditFindings::hypotheses() const {
  std::vector<MapHypothesis> found;
  for (const ContradictionGroup& group : groups) {
    if (!group.is_hypothesis()) continue;
    for (const std::size_t i : group.members) {
      found.push_back(hypothesis_by(matches[i], track, group.num_places, group.num_agreeing));
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
  MatchedPairs matched(track, surfaces, num_threads);
  const auto places = matched.places(spread_places(track, kMaxNumPlaces));
  matched.match(sampled_pairs(track, places, params), MatchEffort::kQuick);
  const auto first_groups = contradiction_groups(matched.matches(), track, params);
  matched.match_about(first_groups, kMaxNumFollowed);
  findings.matches = matched.matches();
  findings.groups = contradiction_groups(findings.matches, track, params);
  findings.report = report_of(matched.num_tried(), findings.matches.size(), findings.groups);
  findings.crossed = crossed_in(track, surfaces, params, num_threads);
  for (const std::size_t step : unseconded_steps(track, params, matched)) {
    findings.unseconded.push_back(track.keyframes[step]);
  }
  for (const std::size_t place : astray_keyframes(matched.matches(), track, params)) {
    findings.astray.push_back(track.keyframes[place]);
  }
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

bool explains_as_much(const AuditReport& mended, const AuditReport& before) {
  return mended.num_seconded <= before.num_seconded &&
         mended.num_agreeing * before.num_matched >= before.num_agreeing * mended.num_matched;
}

void audit_map(Map& map,
               std::span<const ScanSurfacesPtr> surfaces,
               const AuditParams& params,
               std::size_t num_threads) {
  add_findings(audit(map, surfaces, params, num_threads), params, map);
}

}  // namespace setsquare
