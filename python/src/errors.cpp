// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// C++ exceptions as Python's, with the same words.
#include "python/src/bindings.hpp"
#include "setsquare/core/error.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// A Python exception class that is both an Error and one of Python's own.
py::object exception_class(py::module_& module,
                           const char* name,
                           const py::tuple& bases,
                           const char* doc) {
  const std::string qualified = std::string("setsquare.") + name;
  auto made = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(qualified.c_str(), doc, bases.ptr(), nullptr));
  if (!made) throw py::error_already_set();
  module.attr(name) = made;
  return made;
}

// Kept for the life of the process, as the translator is.
PyObject* error_class = nullptr;
PyObject* file_error_class = nullptr;
PyObject* format_error_class = nullptr;
PyObject* parameter_error_class = nullptr;

}  // namespace

void bind_errors(py::module_& module) {
  const py::object base = exception_class(module,
                                          "Error",
                                          py::make_tuple(py::handle(PyExc_Exception)),
                                          "A file, option or parameter that cannot be used.");
  const auto derive = [&](const char* name, PyObject* builtin, const char* doc) {
    return exception_class(module, name, py::make_tuple(base, py::handle(builtin)), doc)
        .release()
        .ptr();
  };
  file_error_class =
      derive("FileError", PyExc_OSError, "A file that cannot be opened, read or written.");
  format_error_class = derive(
      "FormatError", PyExc_ValueError, "A file whose content is not what its format demands.");
  parameter_error_class =
      derive("ParameterError", PyExc_ValueError, "A parameter outside its domain.");
  error_class = py::object(base).release().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FileError& error) {
      PyErr_SetString(file_error_class, error.what());
    } catch (const FormatError& error) {
      PyErr_SetString(format_error_class, error.what());
    } catch (const ParameterError& error) {
      PyErr_SetString(parameter_error_class, error.what());
    } catch (const Error& error) {
      PyErr_SetString(error_class, error.what());
    }
  });
}

}  // namespace setsquare::python
