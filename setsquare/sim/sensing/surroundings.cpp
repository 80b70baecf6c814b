// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/surroundings.hpp"

#include <cmath>
#include <cstddef>

namespace setsquare {

Surroundings::Surroundings(const RayCaster& caster,
                           const std::vector<Disc>& discs,
                           const Eigen::Vector2d& center_m,
                           double reach_m)
    : caster_(caster) {
  for (const Disc& disc : discs) {
    if ((disc.center_m - center_m).norm() - disc.radius_m <= reach_m) discs_.push_back(disc);
  }
}

Sighting Surroundings::look_at_plan(const Ray& ray,
                                    double max_range_m,
                                    bool returns_from_glass) const {
  double from_m = 0.0;
  while (const auto hit = caster_.cast(ray.origin_m, ray.direction, max_range_m, from_m)) {
    const Material material = caster_.plan().segments[hit->segment].material;
    const bool is_seen = material != Material::kGlass ||
                         (returns_from_glass && hit->incidence_cos >= kGlassIncidenceCos);
    if (is_seen) return {hit->range_m, hit->segment, hit->incidence_cos, is_clutter(material)};
    from_m = hit->range_m;
  }
  return {};
}

Sighting Surroundings::look(const Ray& ray, double max_range_m, bool returns_from_glass) const {
  Sighting nearest = look_at_plan(ray, max_range_m, returns_from_glass);
  const auto num_segments = static_cast<std::int64_t>(caster_.plan().segments.size());
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const Eigen::Vector2d to_center = discs_[i].center_m - ray.origin_m;
    const double ahead_m = to_center.dot(ray.direction);
    const double aside_m = ray.direction.x() * to_center.y() - ray.direction.y() * to_center.x();
    const double radius_m = discs_[i].radius_m;
    if (ahead_m <= 0.0 || std::abs(aside_m) >= radius_m) continue;
    const double half_chord_m = std::sqrt((radius_m - aside_m) * (radius_m + aside_m));
    const double range_m = ahead_m - half_chord_m;
    if (range_m <= 0.0 || range_m > max_range_m || range_m >= nearest.range_m) continue;
    nearest = {range_m, num_segments + static_cast<std::int64_t>(i), half_chord_m / radius_m, true};
  }
  return nearest;
}

}  // namespace setsquare
