// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The parts of the extension module setsquare._core, in the order in which they must be bound.
#pragma once

#include <pybind11/pybind11.h>

namespace setsquare::python {

void bind_errors(pybind11::module_& module);
void bind_poses(pybind11::module_& module);
void bind_scans(pybind11::module_& module);
void bind_matching(pybind11::module_& module);
void bind_logs(pybind11::module_& module);
void bind_grids(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_mapping(pybind11::module_& module);
void bind_localisation(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);

}  // namespace setsquare::python
