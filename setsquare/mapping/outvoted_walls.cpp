// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/outvoted_walls.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/core/robust_weight.hpp"
#include "setsquare/graph/block_equations.hpp"

namespace setsquare {
namespace {

/// No rotation binds more than by this standard deviation: of walls that go on, and of tracked
/// rotations between two places.
constexpr double kStepSigma_rad = rad_from_deg(0.3);
/// What it costs to break walls that go on, in tracked rotations: neither they nor all that see
/// them err by chance.
constexpr double kWallsWeight = 2.0;

/// A seen turn against the headings.
struct Miss {
  std::size_t from = 0;  ///< Keyframe, before `to`.
  std::size_t to = 0;
  double off_rad = 0.0;    ///< By which `to` turned more than the headings say.
  double sigma_rad = 0.0;  ///< Of that.
  double weight = 1.0;     ///< One over the turns that are seen at the same place.
};

std::vector<Miss> misses_of(const FusedHeadings& headings,
                            std::span<const SeenTurn> seen,
                            const OutvotedWallsParams& params) {
  std::vector<Miss> misses;
  for (const SeenTurn& turn : seen) {
    const double turned_rad = headings.heading_rad[turn.to] - headings.heading_rad[turn.from];
    const double off_rad = wrap_to_pi(turn.turned_rad - turned_rad);
    if (std::abs(off_rad) > params.max_turn_rad || turn.from == turn.to) continue;
    const double sigma_rad = std::hypot(turn.sigma_rad, params.seen_sigma_rad);
    if (turn.from < turn.to) {
      misses.push_back({turn.from, turn.to, off_rad, sigma_rad});
    } else {
      misses.push_back({turn.to, turn.from, -off_rad, sigma_rad});
    }
  }
  std::ranges::sort(misses, {}, [](const Miss& miss) { return std::pair(miss.from, miss.to); });
  return misses;
}

bool are_of_one_place(const Miss& a,
                      const Miss& b,
                      std::span<const double> ways_m,
                      double same_place_m) {
  return std::abs(ways_m[a.from] - ways_m[b.from]) < same_place_m &&
         std::abs(ways_m[a.to] - ways_m[b.to]) < same_place_m;
}

/// Of misses in the order of `from`: those of one place that tell the same are one.
void share_places(std::span<const double> ways_m,
                  const OutvotedWallsParams& params,
                  std::vector<Miss>& misses) {
  std::vector<double> num(misses.size(), 1.0);
  for (std::size_t a = 0; a < misses.size(); ++a) {
    for (std::size_t b = a + 1; b < misses.size(); ++b) {
      if (ways_m[misses[b].from] - ways_m[misses[a].from] >= params.same_place_m) break;
      if (!are_of_one_place(misses[a], misses[b], ways_m, params.same_place_m)) continue;
      if (std::abs(misses[a].off_rad - misses[b].off_rad) > params.min_turn_rad) continue;
      num[a] += 1.0;
      num[b] += 1.0;
    }
  }
  for (std::size_t i = 0; i < misses.size(); ++i) misses[i].weight = 1.0 / num[i];
}

std::size_t num_places(const std::vector<Miss>& misses,
                       std::span<const double> ways_m,
                       double same_place_m) {
  std::vector<Miss> counted;
  for (const Miss& miss : misses) {
    if (std::ranges::none_of(counted, [&](const Miss& other) {
          return are_of_one_place(miss, other, ways_m, same_place_m);
        })) {
      counted.push_back(miss);
    }
  }
  return counted.size();
}

/// Whether a heading that is off so much contradicts what was seen.
bool contradicts(double off_rad, const Miss& miss, const OutvotedWallsParams& params) {
  return std::abs(off_rad) > std::max(params.min_turn_rad, params.max_sigmas * miss.sigma_rad);
}

std::vector<Miss> contradicting(const std::vector<Miss>& misses,
                                const OutvotedWallsParams& params) {
  std::vector<Miss> found;
  std::ranges::copy_if(misses, std::back_inserter(found), [&](const Miss& miss) {
    return contradicts(miss.off_rad, miss, params);
  });
  return found;
}

/// What an unknown is bound to: another one, or nothing.
struct Bond {
  std::size_t a = 0;
  std::size_t b = 0;
  double value_rad = 0.0;  ///< Of b less a.
  double weight = 1.0;
  double sigma_rad = 0.0;
};

/// By how much the headings are off at the keyframes that turns name, and frames' offsets with
/// them.
class Corrections {
 public:
  Corrections(const FusedHeadings& headings,
              std::span<const HeadingEvidence> evidence,
              const std::vector<Miss>& misses) {
    for (const Miss& miss : misses) {
      keyframes_.push_back(miss.from);
      keyframes_.push_back(miss.to);
    }
    std::ranges::sort(keyframes_);
    const auto twice = std::ranges::unique(keyframes_);
    keyframes_.erase(twice.begin(), twice.end());
    for (const Miss& miss : misses) {
      bonds_.push_back({.a = index_of(miss.from),
                        .b = index_of(miss.to),
                        .value_rad = miss.off_rad,
                        .weight = miss.weight,
                        .sigma_rad = miss.sigma_rad});
    }
    add_tracked(headings, evidence);
    add_walls(headings);
    const std::size_t num = keyframes_.size() + headings.frames.size();
    off_rad_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num));
  }

  /// Step 2 of outvoted_walls.
  void solve() {
    constexpr int kNumIterations = 50;
    constexpr double kFirstScale = 100.0;  // Nothing is off by so many sigmas.
    constexpr double kFall = 0.85;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const Bond& bond : bonds_) pairs.emplace_back(bond.a, bond.b);
    BlockEquations<1> equations(static_cast<std::size_t>(off_rad_.size()), pairs);
    double scale = kFirstScale;
    for (int iteration = 0; iteration < kNumIterations; ++iteration) {
      fill(scale, equations);
      if (!(equations.factor() > 0.0)) return;
      off_rad_ = equations.solve(equations.b);
      scale = std::max(1.0, kFall * scale);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& keyframes() const { return keyframes_; }
  [[nodiscard]] double off_rad(std::size_t i) const {
    return off_rad_(static_cast<Eigen::Index>(i));
  }

 private:
  [[nodiscard]] std::size_t index_of(std::size_t keyframe) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(keyframes_, keyframe) -
                                    keyframes_.begin());
  }

  void add_tracked(const FusedHeadings& headings, std::span<const HeadingEvidence> evidence) {
    for (std::size_t i = 1; i < keyframes_.size(); ++i) {
      double variance_rad2 = kStepSigma_rad * kStepSigma_rad;
      for (std::size_t k = keyframes_[i - 1] + 1; k <= keyframes_[i]; ++k) {
        variance_rad2 += evidence[k].step_sigma_rad * evidence[k].step_sigma_rad;
      }
      const double drifted_rad =
          headings.drift_rad[keyframes_[i]] - headings.drift_rad[keyframes_[i - 1]];
      bonds_.push_back(
          {.a = i - 1, .b = i, .value_rad = -drifted_rad, .sigma_rad = std::sqrt(variance_rad2)});
    }
  }

  /// Where the walls of one frame are seen all along, neighbours are off alike; where others begin,
  /// as the frame's offset is.
  void add_walls(const FusedHeadings& headings) {
    int frame = -1;  // Seen last.
    std::size_t k = 0;
    for (std::size_t i = 0; i < keyframes_.size(); ++i) {
      bool goes_on = frame >= 0;
      for (; k <= keyframes_[i]; ++k) {
        if (headings.frame[k] < 0) continue;
        goes_on = goes_on && headings.frame[k] == frame;
        frame = headings.frame[k];
      }
      if (frame < 0) continue;
      if (goes_on) {
        bonds_.push_back({.a = i - 1, .b = i, .weight = kWallsWeight, .sigma_rad = kStepSigma_rad});
      } else {
        bonds_.push_back({.a = keyframes_.size() + static_cast<std::size_t>(frame),
                          .b = i,
                          .sigma_rad = kStepSigma_rad});
      }
    }
  }

  void fill(double scale, BlockEquations<1>& equations) const {
    using One = Eigen::Matrix<double, 1, 1>;
    constexpr double kLoose_rad = rad_from_deg(90.0);  // Else all could turn together.
    equations.set_zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(off_rad_.size()); ++i) {
      equations.add_diagonal(i, One(1.0 / (kLoose_rad * kLoose_rad)));
    }
    for (std::size_t pair = 0; pair < bonds_.size(); ++pair) {
      const Bond& bond = bonds_[pair];
      const double residual_rad = off_rad(bond.b) - off_rad(bond.a) - bond.value_rad;
      const double w = bond.weight * geman_mcclure_weight(residual_rad, scale * bond.sigma_rad) /
                       (bond.sigma_rad * bond.sigma_rad);
      equations.add_diagonal(bond.a, One(w));
      equations.add_diagonal(bond.b, One(w));
      equations.add_pair(pair, One(-w));
      equations.add_to_b(bond.a, One(-w * bond.value_rad));
      equations.add_to_b(bond.b, One(w * bond.value_rad));
    }
  }

  std::vector<std::size_t> keyframes_;
  std::vector<Bond> bonds_;
  Eigen::VectorXd off_rad_;  ///< Of each keyframe, then of each frame.
};

/// A stretch of the track by the first and the last keyframe in it that turns name.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  double turn_rad = 0.0;
  double sigma_rad = 0.0;
  std::size_t num_named = 0;

  [[nodiscard]] bool has(std::size_t keyframe) const {
    return first <= keyframe && keyframe <= last;
  }
};

/// Neighbours that are off alike, all of them. Those are off by nothing that show most of the main
/// frame's walls: the map's axes are theirs.
std::vector<Stretch> alike_stretches(const Corrections& corrections,
                                     const FusedHeadings& headings,
                                     double alike_rad) {
  std::vector<Stretch> stretches;
  const std::vector<std::size_t>& keyframes = corrections.keyframes();
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const double off_rad = corrections.off_rad(i);
    if (stretches.empty() || std::abs(off_rad - stretches.back().turn_rad) > alike_rad) {
      stretches.push_back({.first = keyframes[i], .last = keyframes[i], .turn_rad = off_rad});
    }
    Stretch& stretch = stretches.back();
    stretch.last = keyframes[i];
    ++stretch.num_named;
    stretch.turn_rad += (off_rad - stretch.turn_rad) / static_cast<double>(stretch.num_named);
  }
  const auto num_of_main = [&](const Stretch& stretch) {
    const auto first = headings.frame.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    const auto end = headings.frame.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1;
    return std::count(first, end, 0);
  };
  const double common_rad = std::ranges::max_element(stretches, {}, num_of_main)->turn_rad;
  for (Stretch& stretch : stretches) stretch.turn_rad -= common_rad;
  return stretches;
}

double turn_at(const std::vector<Stretch>& stretches, std::size_t keyframe) {
  double turn_rad = 0.0;
  for (const Stretch& stretch : stretches) {
    if (stretch.has(keyframe)) turn_rad += stretch.turn_rad;
  }
  return turn_rad;
}

/// Step 3 of outvoted_walls: the stretch turned by what was seen, in the mean, all others being
/// turned; nothing where not enough of it asks for that.
std::optional<Stretch> asked_for(Stretch stretch,
                                 const std::vector<Stretch>& stretches,
                                 const std::vector<Miss>& misses,
                                 std::span<const double> ways_m,
                                 const OutvotedWallsParams& params) {
  std::vector<Miss> asking;
  std::vector<Miss> against;
  double information = 0.0;
  double turn_rad = 0.0;
  for (const Miss& miss : misses) {
    if (stretch.has(miss.from) == stretch.has(miss.to)) continue;
    const double others_rad = turn_at(stretches, miss.to) - turn_at(stretches, miss.from);
    const double sign = stretch.has(miss.to) ? 1.0 : -1.0;
    const double left_rad = sign * (miss.off_rad - others_rad);  // Turned as well ...
    const double asked_rad = left_rad + stretch.turn_rad;        // ... and not turned.
    const bool contradicts_turn = contradicts(left_rad, miss, params);
    const bool contradicts_none = contradicts(asked_rad, miss, params);
    if (contradicts_none && !contradicts_turn) {
      asking.push_back(miss);
      const double w = miss.weight / (miss.sigma_rad * miss.sigma_rad);
      information += w;
      turn_rad += w * asked_rad;
    } else if (contradicts_turn && !contradicts_none) {
      against.push_back(miss);
    }
  }
  const std::size_t num_asking = num_places(asking, ways_m, params.same_place_m);
  const std::size_t num_against = num_places(against, ways_m, params.same_place_m);
  if (num_asking < params.min_places ||
      static_cast<double>(num_asking) < params.min_majority * static_cast<double>(num_against)) {
    return std::nullopt;
  }
  stretch.turn_rad = turn_rad / information;
  stretch.sigma_rad = std::max(params.min_sigma_rad, 1.0 / std::sqrt(information));
  return stretch;
}

/// The keyframe in (after, to] to which the tracked rotation most likely is another one by
/// `turn_rad`: where other walls begin, if any do.
std::size_t likeliest_cut(const FusedHeadings& headings,
                          std::span<const HeadingEvidence> evidence,
                          std::size_t after,
                          std::size_t to,
                          double turn_rad) {
  constexpr double kWallsCost = 1e6;  // Far above any other.
  std::size_t likeliest = to;
  double least = std::numeric_limits<double>::infinity();
  int frame = headings.frame[after];  // Seen last.
  for (std::size_t k = after + 1; k <= to; ++k) {
    const double step_rad = headings.drift_rad[k] - headings.drift_rad[k - 1];
    const double sigma_rad = std::hypot(evidence[k].step_sigma_rad, rad_from_deg(0.05));
    double cost = (std::abs(step_rad + turn_rad) - std::abs(step_rad)) / sigma_rad;
    if (headings.frame[k] < 0 || headings.frame[k] == frame) cost += kWallsCost;
    if (headings.frame[k] >= 0) frame = headings.frame[k];
    if (cost >= least) continue;
    least = cost;
    likeliest = k;
  }
  return likeliest;
}

}  // namespace

void OutvotedWallsParams::validate() const {
  require_positive(min_turn_rad, "outvoted.min_turn_rad");
  require_positive(max_turn_rad, "outvoted.max_turn_rad");
  require_positive(max_sigmas, "outvoted.max_sigmas");
  require_positive(seen_sigma_rad, "outvoted.seen_sigma_rad");
  require_positive(min_sigma_rad, "outvoted.min_sigma_rad");
  require_positive(same_place_m, "outvoted.same_place_m");
  require_at_least_one(min_places, "outvoted.min_places");
  require_positive(min_majority, "outvoted.min_majority");
}

SeenTurn seen_turn(std::size_t from,
                   std::size_t to,
                   const Pose2& T_from_to,
                   const Eigen::Matrix3d& information) {
  constexpr double kUnknown_rad = rad_from_deg(30.0);
  constexpr double kLoose = 1e-6;  // Of a direction that is open, in 1/m^2.
  const Eigen::Vector2d coupled = information.topRightCorner<2, 1>();
  const Eigen::Matrix2d bound =
      information.topLeftCorner<2, 2>() + kLoose * Eigen::Matrix2d::Identity();
  const double left = information(2, 2) - coupled.dot(bound.inverse() * coupled);
  const double least = 1.0 / (kUnknown_rad * kUnknown_rad);
  return {from, to, T_from_to.theta_rad, 1.0 / std::sqrt(std::max(left, least))};
}

std::vector<SeenTurn> seen_turns(const LoopCloser& closer, const AuditFindings* findings) {
  std::vector<SeenTurn> seen;
  for (const ComparedPlaces& places : closer.compared()) {
    if (!is_accepted(places.verdict.reason)) continue;
    seen.push_back(seen_turn(places.from, places.to, places.T_from_to, places.information));
  }
  if (!findings) return seen;
  const std::vector<std::size_t>& keyframes = findings->track.keyframes;
  for (const AuditMatch& match : findings->matches) {
    const auto [from, to] = match.pair;
    seen.push_back(seen_turn(keyframes[from], keyframes[to], match.T_from_to, match.information));
  }
  return seen;
}

std::size_t num_places_against(const FusedHeadings& headings,
                               std::span<const double> ways_m,
                               std::span<const SeenTurn> seen,
                               const OutvotedWallsParams& params) {
  return num_places(
      contradicting(misses_of(headings, seen, params), params), ways_m, params.same_place_m);
}

std::vector<TurnedWalls> outvoted_walls(const FusedHeadings& headings,
                                        std::span<const HeadingEvidence> evidence,
                                        std::span<const double> ways_m,
                                        std::span<const SeenTurn> seen,
                                        const OutvotedWallsParams& params) {
  std::vector<Miss> misses = misses_of(headings, seen, params);
  if (num_places(contradicting(misses, params), ways_m, params.same_place_m) < params.min_places) {
    return {};
  }
  share_places(ways_m, params, misses);
  Corrections corrections(headings, evidence, misses);
  corrections.solve();
  const std::vector<Stretch> all =
      alike_stretches(corrections, headings, 0.5 * params.min_turn_rad);
  std::vector<Stretch> asked;
  std::ranges::copy_if(all, std::back_inserter(asked), [&](const Stretch& stretch) {
    return std::abs(stretch.turn_rad) > params.min_turn_rad;
  });
  for (std::size_t num = asked.size() + 1; num > asked.size();) {
    num = asked.size();
    std::erase_if(asked, [&](const Stretch& stretch) {
      return !asked_for(stretch, asked, misses, ways_m, params);
    });
  }
  std::vector<TurnedWalls> turned;
  for (const Stretch& untold : asked) {
    const Stretch stretch = *asked_for(untold, asked, misses, ways_m, params);
    const auto before = std::ranges::find_if(
        all.rbegin(), all.rend(), [&](const Stretch& other) { return other.last < stretch.first; });
    const auto behind =
        std::ranges::find_if(all, [&](const Stretch& other) { return other.first > stretch.last; });
    TurnedWalls walls{.first = 0,
                      .end = evidence.size(),
                      .turn_rad = stretch.turn_rad,
                      .sigma_rad = stretch.sigma_rad};
    if (before != all.rend()) {
      walls.first = likeliest_cut(headings, evidence, before->last, stretch.first, walls.turn_rad);
    }
    if (behind != all.end()) {
      walls.end = likeliest_cut(headings, evidence, stretch.last, behind->first, -walls.turn_rad);
    }
    turned.push_back(walls);
  }
  return turned;
}

}  // namespace setsquare
