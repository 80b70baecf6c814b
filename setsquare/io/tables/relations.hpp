// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "setsquare/core/relation.hpp"

namespace setsquare {

class ByteSource;  // setsquare/io/bytes/byte_source.hpp

/// Reads ground truth: one relation per line, "stamp1 stamp2 x y z roll pitch yaw" (m, rad); z,
/// roll and pitch are read and left out. Empty lines and lines that begin with # are skipped. The
/// lines keep their order, repeated ones included. Throws FileError; FormatError with the line: no
/// line of a ground truth may be lost.
[[nodiscard]] std::vector<Relation> read_relations(const std::string& path);
/// The same of text from any source; `name` stands for the path in errors.
[[nodiscard]] std::vector<Relation> read_relations(std::unique_ptr<ByteSource> source,
                                                   const std::string& name);

/// How much the two scans of a pair see of the same surfaces.
struct PairOverlap {
  Timestamp reference_stamp;  ///< Of the pair's reference scan.
  Timestamp current_stamp;    ///< Of its current scan.
  double overlap = 0.0;       ///< Share of the current scan's returns, 0 to 1.
};

/// Reads "stamp1 stamp2 overlap", one pair per line, in the order of the relations. Throws
/// as read_relations() does.
[[nodiscard]] std::vector<PairOverlap> read_overlaps(const std::string& path);
/// The same of text from any source; `name` stands for the path in errors.
[[nodiscard]] std::vector<PairOverlap> read_overlaps(std::unique_ptr<ByteSource> source,
                                                     const std::string& name);

}  // namespace setsquare
