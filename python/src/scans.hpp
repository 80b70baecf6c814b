// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

#include "setsquare/scan/scan.hpp"

namespace setsquare::python {

/// The scan that an argument is: a Scan, or an array of ranges (m) over `fov_deg`, 180 where
/// nothing is given. Throws ParameterError.
[[nodiscard]] std::shared_ptr<const Scan> scan_from(const pybind11::object& object,
                                                    const std::optional<double>& fov_deg);

}  // namespace setsquare::python
