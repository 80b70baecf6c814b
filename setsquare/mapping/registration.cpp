// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/registration.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "setsquare/core/damped_step.hpp"
#include "setsquare/core/parallel.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/graph/gauss_newton.hpp"
#include "setsquare/tracking/open_direction.hpp"

namespace setsquare {
namespace {

/// Keeps the normal equations solvable where no point binds anything (points x (1, m^2)).
constexpr double kPairDamping = 1e-2;
constexpr double kMinCompared = 20.0;
/// Keyframes to either side of a revisited place that are compared, too.
constexpr std::ptrdiff_t kReach = 2;
/// One radian counts as this many metres.
constexpr double kMetresPerRadian = 1.0;

/// Calls visit(from, to) for the keyframes about those of a closure, each in its own stretch.
template <typename Visit>
void visit_pairs_about(const Constraint& closure, const KeyframeTrack& track, Visit visit) {
  const auto n = static_cast<std::ptrdiff_t>(track.size());
  const auto is_beside = [&](std::ptrdiff_t k, std::size_t middle) {
    return k >= 0 && k < n &&
           track.stretches[static_cast<std::size_t>(k)] == track.stretches[middle];
  };
  for (std::ptrdiff_t a = -kReach; a <= kReach; ++a) {
    const auto from = static_cast<std::ptrdiff_t>(closure.from) + a;
    if (!is_beside(from, closure.from)) continue;
    for (std::ptrdiff_t b = -kReach; b <= kReach; ++b) {
      const auto to = static_cast<std::ptrdiff_t>(closure.to) + b;
      if (!is_beside(to, closure.to) || from >= to) continue;
      visit(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    }
  }
}

/// Earlier keyframes that saw the same place, a list per keyframe.
std::vector<std::vector<std::size_t>> revisited_keyframes(const KeyframeTrack& track,
                                                          std::span<const Constraint> closures,
                                                          const PoseGraph& graph,
                                                          std::size_t max_num) {
  std::vector<std::vector<std::size_t>> earlier(track.size());
  for (const Constraint& closure : closures) {
    visit_pairs_about(
        closure, track, [&](std::size_t from, std::size_t to) { earlier[to].push_back(from); });
  }
  for (std::size_t k = 0; k < track.size(); ++k) {
    std::vector<std::size_t>& list = earlier[k];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    const auto distance = [&](std::size_t other) {
      const Pose2 off = graph.T_map_node[k].inverse() * graph.T_map_node[other];
      return std::hypot(off.x_m, off.y_m) + kMetresPerRadian * std::abs(off.theta_rad);
    };
    std::stable_sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
      return distance(a) < distance(b);
    });
    if (list.size() > max_num) list.resize(max_num);
  }
  return earlier;
}

/// One Gauss-Newton step of `current` in the image of `reference`, as a constraint.
std::optional<Constraint> compare(const KeyframeTrack& track,
                                  std::size_t reference,
                                  std::size_t current,
                                  const SurfaceSamples& points,
                                  const PoseGraph& graph,
                                  const RegistrationParams& params,
                                  PointMarks& marks) {
  const PlacedImage placed{&track.keyframes[reference]->image(), {}};
  const Pose2 T = graph.T_map_node[reference].inverse() * graph.T_map_node[current];
  const SubmapAlignment found = align_with_submap({&placed, 1}, points, T, params.scale, marks);
  if (found.num_compared < kMinCompared ||
      found.num_explained < params.min_explained * static_cast<double>(points.size()) ||
      found.num_contradicted > params.max_contradicted * found.num_compared) {
    return std::nullopt;
  }
  // Along a bare corridor keyframes stay where the graph has them: what the walls show there by
  // chance must not move them, and it keeps what is shown across from moving them along.
  const OpenDirection open = open_direction(found.hessian.topLeftCorner<2, 2>());
  const Eigen::Matrix3d kept =
      keeping_open_share(open, open.effective_points < params.min_effective_points ? 0.0 : 1.0);
  const NormalEquations<3> bound{kept * found.hessian * kept, kept * found.gradient};
  Constraint constraint;
  constraint.from = reference;
  constraint.to = current;
  constraint.T_from_to = stepped(T, damped_step(bound, kPairDamping));
  constraint.information = found.hessian / (params.point_sigma_m * params.point_sigma_m);
  constraint.kind = ConstraintKind::kOdometry;
  return constraint;
}

/// Whether one of the pairs about a closure was compared. `compared`: a list per keyframe.
bool is_compared(const Constraint& closure,
                 const KeyframeTrack& track,
                 const std::vector<std::vector<Constraint>>& compared) {
  bool is_found = false;
  visit_pairs_about(closure, track, [&](std::size_t from, std::size_t to) {
    is_found = is_found || std::any_of(compared[to].begin(),
                                       compared[to].end(),
                                       [&](const Constraint& pair) { return pair.from == from; });
  });
  return is_found;
}

}  // namespace

void RegistrationParams::validate() const {
  require_not_negative(num_rounds, "registration.num_rounds");
  scale.validate("registration.scale");
  require_not_negative(min_explained, "registration.min_explained");
  require_not_negative(max_contradicted, "registration.max_contradicted");
  require_not_negative(min_effective_points, "registration.min_effective_points");
  require_positive(point_sigma_m, "registration.point_sigma_m");
}

void register_keyframes(const KeyframeTrack& track,
                        std::span<const Constraint> closures,
                        PoseGraph& graph,
                        const RegistrationParams& params,
                        std::size_t num_threads) {
  const std::size_t num_before = params.num_before * track.num_scanners();
  for (int round = 0; round < params.num_rounds; ++round) {
    const auto earlier = revisited_keyframes(track, closures, graph, params.max_revisits);
    std::vector<std::vector<Constraint>> compared(track.size());
    run_in_parallel(track.size(), num_threads, [&](std::size_t k) {
      const SurfacePoints& points = track.keyframes[k]->points();
      const SurfaceSamples samples = sample_surface(points, points.size());
      PointMarks marks;
      const auto add = [&](std::size_t reference) {
        auto constraint = compare(track, reference, k, samples, graph, params, marks);
        if (constraint) compared[k].push_back(*std::move(constraint));
      };
      for (std::size_t before = 1; before <= std::min(k, num_before); ++before) {
        if (track.stretches[k - before] == track.stretches[k]) add(k - before);
      }
      for (const std::size_t reference : earlier[k]) add(reference);
    });

    PoseGraph all = graph;
    std::vector<Constraint> not_compared;
    for (const Constraint& closure : closures) {
      if (!is_compared(closure, track, compared)) not_compared.push_back(closure);
    }
    std::size_t num_constraints = all.constraints.size() + not_compared.size();
    for (const auto& list : compared) num_constraints += list.size();
    all.constraints.reserve(num_constraints);
    for (const auto& list : compared) {
      all.constraints.insert(all.constraints.end(), list.begin(), list.end());
    }
    compared = std::vector<std::vector<Constraint>>();  // Solving takes memory of its own.
    all.constraints.insert(all.constraints.end(), not_compared.begin(), not_compared.end());
    polish(all, {.max_iterations = 1});
    graph.T_map_node = std::move(all.T_map_node);
  }
}

}  // namespace setsquare
