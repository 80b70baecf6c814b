// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/wall_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/surfaces/sample_comparison.hpp"

namespace setsquare {
namespace {

constexpr float kTight_m = 0.04F;
constexpr float kLoose_m = 0.15F;

/// Directions around a scan's sensor in which its own surfaces agree with the other scan or not.
class AgreeingDirections {
 public:
  void add(float x_m, float y_m, float weight_m, bool agrees) {
    Direction& direction = directions_[index(x_m, y_m)];
    direction.wall_m += weight_m;
    if (agrees) direction.agreeing_m += weight_m;
  }
  [[nodiscard]] bool agree_at(float x_m, float y_m) const {
    const Direction& direction = directions_[index(x_m, y_m)];
    return direction.agreeing_m > 0.5F * direction.wall_m;
  }

 private:
  static constexpr std::size_t kNumDirections = 128;
  struct Direction {
    float wall_m = 0.0F;
    float agreeing_m = 0.0F;
  };
  [[nodiscard]] static std::size_t index(float x_m, float y_m) {
    const float quarter = SurfaceImage::diamond_angle(x_m, y_m) + 1.0F;
    return std::min(static_cast<std::size_t>(quarter * (kNumDirections / 4)), kNumDirections - 1);
  }
  std::array<Direction, kNumDirections> directions_{};
};

/// A hidden sample's weight and its place in the image's frame.
struct HiddenSample {
  float x_m, y_m, weight_m;
};

struct KindsOneWay {
  WallKinds kinds;
  AgreeingDirections own;  ///< Of the samples' scan.
  std::vector<HiddenSample> hidden;
};

KindsOneWay compare(const SurfaceImage& image, const SurfaceSamples& samples, const Pose2& T) {
  KindsOneWay result;
  result.hidden.reserve(samples.size());
  compare_by_fours(image, samples, T, [&](std::size_t first, const auto& compared) {
    const Floats distance = compared.distance_m;
    const Ints is_near = absolute(distance) < spread(kLoose_m);
    const Ints has_normal = compared.has_normal();
    const Ints on_line = is_near & has_normal & compared.faces_alike();
    const Ints is_unseen = distance < spread(-kHalfNoSurface_m);
    const Ints is_before = (distance > Floats{}) | is_unseen;
    const Ints is_through = compared.is_in_free_space() & is_before & ~is_near;
    for (std::size_t lane = 0; lane < kLanes && first + lane < samples.size(); ++lane) {
      const std::size_t i = first + lane;
      const float weight_m = samples.weight_m[i];
      const bool agrees = is_near[lane] && (on_line[lane] || !has_normal[lane]);
      result.own.add(samples.x_m[i], samples.y_m[i], weight_m, agrees);
      result.kinds.wall_m += weight_m;
      if (on_line[lane]) {
        result.kinds.loose_m += weight_m;
        if (std::abs(distance[lane]) < kTight_m) result.kinds.tight_m += weight_m;
      } else if (agrees) {
        result.kinds.clutter_m += weight_m;
      } else if (is_through[lane]) {
        result.kinds.contradicted_m += weight_m;
      } else if (is_unseen[lane]) {
        result.kinds.outside_m += weight_m;
      } else if (!is_near[lane] && !is_before[lane]) {
        result.hidden.push_back({compared.sample.x_m[lane], compared.sample.y_m[lane], weight_m});
      }
    }
  });
  return result;
}

void add_hidden(const AgreeingDirections& occluders, KindsOneWay& way) {
  for (const HiddenSample& hidden : way.hidden) {
    double& sum_m =
        occluders.agree_at(hidden.x_m, hidden.y_m) ? way.kinds.hidden_m : way.kinds.unexplained_m;
    sum_m += hidden.weight_m;
  }
}

}  // namespace

WallKinds& WallKinds::operator+=(const WallKinds& other) {
  wall_m += other.wall_m;
  tight_m += other.tight_m;
  loose_m += other.loose_m;
  clutter_m += other.clutter_m;
  contradicted_m += other.contradicted_m;
  hidden_m += other.hidden_m;
  unexplained_m += other.unexplained_m;
  outside_m += other.outside_m;
  return *this;
}

TwoWayKinds wall_kinds(const AlignedScan& reference,
                       const AlignedScan& current,
                       const Pose2& T_reference_current) {
  KindsOneWay forward = compare(reference.image, current.samples, T_reference_current);
  KindsOneWay backward = compare(current.image, reference.samples, T_reference_current.inverse());
  add_hidden(backward.own, forward);
  add_hidden(forward.own, backward);
  return {forward.kinds, backward.kinds};
}

}  // namespace setsquare
