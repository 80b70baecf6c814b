// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  PoseGraph graph;
  try {
    graph = read_pose_graph_g2o(make_memory_source(fuzz::bytes_from(data, size)), "fuzz").graph;
  } catch (const FormatError&) {
    return 0;
  }
  // What was read is a graph, can be written and reads back with the same poses.
  fuzz::require(!graph.T_map_node.empty());
  validate(graph);
  const PoseGraph again =
      read_pose_graph_g2o(make_memory_source(g2o_from_pose_graph(graph)), "written").graph;
  fuzz::require(again.T_map_node == graph.T_map_node);
  fuzz::require(again.constraints.size() == graph.constraints.size());
  fuzz::require(again.headings.size() == graph.headings.size());
  return 0;
}
