// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Pose2 and Trajectory.
#include <fmt/core.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/trajectories.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

Pose2 pose_from_sequence(const py::sequence& values) {
  if (values.size() != 3) throw py::value_error("a pose has three numbers: x_m, y_m, theta_rad");
  try {
    return {values[0].cast<double>(), values[1].cast<double>(), values[2].cast<double>()};
  } catch (const py::cast_error&) {
    throw py::type_error("a pose has three numbers: x_m, y_m, theta_rad");
  }
}

/// The points of shape (N, 2), or one of shape (2,), moved by a pose.
DoubleArray moved(const Pose2& T_a_b, const DoubleArray& points_b) {
  const py::ssize_t num_axes = points_b.ndim();
  if (num_axes < 1 || num_axes > 2 || points_b.shape(num_axes - 1) != 2) {
    throw py::value_error("points must have the shape (N, 2), or (2,) for one");
  }
  DoubleArray points_a(
      std::vector<py::ssize_t>(points_b.shape(), points_b.shape() + points_b.ndim()));
  const double* from = points_b.data();
  double* to = points_a.mutable_data();
  for (py::ssize_t i = 0; i < points_b.size(); i += 2) {
    Eigen::Map<Eigen::Vector2d>(to + i) = T_a_b * Eigen::Vector2d(from[i], from[i + 1]);
  }
  return points_a;
}

void bind_pose(py::module_& module) {
  py::class_<Pose2>(module, "Pose2", R"(A rigid motion of the plane.

Named T_a_b it maps points of frame b into frame a, and is the pose of b in a; products chain:
T_a_c = T_a_b * T_b_c. Its numbers do not change. Wherever a pose is taken, three numbers (x_m, y_m, theta_rad) do as well.)")
      .def(py::init([](double x_m, double y_m, double theta_rad) {
             return Pose2{x_m, y_m, theta_rad};
           }),
           py::arg("x_m") = 0.0,
           py::arg("y_m") = 0.0,
           py::arg("theta_rad") = 0.0)
      .def(py::init(&pose_from_sequence), py::arg("values"), "From three numbers.")
      .def_readonly("x_m", &Pose2::x_m, "Of the origin of b along the x axis of a, in m.")
      .def_readonly("y_m", &Pose2::y_m, "The same along its y axis.")
      .def_readonly(
          "theta_rad", &Pose2::theta_rad, "How b is turned in a, counterclockwise, in rad.")
      .def_property_readonly(
          "theta_deg",
          [](const Pose2& pose) { return deg_from_rad(pose.theta_rad); },
          "The rotation in degrees.")
      .def("inverse", &Pose2::inverse, "T_b_a of T_a_b.")
      .def("transform", &moved, py::arg("points"), R"(Points moved from frame b into frame a.

points: float array of shape (N, 2), or (2,) for one point, in m. Returns the same shape.)")
      .def("__mul__", [](const Pose2& T_a_b, const Pose2& T_b_c) { return T_a_b * T_b_c; })
      .def(py::self == py::self)  // NOLINT(misc-redundant-expression)
      .def(py::pickle(
          [](const Pose2& pose) { return py::make_tuple(pose.x_m, pose.y_m, pose.theta_rad); },
          [](const py::tuple& state) { return pose_from_sequence(state); }))
      .def("__len__", [](const Pose2&) { return 3; })
      .def("__iter__",
           [](const Pose2& pose) {
             return py::iter(py::make_tuple(pose.x_m, pose.y_m, pose.theta_rad));
           })
      .def("__getitem__",
           [](const Pose2& pose, const py::object& key) {
             return py::object(py::make_tuple(pose.x_m, pose.y_m, pose.theta_rad)[key]);
           })
      .def("__repr__", [](const Pose2& pose) {
        return fmt::format(
            "Pose2(x_m={:.6g}, y_m={:.6g}, theta_rad={:.6g})", pose.x_m, pose.y_m, pose.theta_rad);
      });
  py::implicitly_convertible<py::sequence, Pose2>();
  py::implicitly_convertible<py::array, Pose2>();
}

void bind_trajectory(py::module_& module) {
  py::class_<TrajectoryArrays>(
      module, "Trajectory", "Stamped poses in the order in which they were measured.")
      .def(
          py::init(&trajectory_from_arrays),
          py::arg("stamps_ns"),
          py::arg("poses"),
          R"(stamps_ns: int64 array of shape (N,), nanoseconds; poses: float array of shape (N, 3), m, m, rad.

Raises ValueError where the shapes do not fit.)")
      .def_static(
          "read_tum",
          [](const py::object& path) {
            return TrajectoryArrays{read_trajectory_tum(path_from(path))};
          },
          py::arg("path"),
          "Reads a file in the TUM format, as evo writes it. Raises FileError, FormatError.")
      .def(
          "save_tum",
          [](const TrajectoryArrays& self, const py::object& path) {
            write_trajectory_tum(path_from(path), self.poses);
          },
          py::arg("path"),
          "Writes the TUM format: stamp x y z qx qy qz qw, a line a pose. Raises FileError.")
      .def(
          "to_tum",
          [](const TrajectoryArrays& self) { return tum_from_trajectory(self.poses); },
          "The text that save_tum writes.")
      .def_property_readonly("stamps_ns", &stamps_ns_of, "int64 array of shape (N,), nanoseconds.")
      .def_property_readonly("stamps_s",
                             &stamps_s_of,
                             "float array of shape (N,), seconds; rounded to what a double holds.")
      .def_property_readonly(
          "poses", &poses_of, "float array of shape (N, 3): x and y in m, theta in rad.")
      .def("__len__", [](const TrajectoryArrays& self) { return self.poses.size(); })
      .def("__repr__", [](const TrajectoryArrays& self) {
        return fmt::format("Trajectory({} poses)", self.poses.size());
      });
}

}  // namespace

TrajectoryArrays trajectory_from_arrays(
    const py::array_t<std::int64_t, py::array::c_style>& stamps_ns, const DoubleArray& poses) {
  if (stamps_ns.ndim() != 1 || poses.ndim() != 2 || poses.shape(1) != 3 ||
      poses.shape(0) != stamps_ns.shape(0)) {
    throw py::value_error("stamps_ns must have the shape (N,), poses (N, 3)");
  }
  TrajectoryArrays trajectory;
  trajectory.poses.reserve(static_cast<std::size_t>(stamps_ns.size()));
  for (py::ssize_t i = 0; i < stamps_ns.size(); ++i) {
    const double* pose = poses.data(i, 0);
    trajectory.poses.push_back({{stamps_ns.at(i)}, {pose[0], pose[1], pose[2]}});
  }
  return trajectory;
}

py::array_t<std::int64_t> stamps_ns_of(const TrajectoryArrays& trajectory) {
  py::array_t<std::int64_t> stamps(static_cast<py::ssize_t>(trajectory.poses.size()));
  std::transform(trajectory.poses.begin(),
                 trajectory.poses.end(),
                 stamps.mutable_data(),
                 [](const StampedPose& stamped) { return stamped.stamp.ns; });
  return stamps;
}

DoubleArray stamps_s_of(const TrajectoryArrays& trajectory) {
  DoubleArray stamps(static_cast<py::ssize_t>(trajectory.poses.size()));
  std::transform(trajectory.poses.begin(),
                 trajectory.poses.end(),
                 stamps.mutable_data(),
                 [](const StampedPose& stamped) { return stamped.stamp.seconds(); });
  return stamps;
}

DoubleArray poses_of(const TrajectoryArrays& trajectory) {
  std::vector<Pose2> poses;
  poses.reserve(trajectory.poses.size());
  for (const StampedPose& stamped : trajectory.poses) poses.push_back(stamped.pose);
  return array_of(poses);
}

void bind_poses(py::module_& module) {
  bind_pose(module);
  bind_trajectory(module);
}

}  // namespace setsquare::python
