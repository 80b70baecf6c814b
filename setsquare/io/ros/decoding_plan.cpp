// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/decoding_plan.hpp"

#include <algorithm>
#include <optional>

#include "setsquare/io/ros/number_types.hpp"

namespace setsquare::ros {
namespace {

constexpr std::size_t kMaxDepth = 24;
constexpr std::size_t kMaxFieldsVisited = 20'000;

std::size_t product_up_to_limit(std::size_t a, std::size_t b) {
  constexpr std::size_t kLimit = std::size_t{1} << 40U;
  return b != 0 && a > kLimit / b ? kLimit : std::min(a * b, kLimit);
}

FieldKind kind_of(Primitive primitive) {
  if (is_number(primitive)) return FieldKind::kNumber;
  return primitive == Primitive::kTime ? FieldKind::kTime : FieldKind::kText;
}

/// ROS 1 counts seconds without a sign. Nanoseconds above a second carry over.
Timestamp read_time(WireReader& bytes, MessageEncoding encoding) {
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  const auto raw_seconds = bytes.read<std::uint32_t>();
  const auto nanoseconds = bytes.read<std::uint32_t>();
  const std::int64_t seconds = encoding == MessageEncoding::kRos1
                                   ? std::int64_t{raw_seconds}
                                   : std::int64_t{static_cast<std::int32_t>(raw_seconds)};
  return {seconds * kNanosecondsPerSecond + std::int64_t{nanoseconds}};
}

double read_number(WireReader& bytes, Primitive type) {
  return visit_number_type(
      type, [&bytes](auto zero) { return static_cast<double>(bytes.read<decltype(zero)>()); });
}

}  // namespace

/// Goes through a definition in the order of the message's bytes and notes the steps.
class PlanCompiler {
 public:
  PlanCompiler(DecodingPlan& plan,
               const MessageDefinition& definition,
               std::span<const WantedField> wanted)
      : plan_(plan), definition_(definition), wanted_(wanted), is_found_(wanted.size(), false) {}

  void compile() {
    plan_.fault_ = definition_.fault;
    if (!has_failed()) add_type(definition_.types.front(), "", 0);
    for (std::size_t i = 0; i < wanted_.size() && !has_failed(); ++i) {
      if (!is_found_[i]) fail("has no field " + wanted_[i].path);
    }
    if (has_failed()) plan_.steps_.clear();
  }

 private:
  using Action = DecodingPlan::Action;
  using Step = DecodingPlan::Step;

  [[nodiscard]] bool has_failed() const { return !plan_.fault_.empty(); }

  void fail(const std::string& what) {
    const std::string& message_type = definition_.types.front().name;
    if (!has_failed()) plan_.fault_ = "the definition of " + message_type + " " + what;
  }

  void add_type(const TypeDefinition& type, const std::string& path, std::size_t depth) {
    if (depth > kMaxDepth) return fail("contains itself, or parts in parts without end");
    if (type.fields.empty() && plan_.encoding_ == MessageEncoding::kCdr) {
      skip(1, 1);  // ROS 2 puts a byte where a message has no field.
    }
    for (const FieldDefinition& field : type.fields) {
      if (++num_visited_ > kMaxFieldsVisited) return fail("has too many fields");
      add_field(field, type, path + field.name, depth);
      if (has_failed()) return;
    }
  }

  void add_field(const FieldDefinition& field,
                 const TypeDefinition& owner,
                 const std::string& path,
                 std::size_t depth) {
    if (const auto primitive = primitive_by_name(field.type)) {
      return add_primitive(field, *primitive, path);
    }
    const TypeDefinition* type = definition_.find(field.type, owner.name);
    if (type == nullptr) return fail("lacks that of its part " + field.type);
    if (field.multiplicity == Multiplicity::kOne) return add_type(*type, path + ".", depth + 1);
    const std::size_t repeat = begin_repeat(field);
    add_type(*type, path + ".", depth + 1);
    end_repeat(repeat);
  }

  void add_primitive(const FieldDefinition& field, Primitive type, const std::string& path) {
    const bool is_one = field.multiplicity == Multiplicity::kOne;
    const auto column =
        column_of(path, is_one || !is_number(type) ? kind_of(type) : FieldKind::kArray);
    if (has_failed()) return;
    if (is_one) return add_value(type, column);
    if (type == Primitive::kText || type == Primitive::kWideText || (column && !is_number(type))) {
      const std::size_t repeat = begin_repeat(field);
      add_value(type, column);
      return end_repeat(repeat);
    }
    add({.action = column ? Action::kArray : Action::kSkipArray,
         .type = type,
         .alignment = alignment(type),
         .size = num_bytes_of(type),
         .num_elements = num_elements(field),
         .column = column.value_or(0)});
  }

  void add_value(Primitive type, std::optional<std::size_t> column) {
    constexpr std::size_t kWideCharacterBytes = 4;
    if (type == Primitive::kWideText) {
      return add({.action = Action::kSkipArray,
                  .alignment = alignment(type),
                  .size = kWideCharacterBytes});
    }
    if (type == Primitive::kText) {
      return add(
          {.action = column ? Action::kText : Action::kSkipText, .column = column.value_or(0)});
    }
    if (!column) return skip(alignment(type), num_bytes_of(type));
    add({.action = is_number(type) ? Action::kNumber : Action::kTime,
         .type = type,
         .column = *column});
  }

  /// Bytes that are skipped one behind the other become one step where no gap can be between them.
  void skip(std::size_t alignment, std::size_t num_bytes) {
    const bool may_join = plan_.steps_.size() > num_closed_;
    Step* last = may_join ? &plan_.steps_.back() : nullptr;
    if (last != nullptr && last->action == Action::kSkip && last->alignment >= alignment &&
        last->size % alignment == 0) {
      last->size += num_bytes;
      return;
    }
    add({.action = Action::kSkip, .alignment = alignment, .size = num_bytes});
  }

  std::size_t begin_repeat(const FieldDefinition& field) {
    add({.action = Action::kRepeat, .num_elements = num_elements(field)});
    num_closed_ = plan_.steps_.size();
    return num_closed_ - 1;
  }

  void end_repeat(std::size_t repeat) {
    std::vector<Step>& steps = plan_.steps_;
    steps[repeat].size = steps.size() - repeat - 1;
    steps[repeat].min_bytes = min_bytes(repeat + 1, steps.size());
    const bool takes_bytes = min_bytes(steps[repeat]) > 0;
    if (!takes_bytes) steps.resize(repeat);
    num_closed_ = steps.size();
  }

  /// Each step takes bytes, so that a message's length bounds the work on it.
  void add(const Step& step) {
    if (step.action == Action::kRepeat || min_bytes(step) > 0) plan_.steps_.push_back(step);
  }

  [[nodiscard]] std::size_t alignment(Primitive type) const {
    return plan_.encoding_ == MessageEncoding::kCdr ? alignment_of(type) : 1;
  }

  [[nodiscard]] static std::size_t num_elements(const FieldDefinition& field) {
    return field.multiplicity == Multiplicity::kArray ? field.array_size
                                                      : DecodingPlan::kCountInMessage;
  }

  /// The column of a wanted field; nothing where the field is not wanted.
  std::optional<std::size_t> column_of(const std::string& path, FieldKind kind) {
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (wanted_[i].path != path || is_found_[i]) continue;
      if (wanted_[i].kind != kind) fail("has a field " + path + " of another kind");
      is_found_[i] = true;
      return i;
    }
    return std::nullopt;
  }

  /// The fewest bytes that these steps take.
  [[nodiscard]] std::size_t min_bytes(std::size_t begin, std::size_t end) const {
    std::size_t sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Step& step = plan_.steps_[i];
      sum += min_bytes(step);
      if (step.action == Action::kRepeat) i += step.size;
    }
    return sum;
  }

  [[nodiscard]] static std::size_t min_bytes(const Step& step) {
    constexpr std::size_t kCountBytes = sizeof(std::uint32_t);
    switch (step.action) {
      case Action::kSkip:
        return step.size;
      case Action::kNumber:
      case Action::kTime:
        return num_bytes_of(step.type);
      case Action::kText:
      case Action::kSkipText:
        return kCountBytes;
      default:
        break;
    }
    if (step.num_elements == DecodingPlan::kCountInMessage) return kCountBytes;
    const bool is_repeat = step.action == Action::kRepeat;
    return product_up_to_limit(step.num_elements, is_repeat ? step.min_bytes : step.size);
  }

  DecodingPlan& plan_;
  const MessageDefinition& definition_;
  std::span<const WantedField> wanted_;
  std::vector<bool> is_found_;
  std::size_t num_visited_ = 0;
  std::size_t num_closed_ = 0;  ///< Steps before this one belong to a finished or another block.
};

DecodingPlan::DecodingPlan(const MessageDefinition& definition,
                           MessageEncoding encoding,
                           std::span<const WantedField> wanted)
    : encoding_(encoding), num_columns_(wanted.size()) {
  PlanCompiler(*this, definition, wanted).compile();
}

std::string_view DecodingPlan::run(std::string_view message, FieldColumns& columns) const {
  if (!fault_.empty()) return fault_;
  columns.resize(num_columns_);
  for (FieldColumn& column : columns) column.clear();
  WireReader bytes(message, encoding_);
  run_steps(0, steps_.size(), bytes, columns);
  return bytes.failure();
}

void DecodingPlan::run_steps(std::size_t begin,
                             std::size_t end,
                             WireReader& bytes,
                             FieldColumns& columns) const {
  for (std::size_t i = begin; i < end && !bytes.has_failed(); ++i) {
    if (steps_[i].action != Action::kRepeat) {
      run_step(steps_[i], bytes, columns);
    } else {
      repeat(i, bytes, columns);
      i += steps_[i].size;
    }
  }
}

void DecodingPlan::repeat(std::size_t repeat_step, WireReader& bytes, FieldColumns& columns) const {
  const Step& step = steps_[repeat_step];
  const std::size_t num_elements = num_elements_of(step, step.min_bytes, bytes);
  if (step.min_bytes == 0) return;  // Elements without bytes leave nothing to read.
  const std::size_t begin = repeat_step + 1;
  for (std::size_t i = 0; i < num_elements && !bytes.has_failed(); ++i) {
    run_steps(begin, begin + step.size, bytes, columns);
  }
}

std::size_t DecodingPlan::num_elements_of(const Step& step,
                                          std::size_t min_element_bytes,
                                          WireReader& bytes) {
  if (step.num_elements == kCountInMessage) return bytes.read_count(min_element_bytes);
  return bytes.has_room_for(step.num_elements, min_element_bytes) ? step.num_elements : 0;
}

void DecodingPlan::run_step(const Step& step, WireReader& bytes, FieldColumns& columns) const {
  switch (step.action) {
    case Action::kSkip:
      return bytes.skip(step.alignment, step.size);
    case Action::kNumber:
      return columns[step.column].numbers.push_back(read_number(bytes, step.type));
    case Action::kTime:
      return columns[step.column].times.push_back(read_time(bytes, encoding_));
    case Action::kSkipText:
      return static_cast<void>(bytes.read_text());
    case Action::kText:
      return columns[step.column].texts.push_back(bytes.read_text());
    default:
      break;
  }
  const std::size_t num_elements = num_elements_of(step, step.size, bytes);
  if (step.action == Action::kSkipArray) {
    if (num_elements > 0) bytes.skip(step.alignment, num_elements * step.size);
    return;
  }
  columns[step.column].arrays.push_back(
      {bytes.read_array(num_elements, step.size), step.type, bytes.is_swapped()});
}

}  // namespace setsquare::ros
