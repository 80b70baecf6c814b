// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <utility>

#include "python/src/conversions.hpp"

namespace setsquare::python {

/// An object that several threads of Python may use: they take turns.
template <typename Object>
class Guarded {
 public:
  explicit Guarded(Object object) : object_(std::move(object)) {}

  /// Calls `function` with the object while no other thread does, with Python's interpreter free.
  template <typename Function>
  auto with(Function function) {
    return without_gil([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return function(object_);
    });
  }

 private:
  std::mutex mutex_;
  Object object_;
};

}  // namespace setsquare::python
