// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "python/src/bindings.hpp"

namespace {

PyObject* refuse_to_make(PyTypeObject* type, PyObject* /*arguments*/, PyObject* /*keywords*/) {
  PyErr_Format(
      PyExc_TypeError, "%s has no constructor: functions of setsquare make it", type->tp_name);
  return nullptr;
}

/// Whether a class was given one; pybind11 gives every other a slot that raises TypeError.
bool has_constructor(const pybind11::handle& type) {
  const pybind11::object own = type.attr("__dict__");
  if (own.contains("__setstate__")) return true;
  const pybind11::object init = own.attr("get")("__init__");
  return !init.is_none() && PyObject_TypeCheck(init.ptr(), &PyWrapperDescr_Type) == 0;
}

/// What only functions make cannot be made empty either, by `X.__new__(X)` or by copying: it would
/// be memory that nobody wrote. pybind11 itself makes its objects without __new__.
void refuse_new_where_there_is_no_constructor(const pybind11::module_& module) {
  for (const auto& [name, item] : module.attr("__dict__").cast<pybind11::dict>()) {
    if (!PyType_Check(item.ptr())) continue;
    auto* type = reinterpret_cast<PyTypeObject*>(item.ptr());
    if (PyType_IsSubtype(type, reinterpret_cast<PyTypeObject*>(PyExc_BaseException)) != 0) continue;
    if (!has_constructor(item)) type->tp_new = &refuse_to_make;
  }
}

}  // namespace

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
  refuse_new_where_there_is_no_constructor(module);
}
