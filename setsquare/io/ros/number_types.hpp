// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// From a primitive's name to the type that holds it, in one place for single numbers and sequences.
#pragma once

#include <cstdint>

#include "setsquare/io/ros/message_definition.hpp"

namespace setsquare::ros {

/// Calls `action` with a zero of the type that a number primitive has on the wire.
template <typename Action>
auto visit_number_type(Primitive number, const Action& action) {
  switch (number) {
    case Primitive::kInt8:
      return action(std::int8_t{});
    case Primitive::kInt16:
      return action(std::int16_t{});
    case Primitive::kUint16:
      return action(std::uint16_t{});
    case Primitive::kInt32:
      return action(std::int32_t{});
    case Primitive::kUint32:
      return action(std::uint32_t{});
    case Primitive::kInt64:
      return action(std::int64_t{});
    case Primitive::kUint64:
      return action(std::uint64_t{});
    case Primitive::kFloat32:
      return action(float{});
    case Primitive::kFloat64:
      return action(double{});
    default:
      return action(std::uint8_t{});  // kBool, kUint8
  }
}

}  // namespace setsquare::ros
