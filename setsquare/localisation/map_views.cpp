// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/map_views.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/sort_by.hpp"
#include "setsquare/localisation/wall_step.hpp"
#include "setsquare/matching/wall_kinds.hpp"
#include "setsquare/surfaces/sample_comparison.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {
namespace {

constexpr double kReach_m = 8.0;       ///< Views from farther away tell little of a place.
constexpr std::size_t kMostNear = 80;  ///< Of them these are looked at: a bound on the time.
constexpr std::size_t kMostViews = 12;
constexpr std::size_t kMostAgreeing = 4;  ///< Whose walls are looked for in the scan.
constexpr float kTight_m = 0.04F;
constexpr float kLoose_m = 0.15F;

/// The views nearest to a place, in their order.
std::vector<std::size_t> views_near(const MapViews& views, const Pose2& T_grid_sensor) {
  struct View {
    std::size_t index;
    double distance_m;
  };
  std::vector<View> near;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double distance_m =
        (views.T_grid_sensor(i).translation() - T_grid_sensor.translation()).norm();
    if (distance_m <= kReach_m) near.push_back({i, distance_m});
  }
  if (near.size() > kMostNear) {
    sort_by(near, &View::distance_m);
    near.resize(kMostNear);
    sort_by(near, &View::index);
  }
  std::vector<std::size_t> nearest;
  for (const View& view : near) nearest.push_back(view.index);
  return nearest;
}

/// Of these the views that agree most with the scan there, the best first.
std::vector<const MapView*> views_about(const MapViews& views,
                                        const PreparedScan& scan,
                                        const Pose2& T_grid_sensor) {
  constexpr double kTolerance_m = 0.3;
  struct View {
    const MapView* view;
    double agreeing_m;
  };
  std::vector<View> near;
  for (const std::size_t i : views_near(views, T_grid_sensor)) {
    const MapView& view = views[i];
    const Pose2 T_view_scan = view.T_grid_sensor.inverse() * T_grid_sensor;
    near.push_back(
        {&view,
         align_one_way(view.image, scan.coarse, T_view_scan, kTolerance_m).evidence.agreeing_m});
  }
  sort_by_greatest(near, &View::agreeing_m);
  std::vector<const MapView*> best;
  for (const View& view : std::span(near).first(std::min(kMostViews, near.size()))) {
    best.push_back(view.view);
  }
  return best;
}

/// Steps of Gauss and Newton onto the walls of all views.
Pose2 moved_onto_views(std::span<const PlacedImage> images,
                       const SurfaceSamples& samples,
                       const Pose2& T_grid_sensor) {
  constexpr double kMaxStep_m = 0.2;
  constexpr double kGatesPerScale = 3.0;
  Pose2 T = T_grid_sensor;
  PointMarks marks;
  for (const double gate_m : {0.3, 0.2, 0.15, 0.15}) {
    const AlignmentScale scale{.gate_m = gate_m, .scale_m = gate_m / kGatesPerScale};
    const SubmapAlignment found = align_with_submap(images, samples, T, scale, marks);
    T = stepped_onto_walls(T, {found.hessian, found.gradient}, kMaxStep_m);
  }
  return T;
}

/// What a sample met in any view.
struct Met {
  float distance_m = std::numeric_limits<float>::infinity();  ///< From the nearest wall it is on.
  bool is_near_clutter = false;
  bool is_seen_through = false;
  bool is_behind = false;
};

void add_view(const PlacedImage& placed,
              const SurfaceSamples& samples,
              const Pose2& T_grid_sensor,
              std::vector<Met>& met) {
  const Pose2 T_view_scan = placed.T_submap_sensor.inverse() * T_grid_sensor;
  compare_by_fours(
      *placed.image, samples, T_view_scan, [&](std::size_t first, const auto& compared) {
        const Floats distance = compared.distance_m;
        const Ints has_normal = compared.has_normal();
        const Ints is_near = absolute(distance) < spread(kLoose_m);
        const Ints on_line = is_near & has_normal & compared.faces_alike();
        const Ints is_unseen = distance < spread(-kHalfNoSurface_m);
        const Ints is_before = (distance > Floats{}) | is_unseen;
        const Ints is_through = compared.is_in_free_space() & is_before & ~is_near;
        for (std::size_t lane = 0; lane < kLanes && first + lane < samples.size(); ++lane) {
          Met& sample = met[first + lane];
          if (on_line[lane]) {
            sample.distance_m = std::min(sample.distance_m, std::abs(distance[lane]));
          } else if (is_near[lane] && !has_normal[lane]) {
            sample.is_near_clutter = true;
          } else if (is_through[lane]) {
            sample.is_seen_through = true;
          } else if (!is_near[lane] && !is_before[lane]) {
            sample.is_behind = true;
          }
        }
      });
}

void add_kinds(const SurfaceSamples& samples, std::span<const Met> met, SeenByViews& seen) {
  double square_m3 = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double weight_m = samples.weight_m[i];
    seen.wall_m += weight_m;
    if (met[i].distance_m < kLoose_m) {
      seen.loose_m += weight_m;
      if (met[i].distance_m < kTight_m) seen.tight_m += weight_m;
      square_m3 += weight_m * met[i].distance_m * met[i].distance_m;
    } else if (met[i].is_near_clutter) {
      // Anything may stand there.
    } else if (met[i].is_seen_through) {
      seen.through_m += weight_m;
    } else if (met[i].is_behind) {
      seen.behind_m += weight_m;
    } else {
      seen.outside_m += weight_m;
    }
  }
  if (seen.loose_m > 0.0) seen.distance_m = std::sqrt(square_m3 / seen.loose_m);
}

}  // namespace

struct MapViews::Slot {
  std::once_flag once;
  std::atomic<bool> is_made = false;
  std::shared_ptr<const Scan> scan;  ///< Until the view is made.
  MapView view;
};

MapViews::MapViews(std::span<const SharedScan> scans, const Pose2& T_map_grid)
    : slots_(std::make_shared<std::vector<Slot>>(scans.size())) {
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].scan->validate();
    Slot& slot = (*slots_)[i];
    slot.scan = scans[i].scan;
    slot.view.T_grid_sensor = T_map_grid.inverse() * scans[i].T_map_sensor;
  }
}

std::size_t MapViews::size() const { return slots_ ? slots_->size() : 0; }

const Pose2& MapViews::T_grid_sensor(std::size_t i) const {
  return (*slots_)[i].view.T_grid_sensor;
}

const MapView& MapViews::operator[](std::size_t i) const {
  Slot& slot = (*slots_)[i];
  std::call_once(slot.once, [&] {
    PreparedScan prepared = prepare(*slot.scan);
    slot.view.image = prepared.image();
    slot.view.fine = std::move(prepared.fine);
    slot.scan.reset();
    slot.is_made = true;
  });
  return slot.view;
}

std::size_t MapViews::num_made() const {
  if (!slots_) return 0;
  return static_cast<std::size_t>(
      std::ranges::count_if(*slots_, [](const Slot& slot) { return slot.is_made.load(); }));
}

SeenByViews seen_by_views(const MapViews& views,
                          const PreparedScan& scan,
                          const Pose2& T_grid_sensor) {
  const std::vector<const MapView*> about = views_about(views, scan, T_grid_sensor);
  SeenByViews seen{.num_views = about.size()};
  if (about.empty()) return seen;
  std::vector<PlacedImage> images;
  for (const MapView* view : about) images.push_back({&view->image, view->T_grid_sensor});
  const Pose2 T = moved_onto_views(images, scan.dense, T_grid_sensor);
  std::vector<Met> met(scan.fine.size());
  for (const PlacedImage& placed : images) add_view(placed, scan.fine, T, met);
  add_kinds(scan.fine, met, seen);
  const std::size_t num_agreeing = std::min(kMostAgreeing, about.size());
  for (const MapView* view : std::span(about).first(num_agreeing)) {
    const TwoWayKinds kinds = wall_kinds(
        {view->image, view->fine}, scan.fine_alignment(), view->T_grid_sensor.inverse() * T);
    seen.missed_m += kinds.backward.contradicted_m / static_cast<double>(num_agreeing);
    seen.unexplained_m += kinds.backward.unexplained_m / static_cast<double>(num_agreeing);
  }
  return seen;
}

}  // namespace setsquare
