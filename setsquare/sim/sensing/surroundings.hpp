// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "setsquare/sim/sensing/person.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"

namespace setsquare {

/// What an infinitely thin beam meets.
struct Sighting {
  double range_m = std::numeric_limits<double>::infinity();  ///< Infinite: nothing within reach.
  std::int64_t thing = -1;     ///< Equal for the same segment or the same disc; -1: nothing.
  double incidence_cos = 1.0;  ///< Cosine of the angle to the surface's normal, in [0, 1].
  bool is_clutter = false;     ///< Furniture, clutter, people.

  [[nodiscard]] bool is_anything() const { return thing >= 0; }
};

/// Cosine of the steepest incidence at which glass sends the beam back: about 14 deg.
inline constexpr double kGlassIncidenceCos = 0.97;

/// The floor plan and the round things that stand in it at one time, within reach of a scanner.
class Surroundings {
 public:
  /// Keeps the discs that lie within `reach_m` of `center_m`, and a reference to the caster.
  Surroundings(const RayCaster& caster,
               const std::vector<Disc>& discs,
               const Eigen::Vector2d& center_m,
               double reach_m);

  /// The nearest thing up to `max_range_m`. Glass is seen through, pane after pane, except nearly
  /// at right angles and where `returns_from_glass`.
  [[nodiscard]] Sighting look(const Ray& ray, double max_range_m, bool returns_from_glass) const;

 private:
  [[nodiscard]] Sighting look_at_plan(const Ray& ray,
                                      double max_range_m,
                                      bool returns_from_glass) const;

  const RayCaster& caster_;
  std::vector<Disc> discs_;
};

}  // namespace setsquare
