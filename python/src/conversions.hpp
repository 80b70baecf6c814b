// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Values that several bindings convert alike.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/core/trajectory.hpp"

namespace setsquare::python {

/// A NumPy array of doubles in C order; converted where it is none.
using DoubleArray =
    pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Any matrix as a NumPy array of its own.
template <int kRows, int kColumns>
[[nodiscard]] DoubleArray array_of(const Eigen::Matrix<double, kRows, kColumns>& matrix) {
  DoubleArray array({kRows, kColumns});
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      *array.mutable_data(row, column) = matrix(row, column);
    }
  }
  return array;
}

/// Poses as an array of shape (N, 3): x and y in m, theta in rad.
[[nodiscard]] DoubleArray array_of(const std::vector<Pose2>& poses);

/// A vector as a read-only array that keeps `owner`, whose part it is, alive: nothing is copied.
template <typename Value>
[[nodiscard]] pybind11::array_t<Value> view_of(const std::vector<Value>& values,
                                               const pybind11::object& owner) {
  pybind11::array_t<Value> array(
      {static_cast<pybind11::ssize_t>(values.size())}, {sizeof(Value)}, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// A stamp from seconds, or from exact nanoseconds where they are given. Throws ParameterError
/// where the seconds are not finite or do not fit.
[[nodiscard]] Timestamp stamp_from(double stamp_s, const std::optional<std::int64_t>& stamp_ns);

/// "base" or "sensor". Throws ParameterError.
[[nodiscard]] bool is_of_sensor(const std::string& pose_of);

/// A path (text, bytes or os.PathLike) as the system spells it. Throws ValueError where a zero byte
/// would cut it short.
[[nodiscard]] std::string path_from(const pybind11::object& path);

/// As many threads as processors where the number is 0. Throws ParameterError below that.
[[nodiscard]] int threads_from(int num_threads);

/// Calls `function` with Python's interpreter free for other threads.
template <typename Function>
auto without_gil(Function function) {
  const pybind11::gil_scoped_release release;
  return function();
}

}  // namespace setsquare::python
