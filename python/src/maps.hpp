// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "setsquare/pipeline/map_log.hpp"

namespace setsquare::python {

/// A map as Python holds it: with what is known of the log that it was made of, if it was one.
struct PyMap {
  std::shared_ptr<const MappedLog> mapped;

  [[nodiscard]] const Map& map() const { return mapped->map; }
};

}  // namespace setsquare::python
