// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/localisation/wall_distance.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// A place that the correlation proposes.
struct MapProposal {
  Pose2 T_grid_sensor;  ///< The sensor in the middle of a cell.
  int correlation = 0;  ///< Sum of the cell values under the scan's samples.
};

/// A whole map as a grid of bytes: walls positive, free space negative, unknown zero, as
/// CorrelationGrid is of one scan. One rotation of a scan is correlated with it under every
/// translation that puts the sensor into free space, or a little beyond where nothing was seen: a
/// sample adds a shifted row, many translations per instruction.
class MapCorrelation {
 public:
  static constexpr double kCell_m = 0.2;  ///< As near to it as the grid's cells allow.
  static constexpr int kMaxSamples = 60;  ///< Keeps the sums within a byte.
  /// The sensor may stand as far as this beyond free space, where no wall is between: a robot looks
  /// back into the map from where it ends.
  static constexpr double kBeyondFree_m = 1.0;
  static constexpr double kMaxReach_m = 30.0;    ///< Samples farther from the sensor have no part.
  static constexpr std::size_t kTileWidth = 64;  ///< Translations that are summed at once.

  /// Of a map's cells.
  explicit MapCorrelation(const WallDistance& walls);

  /// Side of its cells.
  [[nodiscard]] double cell_m() const { return cell_m_; }

  /// The sums of one rotation, reused between calls. One for each thread.
  struct Scratch {
    std::vector<std::uint8_t> sums;  ///< One per cell.
  };

  /// Appends the local maxima, over all translations, that reach `min_correlation`. Throws
  /// std::invalid_argument where there are more than kMaxSamples samples.
  void propose(const SurfaceSamples& samples,
               double rotation_rad,
               int min_correlation,
               Scratch& scratch,
               std::vector<MapProposal>& proposals) const;

 private:
  /// Neighbouring cells of one row in which the sensor may be.
  struct Tile {
    std::int32_t column;
    std::int32_t row;
  };

  /// Lets the sensor stand kBeyondFree_m beyond free space.
  void widen_free_space();

  [[nodiscard]] std::size_t cell_index(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row + margin_) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(column + margin_);
  }

  double cell_m_;
  std::int32_t num_columns_;  ///< Without the margin.
  std::int32_t num_rows_;
  std::int32_t margin_;
  std::int32_t stride_;
  std::vector<std::uint8_t> cells_;
  std::vector<std::uint8_t> is_free_;  ///< Not 0 where the sensor may be, with the same margin.
  std::vector<Tile> tiles_;
};

}  // namespace setsquare
