// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "python/src/conversions.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "setsquare/core/error.hpp"

namespace setsquare::python {

DoubleArray array_of(const std::vector<Pose2>& poses) {
  DoubleArray array({static_cast<pybind11::ssize_t>(poses.size()), pybind11::ssize_t{3}});
  double* to = array.mutable_data();
  for (const Pose2& pose : poses) {
    *to++ = pose.x_m;
    *to++ = pose.y_m;
    *to++ = pose.theta_rad;
  }
  return array;
}

Timestamp stamp_from(double stamp_s, const std::optional<std::int64_t>& stamp_ns) {
  if (stamp_ns) return {*stamp_ns};
  constexpr double kMax_s = 9e9;
  if (!(std::abs(stamp_s) < kMax_s)) throw ParameterError("stamp_s", "must be a time in seconds");
  return timestamp_from_seconds(stamp_s);
}

bool is_of_sensor(const std::string& pose_of) {
  if (pose_of != "base" && pose_of != "sensor") {
    throw ParameterError("pose_of", "must be \"base\" or \"sensor\"");
  }
  return pose_of == "sensor";
}

std::string path_from(const pybind11::object& path) {
  const pybind11::object bytes = pybind11::module_::import("os").attr("fsencode")(path);
  auto text = bytes.cast<std::string>();
  if (text.find('\0') != std::string::npos) {
    throw pybind11::value_error("a path must not contain a zero byte");
  }
  return text;
}

int threads_from(int num_threads) {
  if (num_threads < 0) throw ParameterError("num_threads", "must not be negative");
  return num_threads > 0 ? num_threads
                         : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace setsquare::python
