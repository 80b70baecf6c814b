// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/scaling/block_building.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "benchmarks/scaling/block_layout.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/furnishing.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/visits.hpp"
#include "setsquare/sim/building/wing.hpp"

namespace setsquare {
namespace {

using Eigen::Vector2d;

struct VisitOnTheWay {
  double in_x_m = 0.0;
  double out_x_m = 0.0;
  std::vector<Vector2d> corners_m;
};

/// A way through the corridors.
class BlockWalk {
 public:
  BlockWalk(const BlockLayout& layout, Random& random) : layout_(layout), random_(random) {
    route_m_.push_back(layout.position(here_));
  }

  void go_on() {
    const Crossing next = next_crossing();
    append_visits(next);
    ++num_driven_[edge_between(here_, next)];
    last_ = here_;
    here_ = next;
    route_m_.push_back(layout_.position(here_));
  }
  [[nodiscard]] const std::vector<Vector2d>& route_m() const { return route_m_; }

 private:
  [[nodiscard]] std::vector<Crossing> neighbours() const {
    std::vector<Crossing> crossings;
    if (here_.column > 0) crossings.push_back({here_.column - 1, here_.row});
    if (here_.row > 0) crossings.push_back({here_.column, here_.row - 1});
    if (here_.column + 1 < layout_.x_m.size()) crossings.push_back({here_.column + 1, here_.row});
    if (here_.row + 1 < layout_.y_m.size()) crossings.push_back({here_.column, here_.row + 1});
    return crossings;
  }

  /// Along the corridor that was driven least; chance decides between equals. Not straight back.
  [[nodiscard]] Crossing next_crossing() {
    std::optional<Crossing> best;
    double least = 0.0;
    for (const Crossing& crossing : neighbours()) {
      if (last_ && crossing == *last_) continue;
      const double cost = num_driven_[edge_between(here_, crossing)] + 0.5 * random_.uniform();
      if (best && cost >= least) continue;
      best = crossing;
      least = cost;
    }
    return *best;
  }

  void append_visits(const Crossing& next) {
    const auto rooms = layout_.rooms.find(edge_between(here_, next));
    if (rooms == layout_.rooms.end()) return;
    std::vector<VisitOnTheWay> visits;
    for (const Room& room : rooms->second) {
      constexpr double kVisitShare = 0.35;
      if (!random_.chance(kVisitShare)) continue;
      if (auto visit = visit_on_the_way(room, next)) visits.push_back(std::move(*visit));
    }
    std::sort(visits.begin(), visits.end(), [](const VisitOnTheWay& a, const VisitOnTheWay& b) {
      return a.in_x_m < b.in_x_m;
    });
    double done_x_m = 0.0;
    for (const VisitOnTheWay& visit : visits) {
      if (visit.in_x_m < done_x_m + 0.3) continue;
      route_m_.insert(route_m_.end(), visit.corners_m.begin(), visit.corners_m.end());
      done_x_m = visit.out_x_m;
    }
  }

  [[nodiscard]] std::optional<VisitOnTheWay> visit_on_the_way(const Room& room,
                                                              const Crossing& next) {
    constexpr double kToEnd_m = 0.8;
    const Vector2d start = layout_.position(here_);
    const Vector2d way = layout_.position(next) - start;
    const Pose2 T_way_map = Pose2{start.x(), start.y(), std::atan2(way.y(), way.x())}.inverse();
    const double door_y_m = (T_way_map * room.doorways.front().T_map_wall).y_m;
    auto planned = plan_visit(room, std::abs(door_y_m), random_);
    if (!planned) return std::nullopt;
    VisitOnTheWay visit{(T_way_map * planned->corners_m.front()).x(),
                        (T_way_map * planned->corners_m.back()).x(),
                        std::move(planned->corners_m)};
    if (visit.out_x_m < visit.in_x_m) {
      std::swap(visit.in_x_m, visit.out_x_m);
      std::reverse(visit.corners_m.begin(), visit.corners_m.end());
    }
    if (visit.in_x_m < kToEnd_m || visit.out_x_m > way.norm() - kToEnd_m) return std::nullopt;
    return visit;
  }

  const BlockLayout& layout_;
  Random& random_;
  Crossing here_;
  std::optional<Crossing> last_;
  std::map<CorridorEdge, int> num_driven_;
  std::vector<Vector2d> route_m_;
};

void furnish_blocks(BuildingSketch& sketch, const BlockLayout& layout, Random& random) {
  for (const auto& [edge, rooms] : layout.rooms) {
    for (const Room& room : rooms) {
      furnish(sketch, room);
      if (random.chance(0.3)) add_people(sketch, room.outline, 1, 0.4, random);
    }
  }
  for (const ConvexPolygon& corridor : layout.corridors) {
    const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
    furnish(sketch, {corridor, RoomUse::kCorridor, seed, {}});
    add_people(sketch, corridor, random.integer(0, 2), 0.6, random);
  }
}

}  // namespace

Building make_block_building(const BlockBuildingSize& size, std::uint64_t seed) {
  Random random(sub_seed(seed, 77));
  BuildingSketch sketch;
  const BlockLayout layout = add_blocks(sketch, size.num_columns, size.num_rows, random);
  BlockWalk walk(layout, random);
  while (length_of(walk.route_m()) < size.route_m) walk.go_on();
  sketch.route_m = walk.route_m();
  hang_leaves(sketch, random);
  furnish_blocks(sketch, layout, random);
  return finish(sketch, random.uniform(-kPi, kPi));
}

}  // namespace setsquare
