// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from loop_closer, which shows its parameters: where to look, tested without scans.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {
/// Things by their position, in square cells: finds those around a place without looking at the
/// others.
class PositionHash {
 public:
  explicit PositionHash(double cell_m) : cell_m_(cell_m) {}

  void add(const Eigen::Vector2d& position_m, std::size_t index) {
    cells_[key(cell_of(position_m.x()), cell_of(position_m.y()))].push_back(index);
  }

  /// Calls visit(index) for all in the cells that the square of this half side touches, cell by
  /// cell in a fixed order.
  template <typename Visit>
  void visit(const Eigen::Vector2d& centre_m, double half_side_m, Visit visit) const {
    const std::int32_t last_column = cell_of(centre_m.x() + half_side_m);
    const std::int32_t last_row = cell_of(centre_m.y() + half_side_m);
    for (std::int32_t row = cell_of(centre_m.y() - half_side_m); row <= last_row; ++row) {
      for (std::int32_t c = cell_of(centre_m.x() - half_side_m); c <= last_column; ++c) {
        const auto cell = cells_.find(key(c, row));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) visit(index);
      }
    }
  }

 private:
  [[nodiscard]] std::int32_t cell_of(double coordinate_m) const {
    return static_cast<std::int32_t>(std::floor(coordinate_m / cell_m_));
  }
  [[nodiscard]] static std::uint64_t key(std::int32_t column, std::int32_t row) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 |
           static_cast<std::uint32_t>(row);
  }

  double cell_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/// A pair of places that may be the same.
struct ClosureCandidate {
  std::size_t reference = 0;  ///< Station.
  std::size_t current = 0;    ///< Station, later than the reference.
  double window_m = 0.0;      ///< How far off the expected position may be, along each axis.
};

/// Proposes where loops may close, by position and by how uncertain it is: the window about an
/// expected position grows with the way back to there, along the track and over the closures that
/// were accepted. Behind open stretches the place may lie beyond any window, and what is found in
/// it may be its twin: such stations are not compared until closures_anywhere has tied them. The
/// cost of a station depends on its surroundings, not on the size of the map.
class ClosureCandidates {
 public:
  explicit ClosureCandidates(const ClosureCandidateParams& params) : params_(params) {}

  /// The next station along the track; `way_m` from the one before: its length and slip_way times
  /// its possible slip. `piece`: of the track; stations of different pieces are compared
  /// once a link joins these. `open_m2`: variance that open stretches add to its position, from the
  /// first station on.
  void add_station(double way_m, std::size_t piece = 0, double open_m2 = 0.0);

  /// A closure that binds both axes was accepted between two stations.
  void link(std::size_t a, std::size_t b);

  /// Candidates for each of the stations [first, end), nearest first. `positions_m`: of all
  /// stations, in the map frame.
  [[nodiscard]] std::vector<ClosureCandidate> find(
      std::size_t first, std::span<const Eigen::Vector2d> positions_m) const;

 private:
  struct Link {
    std::size_t station;
    double way_m;
  };
  class ShortestWays;

  ClosureCandidateParams params_;
  std::vector<std::vector<Link>> links_;
  std::vector<double> way_from_start_m_;
  std::vector<double> open_m2_;             ///< Of each station.
  std::vector<std::size_t> pieces_;         ///< Of each station.
  std::vector<std::size_t> joined_pieces_;  ///< Of each piece: the lowest one joined to it.
};

}  // namespace setsquare
