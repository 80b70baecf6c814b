// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/field_columns.hpp"

#include <cstring>

#include "setsquare/io/ros/number_types.hpp"
#include "setsquare/io/ros/wire_reader.hpp"

namespace setsquare::ros {
namespace {

/// A loop without branches but the one on the byte order, which the compiler takes out of it.
template <typename Number>
void widen(std::string_view bytes, bool is_swapped, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Number number;
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    values[i] = static_cast<double>(is_swapped ? with_bytes_reversed(number) : number);
  }
}

}  // namespace

void NumberArray::copy_to(std::vector<double>& values) const {
  values.resize(size());
  copy_to(std::span<double>(values));
}

void NumberArray::copy_to(std::span<double> values) const {
  visit_number_type(
      type, [this, values](auto zero) { widen<decltype(zero)>(bytes, is_swapped, values); });
}

}  // namespace setsquare::ros
