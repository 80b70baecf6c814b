// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

/// Dijkstra's algorithm from one station after the other, as far as windows reach.
class ClosureCandidates::ShortestWays {
 public:
  ShortestWays(const std::vector<std::vector<Link>>& links, double max_way_m)
      : links_(links), max_way_m_(max_way_m), way_m_(links.size(), kFar) {}

  /// Ways back from `station` over it and those before it.
  void start_from(std::size_t station) {
    for (const std::size_t reached : reached_) way_m_[reached] = kFar;
    reached_.clear();
    reach(station, 0.0);
    while (!queue_.empty()) {
      const auto [way_m, from] = queue_.top();
      queue_.pop();
      if (way_m > way_m_[from]) continue;
      for (const Link& link : links_[from]) {
        if (link.station > station) continue;
        const double next_m = way_m + link.way_m;
        if (next_m < way_m_[link.station] && next_m <= max_way_m_) reach(link.station, next_m);
      }
    }
  }

  [[nodiscard]] double way_m(std::size_t station) const { return way_m_[station]; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  using Reached = std::pair<double, std::size_t>;

  void reach(std::size_t station, double way_m) {
    if (way_m_[station] == kFar) reached_.push_back(station);
    way_m_[station] = way_m;
    queue_.push({way_m, station});
  }

  const std::vector<std::vector<Link>>& links_;
  double max_way_m_;
  std::vector<double> way_m_;
  std::vector<std::size_t> reached_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

void ClosureCandidateParams::validate() const {
  require_positive(radius_m, "candidates.radius_m");
  require_not_negative(min_way_m, "candidates.min_way_m");
  require_at_least_one(max_num, "candidates.max_num");
  require_at_least_one(min_separation, "candidates.min_separation");
  require_positive(window_m, "candidates.window_m");
  require_positive(window_per_metre, "candidates.window_per_metre");
  require_finite(max_window_m, "candidates.max_window_m");
  if (!(max_window_m >= window_m)) {
    throw ParameterError("candidates.max_window_m", "must not be below window_m");
  }
  require_not_negative(slip_way, "candidates.slip_way");
  require_not_negative(max_sigmas_open, "candidates.max_sigmas_open");
  require_positive(closure_way_m, "candidates.closure_way_m");
}

void ClosureCandidates::add_station(double way_m, std::size_t piece, double open_m2) {
  const std::size_t station = links_.size();
  const bool is_new_piece = !pieces_.empty() && piece != pieces_.back();
  pieces_.push_back(piece);
  while (joined_pieces_.size() <= piece) joined_pieces_.push_back(joined_pieces_.size());
  links_.emplace_back();
  open_m2_.push_back(open_m2);
  way_from_start_m_.push_back(station == 0 ? 0.0 : way_from_start_m_.back() + way_m);
  if (station == 0 || is_new_piece) return;
  links_[station].push_back({station - 1, way_m});
  links_[station - 1].push_back({station, way_m});
}

void ClosureCandidates::link(std::size_t a, std::size_t b) {
  links_[a].push_back({b, params_.closure_way_m});
  links_[b].push_back({a, params_.closure_way_m});
  const auto [low, high] = std::minmax(joined_pieces_[pieces_[a]], joined_pieces_[pieces_[b]]);
  std::replace(joined_pieces_.begin(), joined_pieces_.end(), std::size_t{high}, std::size_t{low});
}

std::vector<ClosureCandidate> ClosureCandidates::find(
    std::size_t first, std::span<const Eigen::Vector2d> positions_m) const {
  const double max_way_m = (params_.max_window_m - params_.window_m) / params_.window_per_metre;
  ShortestWays ways(links_, max_way_m);
  PositionHash hash(params_.radius_m);
  for (std::size_t i = 0; i < first; ++i) hash.add(positions_m[i], i);

  std::vector<ClosureCandidate> found;
  std::vector<std::pair<double, ClosureCandidate>> near;
  for (std::size_t current = first; current < links_.size(); ++current) {
    ways.start_from(current);
    near.clear();
    const auto consider = [&](std::size_t reference) {
      if (way_from_start_m_[current] - way_from_start_m_[reference] < params_.min_way_m) return;
      if (joined_pieces_[pieces_[current]] != joined_pieces_[pieces_[reference]]) return;
      const double wanted_m = params_.window_m + params_.window_per_metre * ways.way_m(reference);
      const double open_m =
          params_.max_sigmas_open * std::sqrt(open_m2_[current] - open_m2_[reference]);
      if (wanted_m > params_.max_window_m && open_m > params_.max_window_m) return;
      const double window_m = std::min(params_.max_window_m, wanted_m);
      const double distance_m = (positions_m[current] - positions_m[reference]).norm();
      if (distance_m > params_.radius_m + window_m) return;
      near.push_back({distance_m + window_m, {reference, current, window_m}});
    };
    hash.visit(positions_m[current], params_.radius_m + params_.max_window_m, consider);
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first, a.second.reference) < std::pair(b.first, b.second.reference);
    });
    const std::size_t first_found = found.size();
    for (const auto& costed : near) {
      const ClosureCandidate& candidate = costed.second;
      if (found.size() - first_found == params_.max_num) break;
      const bool is_beside_another =
          std::any_of(found.begin() + static_cast<std::ptrdiff_t>(first_found),
                      found.end(),
                      [&](const ClosureCandidate& other) {
                        const auto [low, high] = std::minmax(other.reference, candidate.reference);
                        return high - low < params_.min_separation;
                      });
      if (!is_beside_another) found.push_back(candidate);
    }
    hash.add(positions_m[current], current);
  }
  return found;
}

}  // namespace setsquare
