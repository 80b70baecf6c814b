// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A writer and a reader of fields, apart from fields: what is written and what is read is the same
// list.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "setsquare/io/bytes/byte_cursor.hpp"
#include "setsquare/io/bytes/byte_writer.hpp"
#include "setsquare/io/map_file/range_packing.hpp"

namespace setsquare::map_file {

/// The last value of an enum that a map file holds; its values are stored as one byte.
template <typename Enum>
inline constexpr Enum kLastOf = Enum::kNoLastValueIsNamed;

/// How each kind of value is stored: numbers as they are, counts and lengths as 64 bits, enums and
/// truth values as a byte, optional ones behind a byte that says whether they are there. A struct
/// is what describe() lists.
class FieldWriter {
 public:
  template <typename... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }

  /// The ranges of a scan, without a loss.
  void ranges(const std::vector<double>& ranges_m) { append_packed_ranges(bytes_, ranges_m); }

  [[nodiscard]] std::string take() { return bytes_.take(); }

 private:
  template <typename Value>
  void put(const Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      bytes_.write(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_enum_v<Value>) {
      assert(value <= kLastOf<Value>);
      bytes_.write(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_arithmetic_v<Value>) {
      static_assert(sizeof(Value) <= sizeof(std::uint64_t), "no long double");
      bytes_.write(value);
    } else {
      describe(*this, value);
    }
  }
  void put(const std::string& text) {
    bytes_.write(std::uint64_t{text.size()});
    bytes_.append(text);
  }
  template <int Rows, int Columns>
  void put(const Eigen::Matrix<double, Rows, Columns>& matrix) {
    for (const double value : matrix.reshaped()) bytes_.write(value);
  }
  template <typename Value>
  void put(const std::shared_ptr<const Value>& value) {
    put(*value);
  }
  template <typename Value>
  void put(const std::optional<Value>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <typename Value>
  void put(const std::vector<Value>& values) {
    bytes_.write(std::uint64_t{values.size()});
    for (const Value& value : values) put(value);
  }
  template <typename Key, typename Value>
  void put(const std::map<Key, Value>& values) {
    bytes_.write(std::uint64_t{values.size()});
    for (const auto& [key, value] : values) (*this)(key, value);
  }

  ByteWriter bytes_;
};

/// Reads what FieldWriter wrote. Bytes of any other kind do no harm: the first fault is kept, and
/// all that follows is empty. Memory grows only as bytes are there to fill it.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : cursor_(bytes), num_bytes_(bytes.size()) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }

  void ranges(std::vector<double>& ranges_m) {
    if (!has_fault() && !read_packed_ranges(cursor_, ranges_m)) fault_ = "a scan's ranges";
  }

  /// What the bytes hold in place of a value, empty where nothing is wrong; to be asked at the end.
  [[nodiscard]] std::string fault() const {
    if (!fault_.empty()) return fault_;
    if (cursor_.is_short()) return "too few bytes";
    return cursor_.position() < num_bytes_ ? "too many bytes" : "";
  }

 private:
  [[nodiscard]] bool has_fault() const { return cursor_.is_short() || !fault_.empty(); }

  template <typename Value>
  void get(Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      value = read_byte_up_to(1) != 0;
    } else if constexpr (std::is_enum_v<Value>) {
      value = static_cast<Value>(read_byte_up_to(static_cast<std::uint8_t>(kLastOf<Value>)));
    } else if constexpr (std::is_arithmetic_v<Value>) {
      value = cursor_.read<Value>();
    } else {
      describe(*this, value);
    }
  }
  void get(std::string& text) { text = cursor_.take(read_count()); }
  template <int Rows, int Columns>
  void get(Eigen::Matrix<double, Rows, Columns>& matrix) {
    for (double& value : matrix.reshaped()) value = cursor_.read<double>();
  }
  template <typename Value>
  void get(std::shared_ptr<const Value>& value) {
    const auto made = std::make_shared<Value>();
    get(*made);
    value = made;
  }
  template <typename Value>
  void get(std::optional<Value>& value) {
    bool is_there = false;
    get(is_there);
    if (is_there) get(value.emplace());
  }
  template <typename Value>
  void get(std::vector<Value>& values) {
    const std::size_t count = read_count();
    values.clear();
    for (std::size_t i = 0; i < count && !has_fault(); ++i) get(values.emplace_back());
  }
  template <typename Key, typename Value>
  void get(std::map<Key, Value>& values) {
    const std::size_t count = read_count();
    values.clear();
    for (std::size_t i = 0; i < count && !has_fault(); ++i) {
      Key key{};
      get(key);
      if (!values.empty() && key <= values.rbegin()->first) fault_ = "keys out of order";
      get(values[key]);
    }
  }

  std::uint8_t read_byte_up_to(std::uint8_t last) {
    const auto byte = cursor_.read<std::uint8_t>();
    if (byte <= last) return byte;
    if (fault_.empty()) fault_ = "a value that this Setsquare does not know";
    return 0;
  }

  /// A count of things that take a byte each, at least: no more than there are bytes left.
  std::size_t read_count() {
    const auto count = cursor_.read<std::uint64_t>();
    if (!has_fault() && count <= num_bytes_ - cursor_.position()) {
      return static_cast<std::size_t>(count);
    }
    if (fault_.empty()) fault_ = "a count of more than its bytes can hold";
    return 0;
  }

  ByteCursor cursor_;
  std::size_t num_bytes_;
  std::string fault_;
};

}  // namespace setsquare::map_file
