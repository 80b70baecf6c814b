// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "setsquare/pipeline/map_log.hpp"

namespace setsquare::python {

/// A map as Python holds it: with what is known of its making.
struct PyMap {
  explicit PyMap(SavedMap map) : saved(std::make_shared<const SavedMap>(std::move(map))) {}
  explicit PyMap(MappedLog mapped)
      : PyMap(SavedMap{.map = std::move(mapped.map), .record = map_record_of(mapped)}) {}

  [[nodiscard]] const Map& map() const { return saved->map; }

  std::shared_ptr<const SavedMap> saved;
};

}  // namespace setsquare::python
