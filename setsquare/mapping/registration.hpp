// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

/// Parameters of register_keyframes.
struct RegistrationParams {
  int num_rounds = 2;
  std::size_t num_before = 4;    ///< Keyframes just before it that each is compared with.
  std::size_t max_revisits = 6;  ///< And so many of earlier visits, by accepted closures.
  AlignmentScale scale{.gate_m = 0.12, .scale_m = 0.04};
  double min_explained = 0.3;      ///< Of a keyframe's points; pairs with less are left out.
  double max_contradicted = 0.15;  ///< Of the points compared.
  double point_sigma_m = 0.10;     ///< As in LoopCloserParams.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Moves all keyframes at once until the scans agree: every keyframe is compared, point to line,
/// with those just before it and with those of earlier visits, each comparison's normal equations
/// become a constraint, and the graph of all of them is polished together with the headings
/// measured against the building. The surfaces themselves decide, not the poses found earlier.
///
/// `closures` tell which keyframes see a place again, `from` before `to`: those about them are
/// compared in their stead. One where no comparison comes about stands for itself.
/// `graph`: poses of the sensors near their places, which are moved; heading measurements; and the
/// constraints that hold beside the comparisons, by their weights. Any number of threads gives the
/// same poses.
void register_keyframes(const KeyframeTrack& track,
                        std::span<const Constraint> closures,
                        PoseGraph& graph,
                        const RegistrationParams& params,
                        std::size_t num_threads);

}  // namespace setsquare
