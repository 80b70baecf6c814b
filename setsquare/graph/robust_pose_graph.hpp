// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Graduated non-convexity: Yang et al. 2020, "Graduated Non-Convexity for Robust Spatial
// Perception", IEEE RA-L 5.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/graph/robust_params.hpp"

namespace setsquare {
/// Weights of the loop closures and positions of the nodes, headings as they are: truncated least
/// squares by graduated non-convexity, each step one linear solve.
///
/// 1. Graduation from full weights of all closures (a warm start rejects the right closure after a
///    long loop).
/// 2. Where closures were refused: a second graduation, from full weights of those that odometry's
///    own covariance does not exclude; all may join when it ends. Wrong closures that outnumber the
///    right ones can pull the first start where the right ones look wrong.
/// 3. The one with the lower cost stays: sum of the squared errors, closures' truncated at their
///    threshold. So odometry that is worse than its information says does no harm.
///
/// 4. Then refused groups that odometry does not exclude are taken in one after the other, and stay
///    where what they contradict falls and the cost with it.
/// 5. Where no groups are given, at last every closure stands for itself.
///
/// The squared error of a closure is e^T W e: W is the information of its translation given the
/// rotation, and e has the part taken out that a rotation at variance with the headings explains
/// (linear_pose_graph.hpp). The rotation itself is not judged. A caller that trusts a closure's
/// rotation less than the headings passes a W without that coupling.
///
/// `groups`: one entry per constraint; closures of one group are accepted or refused together, by
/// their mean squared error as a share of their thresholds; empty: by the claims that they make
/// (claims_of() in dead_reckoning.hpp). A wrong claim can so not be believed in part, where
/// odometry is loose, when as a whole it is contradicted. Odometry constraints keep their weight. A
/// piece of track that odometry does not join to node 0 still gets a position where all closures
/// that join it are refused: the one that they agree upon best. Throws ParameterError where a node
/// is not connected, or a parameter or the graph is not valid.
void solve_robustly(PoseGraph& graph,
                    std::span<const std::size_t> groups = {},
                    const RobustPoseGraphParams& params = {});

}  // namespace setsquare
