// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// simulate: scans of a made-up building with the truth.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/trajectories.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/simulated_drive.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// A drive, and the building that it went through.
struct PySimulation {
  std::vector<std::shared_ptr<Scan>> scans;
  TrajectoryArrays truth;
  TrajectoryArrays odometry;
  FloorPlan plan;
};

/// What `simulate` takes, but for the building.
struct DriveOptions {
  std::uint64_t seed;
  std::string scanner;
  std::optional<double> fov_deg;
  std::optional<std::size_t> num_beams;
  std::optional<double> sweep_time_s;
  double rate_hz;
  std::optional<double> every_m;
  double every_deg;
  double speed_m_per_s;
  std::optional<double> turn_rate_deg_per_s;
  double spin_deg;
  bool odometry_drift;
  std::vector<Pose2> mountings;
};

SimulatedDriveParams drive_from(const DriveOptions& options) {
  SimulatedDriveParams drive;
  drive.seed = options.seed;
  drive.scanner = scanner_named(options.scanner);
  if (options.fov_deg) {
    drive.scanner = with_field_of_view(drive.scanner, rad_from_deg(*options.fov_deg));
  }
  if (options.num_beams) drive.scanner = with_num_beams(drive.scanner, *options.num_beams);
  if (options.sweep_time_s) drive.scanner.sweep_s = *options.sweep_time_s;
  if (!(drive.scanner.sweep_s >= 0.0 && drive.scanner.sweep_s <= 10.0)) {
    throw ParameterError("sweep_time_s", "must be from 0 to 10 s");
  }
  if (!(options.rate_hz > 0.0)) throw ParameterError("rate_hz", "must be positive");
  drive.scans_per_s = options.rate_hz;
  drive.every_m = options.every_m;
  drive.every_rad = rad_from_deg(options.every_deg);
  drive.speed.drive_m_per_s = options.speed_m_per_s;
  if (options.turn_rate_deg_per_s) {
    drive.speed.turn_rad_per_s = rad_from_deg(*options.turn_rate_deg_per_s);
  }
  if (options.spin_deg != 0.0) {
    drive.turn_at_start = {.turn_rad = rad_from_deg(options.spin_deg), .rest_s = 1.0};
  }
  drive.has_drift = options.odometry_drift;
  for (const Pose2& mounting : options.mountings) {
    if (!std::isfinite(mounting.x_m + mounting.y_m + mounting.theta_rad)) {
      throw ParameterError("mountings", "must be finite");
    }
  }
  drive.T_base_sensor = options.mountings;
  return drive;
}

PySimulation run_drive(const Building& world, const SimulatedDriveParams& drive) {
  PySimulation simulation;
  const RobotPath path(world.route_m, drive.speed, drive.turn_at_start);
  simulate_drive(RayCaster(world.plan),
                 world.people,
                 path,
                 drive,
                 [&](const DrivenScan& driven, double /*share_driven*/) {
                   const Scan& scan = driven.simulated.scan;
                   simulation.truth.poses.push_back({scan.stamp, driven.simulated.T_map_base});
                   simulation.odometry.poses.push_back({scan.stamp, driven.T_odom_base});
                   simulation.scans.push_back(std::make_shared<Scan>(scan));
                 });
  simulation.plan = world.plan;
  return simulation;
}

PySimulation simulate(const std::string& building,
                      std::uint64_t seed,
                      bool people,
                      const std::string& scanner,
                      std::optional<double> fov_deg,
                      std::optional<std::size_t> num_beams,
                      std::optional<double> sweep_time_s,
                      double rate_hz,
                      std::optional<double> every_m,
                      double every_deg,
                      double speed_m_per_s,
                      std::optional<double> turn_rate_deg_per_s,
                      double spin_deg,
                      bool odometry_drift,
                      const std::vector<Pose2>& mountings) {
  const SimulatedDriveParams drive = drive_from({seed,
                                                 scanner,
                                                 fov_deg,
                                                 num_beams,
                                                 sweep_time_s,
                                                 rate_hz,
                                                 every_m,
                                                 every_deg,
                                                 speed_m_per_s,
                                                 turn_rate_deg_per_s,
                                                 spin_deg,
                                                 odometry_drift,
                                                 mountings});
  return without_gil([&] {
    Building world = make_building(building, seed);
    if (!people) world.people.clear();
    return run_drive(world, drive);
  });
}

DoubleArray walls_of(const PySimulation& simulation) {
  const auto num_walls = static_cast<py::ssize_t>(simulation.plan.segments.size());
  DoubleArray walls({num_walls, py::ssize_t{2}, py::ssize_t{2}});
  double* to = walls.mutable_data();
  for (const PlanSegment& segment : simulation.plan.segments) {
    for (const Eigen::Vector2d& end_m : {segment.start_m, segment.end_m}) {
      *to++ = end_m.x();
      *to++ = end_m.y();
    }
  }
  return walls;
}

constexpr auto kSimulateDoc = R"(Drives a robot through a made-up building and scans it.

building: "office", "hall", "wings", "corridor", "round", "paper" or "hallway"; seed: another number,
    another building and another drive. people: whether some stand and walk around.
scanner: "utm-30lx" (1081 beams over 270 deg, 30 m) or "low-cost-360" (about 360 beams around, 8 m);
    fov_deg, num_beams, sweep_time_s (first beam to last; 0: all at once) change it.
rate_hz: scans a second; or every_m: a scan whenever the robot moved this far or turned by every_deg.
speed_m_per_s, turn_rate_deg_per_s (28.6): of the robot; spin_deg: a turn on the spot at the start.
odometry_drift: False for wheels that measure the truth.
mountings: poses of scanners on the robot; by default one at its middle.

The same arguments give the same scans as `setsquare simulate`. Raises ParameterError.)";

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<PySimulation>(module, "Simulation", "A simulated drive, with the truth.")
      .def_readonly("scans", &PySimulation::scans, "A list of Scan, in the order of time.")
      .def_readonly("truth", &PySimulation::truth, "The robot's true pose at each scan.")
      .def_readonly("odometry", &PySimulation::odometry, "What the wheels say, likewise.")
      .def_property_readonly(
          "walls_m", &walls_of, "Both ends of every wall, in m: float array of shape (N, 2, 2).")
      .def("__len__", [](const PySimulation& self) { return self.scans.size(); })
      .def("__repr__", [](const PySimulation& self) {
        return fmt::format("Simulation({} scans)", self.scans.size());
      });
  module.def("simulate",
             &simulate,
             py::arg("building") = "office",
             py::arg("seed") = 1,
             py::kw_only(),
             py::arg("people") = true,
             py::arg("scanner") = "utm-30lx",
             py::arg("fov_deg") = py::none(),
             py::arg("num_beams") = py::none(),
             py::arg("sweep_time_s") = py::none(),
             py::arg("rate_hz") = 10.0,
             py::arg("every_m") = py::none(),
             py::arg("every_deg") = 10.0,
             py::arg("speed_m_per_s") = 0.5,
             py::arg("turn_rate_deg_per_s") = py::none(),
             py::arg("spin_deg") = 0.0,
             py::arg("odometry_drift") = true,
             py::arg("mountings") = std::vector<Pose2>{},
             kSimulateDoc);
}

}  // namespace setsquare::python
