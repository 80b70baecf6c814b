// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

/// The points of a PointCloud2 in the sensor's frame. Points with a coordinate that is not finite
/// (a beam without a return), or beyond 1000 km, are left out.
struct SensorPoints {
  std::vector<float> x_m;
  std::vector<float> y_m;
  std::vector<float> z_m;           ///< Zeros where the message has no z.
  std::vector<std::int32_t> rings;  ///< The beam's row in a scanner of many; empty without it.

  [[nodiscard]] std::size_t size() const { return x_m.size(); }
  void clear();
};

/// Takes the points out of a message: fields x, y, z and "ring" or "channel", of any type of
/// number, at any offset, in either byte order, in rows with or
/// without gaps. The result is empty, or says what is wrong with the message.
[[nodiscard]] std::string_view read_points(const PointCloud2& message, SensorPoints& points);

}  // namespace setsquare::ros
