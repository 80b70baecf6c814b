// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare::python {

/// The options of a log from keywords, as read_log documents them. Throws TypeError for a keyword
/// that is none, ParameterError.
[[nodiscard]] LogOptions log_options_from(const pybind11::kwargs& options);

/// One path, or those of a list.
[[nodiscard]] std::vector<std::string> paths_from(const pybind11::object& path);

}  // namespace setsquare::python
