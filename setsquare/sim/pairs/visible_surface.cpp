// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/pairs/visible_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "setsquare/sim/sensing/surroundings.hpp"

namespace setsquare {
namespace {

constexpr double kLongestShare_m = 0.25;  // Of a wall, for one beam.
constexpr double kLeastIncidenceCos = 0.1;
constexpr double kTouching_m = 1e-6;

/// What one beam sees; nothing: no segment within reach.
struct SeenPoint {
  Eigen::Vector2d p_m;
  std::optional<std::uint32_t> segment;
};

std::optional<Eigen::Vector2d> shared_corner(const PlanSegment& a, const PlanSegment& b) {
  for (const Eigen::Vector2d& corner_m : {a.start_m, a.end_m}) {
    for (const Eigen::Vector2d& other_m : {b.start_m, b.end_m}) {
      if ((corner_m - other_m).cwiseAbs().maxCoeff() <= kTouching_m) return corner_m;
    }
  }
  return std::nullopt;
}

/// Joins the points that consecutive beams see to pieces of wall.
class PieceChain {
 public:
  PieceChain(const FloorPlan& plan,
             const Eigen::Vector2d& origin_m,
             std::vector<SurfacePiece>& pieces)
      : plan_(plan), origin_m_(origin_m), pieces_(pieces) {}

  void add(const SeenPoint& seen) {
    if (seen.segment) {
      if (last_.segment == seen.segment) {
        pieces_.back().end_m = seen.p_m;
      } else {
        start_piece(seen);
      }
    }
    last_ = seen;
  }

 private:
  void start_piece(const SeenPoint& seen) {
    std::optional<Eigen::Vector2d> corner_m;
    if (last_.segment) {
      corner_m = shared_corner(plan_.segments[*last_.segment], plan_.segments[*seen.segment]);
    }
    if (corner_m && !is_between(*corner_m, last_.p_m, seen.p_m)) corner_m.reset();
    if (corner_m) pieces_.back().end_m = *corner_m;
    pieces_.push_back({corner_m.value_or(seen.p_m), seen.p_m});
  }

  /// Whether the beams to two points, less than half a turn apart, have a corner between them.
  bool is_between(const Eigen::Vector2d& corner_m,
                  const Eigen::Vector2d& first_m,
                  const Eigen::Vector2d& second_m) const {
    const Eigen::Vector2d first = first_m - origin_m_;
    const Eigen::Vector2d second = second_m - origin_m_;
    const Eigen::Vector2d corner = corner_m - origin_m_;
    const double sense = cross(first, second) < 0.0 ? -1.0 : 1.0;
    const double slack = 1e-9 * corner.norm();
    return sense * cross(first, corner) >= -slack * first.norm() &&
           sense * cross(corner, second) >= -slack * second.norm();
  }

  const FloorPlan& plan_;
  Eigen::Vector2d origin_m_;
  std::vector<SurfacePiece>& pieces_;
  SeenPoint last_{Eigen::Vector2d::Zero(), std::nullopt};
};

bool is_all_around(const ScannerModel& scanner) {
  return std::abs(scanner.bearing_step_rad) * static_cast<double>(scanner.num_beams) >=
         kTwoPi - 1e-6;
}

}  // namespace

VisibleSurface visible_surface(const RayCaster& caster,
                               const ScannerModel& scanner,
                               const Pose2& T_map_sensor) {
  const Surroundings surroundings(caster, {}, T_map_sensor.translation(), 0.0);
  VisibleSurface surface;
  PieceChain chain(caster.plan(), T_map_sensor.translation(), surface.pieces);
  // A scanner that sees all around meets its first beam again after the last.
  const std::size_t num_steps = scanner.num_beams + (is_all_around(scanner) ? 1 : 0);
  for (std::size_t step = 0; step < num_steps; ++step) {
    const double angle_rad =
        T_map_sensor.theta_rad + scanner.first_bearing_rad +
        scanner.bearing_step_rad * static_cast<double>(step % scanner.num_beams);
    const Ray ray{T_map_sensor.translation(), {std::cos(angle_rad), std::sin(angle_rad)}};
    const Sighting sighting = surroundings.look(ray, scanner.max_range_m, false);
    if (!sighting.is_anything() || sighting.range_m < scanner.min_range_m) {
      chain.add({Eigen::Vector2d::Zero(), std::nullopt});
      continue;
    }
    const auto segment = static_cast<std::uint32_t>(sighting.thing);
    const Eigen::Vector2d p_m = ray.origin_m + sighting.range_m * ray.direction;
    chain.add({p_m, segment});
    if (step == scanner.num_beams) continue;
    const double length_m = sighting.range_m * std::abs(scanner.bearing_step_rad) /
                            std::max(sighting.incidence_cos, kLeastIncidenceCos);
    surface.returns.push_back(
        {p_m, caster.wall_normals().normal_at(segment, p_m), std::min(length_m, kLongestShare_m)});
  }
  return surface;
}

}  // namespace setsquare
