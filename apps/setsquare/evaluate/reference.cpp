// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/reference.hpp"

#include <cmath>
#include <cstddef>

#include "setsquare/core/error.hpp"
#include "setsquare/io/tables/number_table.hpp"

namespace setsquare::app {

ReferenceKind reference_kind(const std::string& path) {
  constexpr double kUnitTolerance = 1e-3;
  if (path == "-") throw Error("standard input as reference: say --reference-kind");
  std::size_t num_rows = 0;
  std::size_t num_unit = 0;
  for_each_row<1, 7>(open_file_source(path),
                     path,
                     "eight numbers: a relation, or a pose of a trajectory",
                     [&](const TableRow<1, 7>& row) {
                       const auto& [x, y, z, qx, qy, qz, qw] = row.values;
                       const double squared_norm = qx * qx + qy * qy + qz * qz + qw * qw;
                       ++num_rows;
                       if (std::abs(squared_norm - 1.0) <= kUnitTolerance) ++num_unit;
                     });
  if (num_unit == num_rows) return ReferenceKind::kTrajectory;
  if (2 * num_unit <= num_rows) return ReferenceKind::kRelations;
  throw FormatError(path, "", "neither relations nor a trajectory for sure: say --reference-kind");
}

}  // namespace setsquare::app
