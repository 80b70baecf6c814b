// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_definition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare::ros {
namespace {

constexpr std::string_view kSpaces = " \t\r\v\f";
constexpr std::size_t kMaxLines = 100'000;
constexpr std::size_t kMaxTypes = 1'000;

constexpr std::array<std::pair<std::string_view, Primitive>, 19> kPrimitives = {{
    {"bool", Primitive::kBool},
    {"int8", Primitive::kInt8},
    {"byte", Primitive::kUint8},
    {"char", Primitive::kUint8},
    {"uint8", Primitive::kUint8},
    {"int16", Primitive::kInt16},
    {"uint16", Primitive::kUint16},
    {"int32", Primitive::kInt32},
    {"uint32", Primitive::kUint32},
    {"int64", Primitive::kInt64},
    {"uint64", Primitive::kUint64},
    {"float32", Primitive::kFloat32},
    {"float64", Primitive::kFloat64},
    {"time", Primitive::kTime},
    {"builtin_interfaces/Time", Primitive::kTime},
    {"duration", Primitive::kDuration},
    {"builtin_interfaces/Duration", Primitive::kDuration},
    {"string", Primitive::kText},
    {"wstring", Primitive::kWideText},
}};

/// Takes the first line off a text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Takes the first word off a line.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::size_t end = std::min(line.find_first_of(kSpaces), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

bool is_separator(std::string_view line) {
  constexpr std::size_t kMinLength = 8;
  const std::string_view word = take_word(line);
  return word.size() >= kMinLength && word.find_first_not_of('=') == std::string_view::npos;
}

bool is_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '/';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_allowed);
}

/// Splits "string<=8[<=5]" and the like; nothing where the brackets make no sense.
std::optional<FieldDefinition> field_of_type(std::string_view word) {
  FieldDefinition field;
  const std::size_t bracket = std::min(word.find('['), word.size());
  const std::string_view element = word.substr(0, bracket);
  std::string_view size = word.substr(bracket);
  field.type = plain_type_name(element.substr(0, element.find("<=")));
  if (!is_name(field.type)) return std::nullopt;
  if (size.empty()) return field;
  if (size.size() < 2 || size.back() != ']') return std::nullopt;
  size = size.substr(1, size.size() - 2);
  if (size.empty() || size.starts_with("<=")) {
    field.multiplicity = Multiplicity::kSequence;
    return field;
  }
  field.multiplicity = Multiplicity::kArray;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), number);
  if (error != std::errc{} || end != size.data() + size.size()) return std::nullopt;
  field.array_size = number;
  return field;
}

/// Reads one line of a definition into `type`; false where it is none.
bool parse_line(std::string_view line, TypeDefinition& type) {
  std::string_view rest = line.substr(0, line.find('#'));
  const std::string_view type_word = take_word(rest);
  if (type_word.empty()) return true;
  std::string_view name = take_word(rest);
  const std::size_t equals = name.find('=');
  const bool is_constant = equals != std::string_view::npos || take_word(rest).starts_with('=');
  if (is_constant) return true;
  auto field = field_of_type(type_word);
  if (!field || !is_name(name)) return false;
  field->name = name;
  type.fields.push_back(std::move(*field));
  return true;
}

bool is_interface_language(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    const std::string_view word = take_word(line);
    if (word == "IDL:" || word == "module" || word == "#include") return true;
    if (!word.empty() && !is_separator(word) && !word.starts_with('#') && !word.starts_with("//")) {
      return false;
    }
  }
  return false;
}

MessageDefinition faulty(std::string fault) {
  MessageDefinition definition;
  definition.fault = std::move(fault);
  return definition;
}

}  // namespace

std::size_t num_bytes_of(Primitive primitive) {
  constexpr std::array<std::size_t, 15> kBytes = {1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 8, 8, 4, 4};
  return kBytes[static_cast<std::size_t>(primitive)];
}

std::size_t alignment_of(Primitive primitive) {
  return is_number(primitive) ? num_bytes_of(primitive) : sizeof(std::uint32_t);
}

std::optional<Primitive> primitive_by_name(std::string_view type) {
  for (const auto& [name, primitive] : kPrimitives) {
    if (name == type) return primitive;
  }
  return std::nullopt;
}

const TypeDefinition* MessageDefinition::find(std::string_view type, std::string_view owner) const {
  const auto by_name = [this](std::string_view name) {
    const auto found = std::find_if(
        types.begin(), types.end(), [name](const TypeDefinition& t) { return t.name == name; });
    return found == types.end() ? nullptr : &*found;
  };
  if (type.find('/') != std::string_view::npos) return by_name(type);
  const std::string package(owner.substr(0, owner.find('/') + 1));
  const TypeDefinition* neighbour = by_name(package + std::string(type));
  if (neighbour != nullptr || type != "Header") return neighbour;
  const TypeDefinition* header = by_name("std_msgs/Header");
  return header != nullptr ? header : by_name("roslib/Header");
}

MessageDefinition parse_message_definition(std::string_view message_type, std::string_view text) {
  if (is_interface_language(text)) return faulty("the definition is in IDL");
  MessageDefinition definition;
  definition.types.push_back({plain_type_name(message_type), {}});
  std::size_t num_lines = 0;
  while (!text.empty()) {
    if (++num_lines > kMaxLines || definition.types.size() > kMaxTypes) {
      return faulty("the definition is too long");
    }
    std::string_view line = take_line(text);
    if (is_separator(line)) {
      line = take_line(text);
      if (take_word(line) != "MSG:") return faulty("the definition has a part without \"MSG:\"");
      definition.types.push_back({plain_type_name(take_word(line)), {}});
      continue;
    }
    if (!parse_line(line, definition.types.back())) {
      return faulty("the definition of " + definition.types.back().name +
                    " has a line that is no field");
    }
  }
  return definition;
}

}  // namespace setsquare::ros
