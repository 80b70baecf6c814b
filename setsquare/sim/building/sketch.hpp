// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {
/// Corners of a convex polygon, anticlockwise, in m. Two corners make a line.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// The rectangle between two corners that are given in its own frame; x0 < x1, y0 < y1.
[[nodiscard]] ConvexPolygon rectangle(
    const Pose2& T_map_frame, double x0_m, double y0_m, double x1_m, double y1_m);

/// A rectangle about its centre: `length_m` along the frame's x, `width_m` along its y.
[[nodiscard]] ConvexPolygon box(const Pose2& T_map_center, double length_m, double width_m);

/// An ellipse with its axes along the frame's, as a polygon of `num_corners`.
[[nodiscard]] ConvexPolygon ellipse(const Pose2& T_map_center,
                                    double radius_x_m,
                                    double radius_y_m,
                                    int num_corners);

/// Whether the point lies in the polygon, at least `margin_m` from its sides.
[[nodiscard]] bool contains(const ConvexPolygon& polygon,
                            const Eigen::Vector2d& point_m,
                            double margin_m = 0.0);

/// Whether all corners of `inner` lie in `outer`.
[[nodiscard]] bool contains(const ConvexPolygon& outer, const ConvexPolygon& inner);

/// Whether a line perpendicular to a side of either parts the two by `gap_m`. Never true for
/// polygons that are nearer than that; corner against corner it may miss a little of the distance.
[[nodiscard]] bool are_apart(const ConvexPolygon& a, const ConvexPolygon& b, double gap_m);

/// Shares in [0, 1] of the way from start to end between which the line lies inside the polygon;
/// first > second: nowhere. A line along a side is outside.
struct InsideInterval {
  double first = 1.0;
  double second = 0.0;
  [[nodiscard]] bool is_empty() const { return first >= second; }
};
[[nodiscard]] InsideInterval inside_interval(const ConvexPolygon& polygon,
                                             const Eigen::Vector2d& start_m,
                                             const Eigen::Vector2d& end_m);

/// A convex piece of free floor: a room, a corridor, the opening of a door, a niche.
struct Space {
  ConvexPolygon outline;
  /// What stands at each side where no other space goes on; empty: walls all around.
  std::vector<Material> sides;
};

/// An opening that one can drive through. The frame's origin is the middle of the opening on the
/// face of the wall, its x axis points into the wall.
struct Doorway {
  Pose2 T_map_wall;
  double width_m = 0.0;
  double thickness_m = 0.0;  ///< Of the wall.
  bool has_leaf = true;
};

/// A building while it is designed: first the spaces, then the route, then what stands in them.
struct BuildingSketch {
  std::vector<Space> spaces;
  std::vector<Doorway> doorways;
  std::vector<ConvexPolygon> kept_free;   ///< Floor before doors, where nothing is put.
  std::vector<ConvexPolygon> footprints;  ///< Floor that something stands on.
  std::vector<PlanSegment> fittings;      ///< What is seen of all that, at scanner height.
  std::vector<Person> people;
  std::vector<Eigen::Vector2d> route_m;
};

/// Where the spaces end: the boundary of their union. Walls have two faces because the spaces on
/// their two sides do not touch.
[[nodiscard]] std::vector<PlanSegment> wall_segments(const std::vector<Space>& spaces);

/// Whether a new space would be `gap_m` away from all others.
[[nodiscard]] bool is_unbuilt(const BuildingSketch& sketch,
                              const ConvexPolygon& outline,
                              double gap_m);

/// Adds a closed polygon to what is seen, without taking floor.
void add_outline(BuildingSketch& sketch, const ConvexPolygon& outline, Material material);

/// The finished building, turned about the origin.
[[nodiscard]] Building finish(const BuildingSketch& sketch, double rotation_rad);

}  // namespace setsquare
