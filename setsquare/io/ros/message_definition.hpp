// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace setsquare::ros {

/// What a field's type is made of when it is no message.
enum class Primitive : std::uint8_t {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kTime,      ///< Seconds and nanoseconds: "time", "builtin_interfaces/Time".
  kDuration,  ///< The same: "duration", "builtin_interfaces/Duration".
  kText,      ///< "string".
  kWideText,  ///< "wstring": characters of four bytes.
};

[[nodiscard]] constexpr bool is_number(Primitive primitive) {
  return primitive <= Primitive::kFloat64;
}

/// How many bytes a value takes; of a text those of its length, of which it has at least these.
[[nodiscard]] std::size_t num_bytes_of(Primitive primitive);

/// What a value's position in a CDR message is a multiple of.
[[nodiscard]] std::size_t alignment_of(Primitive primitive);

/// The primitive of this name, in the words of ROS 1 or 2; nothing where it is a message's.
[[nodiscard]] std::optional<Primitive> primitive_by_name(std::string_view type);

enum class Multiplicity : std::uint8_t {
  kOne,       ///< float64 x
  kArray,     ///< float64[9] x: no count in the message.
  kSequence,  ///< float64[] x, float64[<=9] x: the message tells how many.
};

/// One line of a definition.
struct FieldDefinition {
  std::string type;  ///< "float32", "geometry_msgs/Point", "Header"; without bounds and "/msg/".
  std::string name;
  Multiplicity multiplicity = Multiplicity::kOne;
  std::size_t array_size = 1;  ///< Of kArray.
};

struct TypeDefinition {
  std::string name;  ///< "sensor_msgs/LaserScan".
  std::vector<FieldDefinition> fields;
};

/// A message's definition with those of its parts, as recordings carry it: the `.msg` files behind
/// one another, each but the first under a line of '=' and a line "MSG: package/Type".
struct MessageDefinition {
  std::vector<TypeDefinition> types;  ///< The first is the message's own.
  std::string fault;                  ///< Why the text is no definition; empty if it is one.

  /// The type that a field of `owner` means: itself a full name, one of owner's package, or
  /// "Header" for std_msgs/Header, which was roslib/Header until 2010. Null where the definition
  /// does not hold it.
  [[nodiscard]] const TypeDefinition* find(std::string_view type, std::string_view owner) const;
};

/// Reads a definition. Constants, comments, default values and bounds are passed over: they do not
/// stand in messages. At most 100,000 lines and 1,000 parts.
[[nodiscard]] MessageDefinition parse_message_definition(std::string_view message_type,
                                                         std::string_view text);

}  // namespace setsquare::ros
