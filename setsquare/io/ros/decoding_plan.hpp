// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/ros/field_columns.hpp"
#include "setsquare/io/ros/message_definition.hpp"
#include "setsquare/io/ros/wire_reader.hpp"

namespace setsquare::ros {

enum class FieldKind : std::uint8_t {
  kNumber,  ///< Any bool, integer or float.
  kTime,    ///< A stamp.
  kText,
  kArray,  ///< An array or a sequence of numbers.
};

/// A field that is wanted, by its path from the message down: "header.stamp",
/// "transforms.transform.rotation.w".
struct WantedField {
  std::string path;
  FieldKind kind = FieldKind::kNumber;
};

/// A message's definition and encoding, compiled once into steps over its bytes: "skip 16 bytes;
/// read the float64 into column 3; skip a string; take a sequence of float32 into column 7".
class DecodingPlan {
 public:
  /// Fails, and says why in fault(), where a wanted field is missing or of another kind, a part has
  /// no definition, or the definition contains itself or is too large.
  DecodingPlan(const MessageDefinition& definition,
               MessageEncoding encoding,
               std::span<const WantedField> wanted);

  /// Why no message can be decoded; empty if the plan is good.
  [[nodiscard]] const std::string& fault() const { return fault_; }

  /// Walks over a whole message and fills a column per wanted field; memory of the last message is
  /// used again. The result is empty, or says why the message cannot be read.
  [[nodiscard]] std::string_view run(std::string_view message, FieldColumns& columns) const;

 private:
  friend class PlanCompiler;

  enum class Action : std::uint8_t {
    kSkip,  ///< `size` bytes.
    kSkipText,
    kSkipArray,  ///< Elements of `size` bytes each.
    kNumber,
    kTime,
    kText,
    kArray,
    kRepeat,  ///< The `size` steps behind it, once per element of at least `min_bytes` bytes.
  };
  static constexpr std::size_t kCountInMessage = std::numeric_limits<std::size_t>::max();

  struct Step {
    Action action = Action::kSkip;
    Primitive type = Primitive::kUint8;
    std::size_t alignment = 1;
    std::size_t size = 0;
    std::size_t num_elements = kCountInMessage;
    std::size_t min_bytes = 0;
    std::size_t column = 0;
  };

  [[nodiscard]] static std::size_t num_elements_of(const Step& step,
                                                   std::size_t min_element_bytes,
                                                   WireReader& bytes);
  void run_steps(std::size_t begin,
                 std::size_t end,
                 WireReader& bytes,
                 FieldColumns& columns) const;
  void run_step(const Step& step, WireReader& bytes, FieldColumns& columns) const;
  void repeat(std::size_t repeat_step, WireReader& bytes, FieldColumns& columns) const;

  MessageEncoding encoding_;
  std::size_t num_columns_;
  std::vector<Step> steps_;
  std::string fault_;
};

}  // namespace setsquare::ros
