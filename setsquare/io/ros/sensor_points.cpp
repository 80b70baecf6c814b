// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/sensor_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "setsquare/io/ros/number_types.hpp"
#include "setsquare/io/ros/wire_reader.hpp"

namespace setsquare::ros {
namespace {

/// sensor_msgs/PointField's codes, from 1.
std::optional<Primitive> primitive_of_datatype(std::uint32_t datatype) {
  constexpr std::array<Primitive, 8> kTypes = {Primitive::kInt8,
                                               Primitive::kUint8,
                                               Primitive::kInt16,
                                               Primitive::kUint16,
                                               Primitive::kInt32,
                                               Primitive::kUint32,
                                               Primitive::kFloat32,
                                               Primitive::kFloat64};
  if (datatype == 0 || datatype > kTypes.size()) return std::nullopt;
  return kTypes[datatype - 1];
}

/// Where a coordinate stands in each point.
struct Coordinate {
  Primitive type = Primitive::kFloat32;
  std::size_t offset = 0;
};

double read_coordinate(const Coordinate& coordinate, const char* point, bool is_swapped) {
  return visit_number_type(coordinate.type, [&](auto number) {
    std::memcpy(&number, point + coordinate.offset, sizeof number);
    return static_cast<double>(is_swapped ? with_bytes_reversed(number) : number);
  });
}

/// The field of this name, if it lies within a point; nothing otherwise.
std::optional<Coordinate> find_coordinate(const PointCloud2& message, std::string_view name) {
  for (const PointField& field : message.fields) {
    const auto type = primitive_of_datatype(field.datatype);
    if (field.name != name || !type) continue;
    const std::size_t end = std::size_t{field.offset_bytes} + num_bytes_of(*type);
    if (end <= message.point_step_bytes) return Coordinate{*type, field.offset_bytes};
  }
  return std::nullopt;
}

/// What is wrong with the sizes that the message states; empty if its data holds the points.
std::string_view fault_of_sizes(const PointCloud2& message) {
  const std::size_t row_bytes = std::size_t{message.width} * message.point_step_bytes;
  if (num_bytes_of(message.data.type) != 1) return "its data are no bytes";
  if (message.height > 1 && message.row_step_bytes < row_bytes) return "its rows overlap";
  if (message.height == 0) return {};
  const std::size_t num_bytes = message.data.size();
  if (row_bytes > num_bytes) return "it has fewer bytes than points";
  const std::size_t num_further_rows = message.height - 1;
  if (num_further_rows > 0 && (num_bytes - row_bytes) / message.row_step_bytes < num_further_rows) {
    return "it has fewer bytes than points";
  }
  return {};
}

/// The fields of a message that are read.
struct Coordinates {
  std::optional<Coordinate> x;
  std::optional<Coordinate> y;
  std::optional<Coordinate> z;
  std::optional<Coordinate> ring;
};

void append_point(const Coordinates& at, const char* point, bool is_swapped, SensorPoints& points) {
  constexpr double kMaxReach_m =
      1e6;  // Farther away than any sensor sees; so NaN are left out too.
  const double x_m = read_coordinate(*at.x, point, is_swapped);
  const double y_m = read_coordinate(*at.y, point, is_swapped);
  const double z_m = at.z ? read_coordinate(*at.z, point, is_swapped) : 0.0;
  if (!(std::abs(x_m) + std::abs(y_m) + std::abs(z_m) <= kMaxReach_m)) return;
  points.x_m.push_back(static_cast<float>(x_m));
  points.y_m.push_back(static_cast<float>(y_m));
  points.z_m.push_back(static_cast<float>(z_m));
  if (!at.ring) return;
  constexpr double kMaxRing = 1e6;
  const double ring = read_coordinate(*at.ring, point, is_swapped);
  points.rings.push_back(std::abs(ring) <= kMaxRing ? static_cast<std::int32_t>(ring) : -1);
}

}  // namespace

void SensorPoints::clear() {
  x_m.clear();
  y_m.clear();
  z_m.clear();
  rings.clear();
}

std::string_view read_points(const PointCloud2& message, SensorPoints& points) {
  points.clear();
  Coordinates at{find_coordinate(message, "x"),
                 find_coordinate(message, "y"),
                 find_coordinate(message, "z"),
                 find_coordinate(message, "ring")};
  if (!at.ring) at.ring = find_coordinate(message, "channel");
  if (!at.x || !at.y) return "its points have no x and y";
  if (message.width == 0) return {};
  const std::string_view fault = fault_of_sizes(message);
  if (!fault.empty()) return fault;
  for (std::size_t row = 0; row < message.height; ++row) {
    const char* point = message.data.bytes.data() + row * message.row_step_bytes;
    for (std::size_t i = 0; i < message.width; ++i, point += message.point_step_bytes) {
      append_point(at, point, message.is_bigendian, points);
    }
  }
  return {};
}

}  // namespace setsquare::ros
