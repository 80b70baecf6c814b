// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The text format of g2o (kuemmerle2011): what its tools and others load.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// One line per node, constraint and heading measurement:
///
///   VERTEX_SE2 id x y theta                                 poses in the map frame
///   FIX 0                                                   node 0 is held
///   EDGE_SE2 i j x y theta I11 I12 I13 I22 I23 I33          odometry first, then loop closures
///   EDGE_PRIOR_SE2 id x y theta 0 0 0 0 0 I33               heading measurements; x, y the node's
///
/// Each number is the shortest that reads back as itself. g2o knows no robust weight: it is
/// multiplied into the information. g2o's residual lies in the frame of the measured pose, ours in
/// that of `from`: the information is turned by the measured theta. In g2o FIX holds node 0's
/// heading, too.
[[nodiscard]] std::string g2o_from_pose_graph(const PoseGraph& graph);

/// What a g2o file holds.
struct PoseGraphG2o {
  PoseGraph graph;
  std::uint64_t num_passed_over = 0;  ///< Lines of other kinds than those above.
};

/// Reads a graph. Nodes are put in the order of their ids, which may have gaps; edges and vertices
/// may stand in any order. Node 0 is the one with the lowest id, whatever FIX says. g2o knows no
/// kinds of constraints: those between nodes that follow each other are odometry, the others loop
/// closures. All weights are 1. Of an EDGE_PRIOR_SE2 the heading is taken. Empty lines and those
/// that begin with # are left out, lines of other kinds skipped and counted. Throws FileError;
/// FormatError with the line.
[[nodiscard]] PoseGraph read_pose_graph_g2o(const std::string& path);
[[nodiscard]] PoseGraphG2o read_pose_graph_g2o(std::unique_ptr<ByteSource> source,
                                               const std::string& name);

}  // namespace setsquare
