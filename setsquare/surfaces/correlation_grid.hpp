// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/surfaces/surface_image.hpp"
#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// A translation at a given rotation, with its correlation.
struct TranslationProposal {
  Pose2 T_reference_current;
  int correlation = 0;  ///< Sum of the cell values under the current scan's samples.
};

/// The reference scan as a small grid of bytes: surfaces positive, free space negative, unknown
/// zero. One rotation of the current scan is correlated with it under every translation of the
/// window at once: a sample adds a shifted row, many translations per instruction. It replaces
/// the paper's two 1-D correlations, whose best peaks need not belong together, at the same cost.
class CorrelationGrid {
 public:
  static constexpr double kCell_m = 0.2;
  static constexpr int kHalfWindowCells = 31;  ///< Translations within 6.2 m along each axis.
  static constexpr int kHalfExtentCells = 64;  ///< Surfaces up to 12.8 m from the sensor.
  static constexpr int kMaxSamples = 60;       ///< Keeps the sums within a byte; more are refused.

  static constexpr int kMargin = kHalfWindowCells + 1;
  static constexpr int kWindow = 2 * kMargin;  ///< Translations along an axis; whole vectors.
  static constexpr int kSide = 2 * (kHalfExtentCells + 2 * kMargin);

  CorrelationGrid(const SurfacePoints& points, const SurfaceImage& image);

  /// Appends the local maxima that reach `min_correlation` over the window about the translation
  /// of `middle`, at its rotation.
  void propose_translations(const SurfaceSamples& current,
                            const Pose2& middle,
                            int min_correlation,
                            std::vector<TranslationProposal>& proposals) const;

 private:
  static constexpr int kCentre = kSide / 2;

  /// The cell under each sample at the window's first translation.
  struct Rows {
    std::array<const std::uint8_t*, kMaxSamples> first;
    std::size_t count = 0;
  };

  [[nodiscard]] Rows rows_of(const SurfaceSamples& current, const Pose2& middle) const;
  void draw_free_space(const SurfaceImage& image);
  void draw_surfaces(const SurfacePoints& points);

  std::vector<std::uint8_t> cells_;
};

}  // namespace setsquare
