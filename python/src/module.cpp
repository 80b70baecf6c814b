// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "python/src/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace setsquare::python;
  module.doc() = "The C++ library behind the package setsquare; use the package.";
  module.attr("__version__") = SETSQUARE_VERSION;
  bind_errors(module);
  bind_poses(module);
  bind_scans(module);
  bind_matching(module);
  bind_logs(module);
  bind_grids(module);
  bind_maps(module);
  bind_mapping(module);
  bind_localisation(module);
  bind_evaluation(module);
  bind_simulation(module);
}
