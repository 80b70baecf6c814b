// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What a DecodingPlan takes out of a message; MessageDecoder makes structs of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/ros/message_definition.hpp"

namespace setsquare::ros {

/// A sequence of numbers as it stands in the message, valid as long as the message's bytes.
struct NumberArray {
  std::string_view bytes;
  Primitive type = Primitive::kFloat32;
  bool is_swapped = false;  ///< In the other byte order than this machine's.

  [[nodiscard]] std::size_t size() const { return bytes.size() / num_bytes_of(type); }
  /// Replaces what `values` held.
  void copy_to(std::vector<double>& values) const;
  /// Fills `values`, which has size() places.
  void copy_to(std::span<double> values) const;
};

/// A field's values in one message: one, or one per element where the field is a part of a
/// sequence of messages. Only the vector of the field's kind is used.
struct FieldColumn {
  std::vector<double> numbers;
  std::vector<Timestamp> times;
  std::vector<std::string_view> texts;  ///< Valid as long as the message's bytes.
  std::vector<NumberArray> arrays;

  void clear() {
    numbers.clear();
    times.clear();
    texts.clear();
    arrays.clear();
  }
};

using FieldColumns = std::vector<FieldColumn>;

}  // namespace setsquare::ros
