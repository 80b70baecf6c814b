// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/turn_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

void TurnCheckParams::validate() const {
  require_positive(agreeing_rad, "agreeing_rad");
  require_positive(slip_sigma_rad, "slip_sigma_rad");
  require_positive(unlikely_slip_sigmas, "unlikely_slip_sigmas");
  require_positive(min_degenerate_probability, "min_degenerate_probability");
  if (longest_hop < 1) throw ParameterError("longest_hop", "must be at least 1");
}

namespace {

/// Else a few returns fit however they are laid: neither matches nor tracking tell how far the
/// robot turned.
bool sees_walls(const Keyframe& keyframe, std::size_t min_beams) {
  return keyframe.scan->num_beams() >= min_beams;
}

}  // namespace

/// What a match says of the turn between two keyframes.
struct TurnChecks::SeenTurn {
  double beyond_rad = 0.0;  ///< By how much more the robot turned than is known.
  bool is_matched = false;  ///< Else degenerate: it may confirm, but measures nothing.
};

/// Matches of a track's keyframes, each scan prepared once.
class TurnChecks::Matches {
 public:
  Matches(const KeyframeTrack& track, const TurnCheckParams& params)
      : track_(track), params_(params) {}

  [[nodiscard]] std::size_t size() const { return track_.size(); }
  /// How far keyframe b is turned against a beyond what was tracked; nothing where they do not
  /// match, or where nothing was tracked between them.
  [[nodiscard]] std::optional<SeenTurn> beyond_tracked(std::size_t a, std::size_t b) {
    if (track_.pieces[a] != track_.pieces[b]) return std::nullopt;
    if (!sees_walls(*track_.keyframes[a], params_.min_beams)) return std::nullopt;
    if (!sees_walls(*track_.keyframes[b], params_.min_beams)) return std::nullopt;
    const MatchResult result = match(prepared(a), prepared(b));
    const bool is_matched = result.status == MatchStatus::kMatched;
    const bool is_probable = result.status == MatchStatus::kDegenerate &&
                             result.probability >= params_.min_degenerate_probability;
    if (!is_matched && !is_probable) return std::nullopt;
    const double tracked_rad =
        track_.keyframes[b]->T_odom_sensor.theta_rad - track_.keyframes[a]->T_odom_sensor.theta_rad;
    return SeenTurn{.beyond_rad = wrap_to_pi(result.T_reference_current->theta_rad - tracked_rad),
                    .is_matched = is_matched};
  }

 private:
  const PreparedScan& prepared(std::size_t k) {
    const auto known = prepared_.find(k);
    if (known != prepared_.end()) return known->second;
    return prepared_.emplace(k, prepare(track_.keyframes[k]->surfaces)).first->second;
  }

  const KeyframeTrack& track_;
  const TurnCheckParams& params_;
  std::map<std::size_t, PreparedScan> prepared_;
};

std::vector<HeadingEvidence> TurnChecks::checked(std::vector<HeadingEvidence> evidence) const {
  double slipped_rad = 0.0;
  for (std::size_t k = 1; k < evidence.size(); ++k) {
    const Step& step = steps_[k];
    slipped_rad += step.slip_rad;
    evidence[k].tracked_heading_rad += slipped_rad;
    if (!step.is_confirmed) continue;
    evidence[k].is_step_confirmed = true;
    if (step.slip_rad != 0.0) evidence[k].step_sigma_rad = params_.slip_sigma_rad;
  }
  return evidence;
}

std::optional<TurnChecks::SeenTurn> TurnChecks::beyond_known(std::size_t a,
                                                             std::size_t b,
                                                             Matches& matches) const {
  std::optional<SeenTurn> seen = matches.beyond_tracked(a, b);
  if (!seen) return std::nullopt;
  for (std::size_t k = a + 1; k <= b; ++k) seen->beyond_rad -= steps_[k].slip_rad;
  seen->beyond_rad = wrap_to_pi(seen->beyond_rad);
  return seen;
}

bool TurnChecks::agrees(const SeenTurn& seen) const {
  return std::abs(seen.beyond_rad) < params_.agreeing_rad;
}

void TurnChecks::hop_along(const DoubtedTurn& turn, Matches& matches) {
  const auto confirms = [&](std::size_t a, std::size_t b) {
    const std::optional<SeenTurn> seen = beyond_known(a, b, matches);
    return seen && agrees(*seen);
  };
  for (std::size_t a = turn.from; a < turn.to;) {
    std::size_t hop = std::min(params_.longest_hop, turn.to - a);
    while (hop > 0 && !confirms(a, a + hop)) hop /= 2;
    for (std::size_t k = a + 1; k <= a + hop; ++k) steps_[k].is_confirmed = true;
    a += std::max<std::size_t>(hop, 1);
  }
}

void TurnChecks::bridge(const DoubtedTurn& gap, Matches& matches) {
  std::vector<double> slips_rad;
  const auto settle = [&](double slip_rad) {
    for (std::size_t k = gap.from + 1; k <= gap.to; ++k) steps_[k].is_confirmed = true;
    steps_[gap.to].slip_rad = slip_rad;
  };
  const std::size_t longest_hop = std::min(params_.longest_hop, matches.size() - 1);
  for (std::size_t hop = gap.to - gap.from; hop <= longest_hop; ++hop) {
    const std::size_t last = std::min(gap.from, matches.size() - 1 - hop);
    for (std::size_t a = std::max(gap.to, hop) - hop; a <= last; ++a) {
      const std::optional<SeenTurn> seen = beyond_known(a, a + hop, matches);
      if (!seen) continue;
      if (slips_rad.empty() && agrees(*seen)) return settle(0.0);
      if (!seen->is_matched) continue;
      slips_rad.push_back(seen->beyond_rad);
      if (slips_rad.size() < params_.min_slip_matches) continue;
      std::sort(slips_rad.begin(), slips_rad.end());
      if (slips_rad.back() - slips_rad.front() > params_.agreeing_rad) return;
      return settle(slips_rad[slips_rad.size() / 2]);
    }
  }
}

bool TurnChecks::check(const DoubtedTurn& turn, Matches& matches) {
  const auto step_at = [&](std::size_t k) {
    return steps_.begin() + static_cast<std::ptrdiff_t>(k);
  };
  const auto is_checked = [](const Step& step) { return step.is_checked; };
  if (std::all_of(step_at(turn.from + 1), step_at(turn.to + 1), is_checked)) return false;
  hop_along(turn, matches);
  for (std::size_t k = turn.from + 1; k <= turn.to; ++k) {
    steps_[k].is_checked = true;
    if (steps_[k].is_confirmed) continue;
    std::size_t end = k;
    while (end < turn.to && !steps_[end + 1].is_confirmed) ++end;
    bridge({.from = k - 1, .to = end}, matches);
  }
  return true;
}

FusedHeadings TurnChecks::fuse(const KeyframeTrack& track,
                               const std::vector<HeadingEvidence>& evidence,
                               const HeadingFusionParams& params) {
  steps_.resize(std::max(steps_.size(), evidence.size()));
  Matches matches(track, params_);
  FusedHeadings fused = fuse_headings(checked(evidence), params);
  for (int round = 0; round < params_.max_rounds; ++round) {
    bool is_new = false;
    for (const DoubtedTurn& turn : fused.doubted) is_new = check(turn, matches) || is_new;
    if (!is_new) break;
    fused = fuse_headings(checked(evidence), params);
  }
  fused = with_turns_held(std::move(fused), track, evidence, params);
  for (std::size_t k = 0; k < track.size(); ++k) {
    fused.drift_rad[k] = fused.heading_rad[k] - evidence[k].tracked_heading_rad;
  }
  return fused;
}

FusedHeadings TurnChecks::with_turns_held(FusedHeadings fused,
                                          const KeyframeTrack& track,
                                          const std::vector<HeadingEvidence>& evidence,
                                          const HeadingFusionParams& params) const {
  const auto is_unlikely_slip = [&](const DoubtedTurn& turn) {
    for (const std::size_t k : {turn.from, turn.to}) {
      if (!sees_walls(*track.keyframes[k], params_.min_beams)) return false;
    }
    double variance_rad2 = 0.0;
    for (std::size_t k = turn.from + 1; k <= turn.to; ++k) {
      variance_rad2 += evidence[k].step_sigma_rad * evidence[k].step_sigma_rad;
    }
    return std::abs(turn.turned_rad) > params_.unlikely_slip_sigmas * std::sqrt(variance_rad2);
  };
  TurnChecks held = *this;
  bool is_any = false;
  for (const DoubtedTurn& turn : fused.doubted) {
    if (!is_unlikely_slip(turn)) continue;
    held.decide(turn, 0.0);
    is_any = true;
  }
  if (!is_any && turned_.empty()) return fused;
  FusedHeadings again = fuse_headings(held.checked(evidence), params, turned_);
  if (!turned_.empty()) fused.doubted = without_settled(std::move(fused.doubted), turned_);
  again.doubted = std::move(fused.doubted);
  return again;
}

void TurnChecks::decide(const DoubtedTurn& turn, double beyond_rad) {
  steps_.resize(std::max(steps_.size(), turn.to + 1));
  for (std::size_t k = turn.from + 1; k <= turn.to; ++k) {
    steps_[k] = {.is_checked = true, .is_confirmed = true};
  }
  steps_[turn.to].slip_rad = beyond_rad;
}

void TurnChecks::turn_walls(std::span<const TurnedWalls> turned) {
  turned_.insert(turned_.end(), turned.begin(), turned.end());
}

void TurnChecks::keep_only(std::span<const std::size_t> kept) {
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const bool is_joined = kept[i] != kept[i - 1] + 1;
    steps_[i] = is_joined ? Step{.is_checked = true, .is_confirmed = true} : steps_[kept[i]];
  }
  steps_.resize(kept.size());
  turned_.clear();
}

}  // namespace setsquare
