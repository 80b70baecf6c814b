// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/relations.hpp"

#include <utility>

#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/tables/number_table.hpp"

namespace setsquare {

std::vector<Relation> read_relations(std::unique_ptr<ByteSource> source, const std::string& name) {
  std::vector<Relation> relations;
  for_each_row<2, 6>(std::move(source),
                     name,
                     "\"stamp1 stamp2 x y z roll pitch yaw\"",
                     [&relations](const TableRow<2, 6>& row) {
                       const auto& [x_m, y_m, z_m, roll_rad, pitch_rad, yaw_rad] = row.values;
                       relations.push_back({row.stamps[0], row.stamps[1], {x_m, y_m, yaw_rad}});
                     });
  return relations;
}

std::vector<Relation> read_relations(const std::string& path) {
  return read_relations(open_file_source(path), path);
}

std::vector<PairOverlap> read_overlaps(std::unique_ptr<ByteSource> source,
                                       const std::string& name) {
  std::vector<PairOverlap> overlaps;
  for_each_row<2, 1>(
      std::move(source), name, "\"stamp1 stamp2 overlap\"", [&overlaps](const TableRow<2, 1>& row) {
        overlaps.push_back({row.stamps[0], row.stamps[1], row.values[0]});
      });
  return overlaps;
}

std::vector<PairOverlap> read_overlaps(const std::string& path) {
  return read_overlaps(open_file_source(path), path);
}

}  // namespace setsquare
