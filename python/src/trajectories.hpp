// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>

#include "python/src/conversions.hpp"
#include "setsquare/core/trajectory.hpp"

namespace setsquare::python {

/// A trajectory with a type of its own, for Python: a vector would become a list of objects.
struct TrajectoryArrays {
  Trajectory poses;
};

/// From arrays of shapes (N,) and (N, 3). Throws ValueError where the shapes do not fit.
[[nodiscard]] TrajectoryArrays trajectory_from_arrays(
    const pybind11::array_t<std::int64_t, pybind11::array::c_style>& stamps_ns,
    const DoubleArray& poses);

[[nodiscard]] pybind11::array_t<std::int64_t> stamps_ns_of(const TrajectoryArrays& trajectory);
[[nodiscard]] DoubleArray stamps_s_of(const TrajectoryArrays& trajectory);
[[nodiscard]] DoubleArray poses_of(const TrajectoryArrays& trajectory);

}  // namespace setsquare::python
