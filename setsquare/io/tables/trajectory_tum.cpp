// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/trajectory_tum.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "setsquare/core/save_file.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/tables/number_table.hpp"

namespace setsquare {
namespace {

/// Only unit quaternions are valid: lines of relations have the same number of columns.
constexpr double kLengthTolerance = 0.01;

struct Quaternion {
  double x, y, z, w;
};

/// The angle about z of a rotation (ZYX convention).
double heading_of(const Quaternion& q) {
  return wrap_to_pi(std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z)));
}

/// Whether the rotation takes the upward direction more than 45 degrees away.
bool is_tilted(const Quaternion& q) {
  const double cos_45_deg = std::sqrt(0.5);
  return 1.0 - 2.0 * (q.x * q.x + q.y * q.y) < cos_45_deg;
}

}  // namespace

std::string tum_from_trajectory(const Trajectory& trajectory) {
  std::string text;
  for (const StampedPose& stamped : trajectory) {
    const double half_rad = 0.5 * wrap_to_pi(stamped.pose.theta_rad);
    fmt::format_to(std::back_inserter(text),
                   "{} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n",
                   to_string(stamped.stamp),
                   stamped.pose.x_m,
                   stamped.pose.y_m,
                   std::sin(half_rad),
                   std::cos(half_rad));
  }
  return text;
}

void write_trajectory_tum(const std::string& path, const Trajectory& trajectory) {
  save_file(path, tum_from_trajectory(trajectory));
}

TumReading read_tum(std::unique_ptr<ByteSource> source,
                    const std::string& name,
                    QuaternionOrder order) {
  TumReading reading;
  const bool is_w_first = order == QuaternionOrder::kWFirst;
  for_each_row<1, 7>(
      std::move(source), name, "\"stamp x y z qx qy qz qw\"", [&](const TableRow<1, 7>& row) {
        const auto& [x_m, y_m, z_m, first, second, third, fourth] = row.values;
        const double length = std::hypot(std::hypot(first, second), std::hypot(third, fourth));
        if (std::abs(length - 1.0) > kLengthTolerance) {
          throw FormatError(name,
                            "stamp " + to_string(row.stamps[0]),
                            "qx qy qz qw are no rotation: their length is not 1");
        }
        const Quaternion q = is_w_first ? Quaternion{second, third, fourth, first}
                                        : Quaternion{first, second, third, fourth};
        reading.num_tilted += is_tilted(q) ? 1 : 0;
        reading.trajectory.push_back({row.stamps[0], {x_m, y_m, heading_of(q)}});
      });
  return reading;
}

TumReading read_tum(const std::string& path, QuaternionOrder order) {
  return read_tum(open_file_source(path), path, order);
}

Trajectory read_trajectory_tum(std::unique_ptr<ByteSource> source, const std::string& name) {
  return read_tum(std::move(source), name).trajectory;
}

Trajectory read_trajectory_tum(const std::string& path) { return read_tum(path).trajectory; }

}  // namespace setsquare
