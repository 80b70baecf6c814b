// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {

class ByteSource;  // setsquare/io/bytes/byte_source.hpp

/// The TUM format (as evo reads it): one pose per line, "stamp x y z qx qy qz qw", in the order of
/// the trajectory. Stamps have six decimals, positions (m) six, quaternions nine.
[[nodiscard]] std::string tum_from_trajectory(const Trajectory& trajectory);

/// Writes tum_from_trajectory() under a temporary name and renames it. Throws FileError.
void write_trajectory_tum(const std::string& path, const Trajectory& trajectory);

/// The order in which a file gives the parts of its quaternions.
enum class QuaternionOrder {
  kWLast,   ///< "qx qy qz qw": the TUM format's.
  kWFirst,  ///< "qw qx qy qz": that of EuRoC and others.
};

/// A trajectory as it was read, and what a plane cannot hold of it.
struct TumReading {
  Trajectory trajectory;       ///< In the order of the file.
  std::size_t num_tilted = 0;  ///< Poses that lie on their side: more than 45 deg from upright.
};

/// Reads the TUM format as read_trajectory_tum does, and counts poses of no robot on a floor: where
/// most are tilted, the quaternions are probably written w first.
[[nodiscard]] TumReading read_tum(std::unique_ptr<ByteSource> source,
                                  const std::string& name,
                                  QuaternionOrder order = QuaternionOrder::kWLast);
/// The same of a file; "-" is standard input.
[[nodiscard]] TumReading read_tum(const std::string& path,
                                  QuaternionOrder order = QuaternionOrder::kWLast);

/// Reads the TUM format; z, and any rotation but that about z, are left out. Throws FileError;
/// FormatError with the line.
[[nodiscard]] Trajectory read_trajectory_tum(const std::string& path);
/// The same of text from any source; `name` stands for the path in errors.
[[nodiscard]] Trajectory read_trajectory_tum(std::unique_ptr<ByteSource> source,
                                             const std::string& name);

}  // namespace setsquare
