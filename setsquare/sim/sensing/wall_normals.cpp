// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/wall_normals.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kLongestFacet_m = 1.5;
constexpr double kLargestTurn_rad = rad_from_deg(25.0);

/// An end of a short segment, by its place in micrometres: ends at one place sort together.
struct SegmentEnd {
  std::int64_t x_um;
  std::int64_t y_um;
  std::uint32_t segment;
  bool is_end;

  [[nodiscard]] bool is_at(const SegmentEnd& other) const {
    return x_um == other.x_um && y_um == other.y_um;
  }
  auto operator<=>(const SegmentEnd&) const = default;
};

SegmentEnd end_at(const Eigen::Vector2d& p_m, std::size_t segment, bool is_end) {
  return {std::llround(p_m.x() * 1e6),
          std::llround(p_m.y() * 1e6),
          static_cast<std::uint32_t>(segment),
          is_end};
}

std::vector<SegmentEnd> ends_of_short_segments(const FloorPlan& plan) {
  std::vector<SegmentEnd> ends;
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const PlanSegment& segment = plan.segments[i];
    const double length_m = (segment.end_m - segment.start_m).norm();
    if (length_m <= 0.0 || length_m > kLongestFacet_m) continue;
    ends.push_back(end_at(segment.start_m, i, false));
    ends.push_back(end_at(segment.end_m, i, true));
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

}  // namespace

WallNormals::WallNormals(const FloorPlan& plan) : facets_(plan.segments.size()) {
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const PlanSegment& segment = plan.segments[i];
    facets_[i].start_m = segment.start_m;
    facets_[i].length_m = (segment.end_m - segment.start_m).norm();
    if (facets_[i].length_m > 0.0) {
      facets_[i].along = (segment.end_m - segment.start_m) / facets_[i].length_m;
    }
  }
  const std::vector<SegmentEnd> ends = ends_of_short_segments(plan);
  for (std::size_t first = 0, next = 0; first < ends.size(); first = next) {
    while (next < ends.size() && ends[next].is_at(ends[first])) ++next;
    if (next - first != 2) continue;  // Loose, or more than one wall goes on from here.
    const SegmentEnd& a = ends[first];
    const SegmentEnd& b = ends[first + 1];
    // Directions of a walk along a to the corner and away from it along b.
    const Eigen::Vector2d in = (a.is_end ? 1.0 : -1.0) * facets_[a.segment].along;
    const Eigen::Vector2d out = (b.is_end ? -1.0 : 1.0) * facets_[b.segment].along;
    const double turn_rad = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    if (std::abs(turn_rad) > kLargestTurn_rad) continue;
    // A walk backwards along a segment has its turns with the opposite sign.
    (a.is_end ? facets_[a.segment].turn_at_end_rad : facets_[a.segment].turn_at_start_rad) =
        a.is_end ? turn_rad : -turn_rad;
    (b.is_end ? facets_[b.segment].turn_at_end_rad : facets_[b.segment].turn_at_start_rad) =
        b.is_end ? -turn_rad : turn_rad;
  }
}

Eigen::Vector2d WallNormals::normal_at(std::uint32_t segment, const Eigen::Vector2d& p_m) const {
  const Facet& facet = facets_[segment];
  const Eigen::Vector2d& along = facet.along;
  if (facet.turn_at_start_rad == 0.0 && facet.turn_at_end_rad == 0.0) {
    return {-along.y(), along.x()};
  }
  // -1 at the start, 0 in the middle, 1 at the end.
  const double place =
      std::clamp(2.0 * along.dot(p_m - facet.start_m) / facet.length_m - 1.0, -1.0, 1.0);
  const double turn_rad = place < 0.0 ? facet.turn_at_start_rad : facet.turn_at_end_rad;
  const double tilt_rad = 0.5 * place * turn_rad;
  const double c = std::cos(tilt_rad);
  const double s = std::sin(tilt_rad);
  return {-(s * along.x() + c * along.y()), c * along.x() - s * along.y()};
}

}  // namespace setsquare
