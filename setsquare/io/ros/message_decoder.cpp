// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_decoder.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/io/ros/builtin_definitions.hpp"
#include "setsquare/io/ros/message_fields.hpp"

namespace setsquare::ros {
namespace {

constexpr std::array<std::string_view, 4> kCoordinates = {"x", "y", "z", "w"};
constexpr std::size_t kNumVectorFields = 3;
constexpr std::size_t kNumQuaternionFields = 4;

/// Collects the fields that a struct is filled from, in the order of its visit.
class FieldCollector {
 public:
  void field(std::string_view path, const double&) { add(path, FieldKind::kNumber); }
  void field(std::string_view path, const bool&) { add(path, FieldKind::kNumber); }
  void field(std::string_view path, const std::uint32_t&) { add(path, FieldKind::kNumber); }
  void field(std::string_view path, const Timestamp&) { add(path, FieldKind::kTime); }
  void field(std::string_view path, const std::string&) { add(path, FieldKind::kText); }
  void field(std::string_view path, const Eigen::Vector3d&) { add_parts(path, kNumVectorFields); }
  void field(std::string_view path, const Eigen::Quaterniond&) {
    add_parts(path, kNumQuaternionFields);
  }
  template <typename Numbers>
  void field(std::string_view path, const Numbers&) {
    add(path, FieldKind::kArray);
  }

  template <typename Element>
  void list(std::string_view path, const std::vector<Element>&) {
    Element element;
    const std::string prefix = std::exchange(prefix_, prefix_ + std::string(path) + ".");
    visit_fields(*this, element);
    prefix_ = prefix;
  }

  [[nodiscard]] const std::vector<WantedField>& fields() const { return fields_; }

 private:
  void add(std::string_view path, FieldKind kind) {
    fields_.push_back({prefix_ + std::string(path), kind});
  }
  void add_parts(std::string_view path, std::size_t num_parts) {
    for (std::size_t i = 0; i < num_parts; ++i) {
      add(std::string(path).append(".").append(kCoordinates[i]), FieldKind::kNumber);
    }
  }

  std::string prefix_;
  std::vector<WantedField> fields_;
};

template <typename Struct>
std::vector<WantedField> wanted_fields() {
  FieldCollector collector;
  Struct any;
  visit_fields(collector, any);
  return collector.fields();
}

/// Fills a struct from the columns, which stand in the order of its visit.
class FieldFiller {
 public:
  explicit FieldFiller(const FieldColumns& columns) : columns_(columns) {}

  void field(std::string_view, double& value) { value = next_number(); }
  void field(std::string_view, bool& value) { value = next_number() != 0.0; }
  void field(std::string_view, std::uint32_t& value) {
    // A recording may define the field as any type of number.
    constexpr double kMax = std::numeric_limits<std::uint32_t>::max();
    const double number = next_number();
    value = number >= 0.0 && number <= kMax ? static_cast<std::uint32_t>(number) : 0;
  }
  void field(std::string_view, Timestamp& value) {
    value = element_of(columns_[next_++].times, Timestamp{});
  }
  void field(std::string_view, std::string& value) {
    value = element_of(columns_[next_++].texts, std::string_view{});
  }
  void field(std::string_view, Eigen::Vector3d& value) {
    for (int i = 0; i < value.size(); ++i) value[i] = next_number();
  }
  void field(std::string_view, Eigen::Quaterniond& value) {
    for (int i = 0; i < value.coeffs().size(); ++i) value.coeffs()[i] = next_number();  // x y z w
  }
  void field(std::string_view, NumberArray& value) { value = next_array(); }
  void field(std::string_view, std::vector<double>& value) { next_array().copy_to(value); }
  void field(std::string_view, std::vector<std::int8_t>& value) {
    const NumberArray numbers = next_array();
    if (num_bytes_of(numbers.type) != 1) is_incomplete_ = true;
    value.assign(numbers.bytes.begin(), numbers.bytes.end());
  }
  void field(std::string_view, std::array<double, 9>& value) {
    const NumberArray numbers = next_array();
    if (numbers.size() == value.size()) {
      numbers.copy_to(std::span<double>(value));
    } else {
      is_incomplete_ = true;
    }
  }
  void field(std::string_view, std::vector<NumberArray>& value) {
    value = columns_[next_++].arrays;
  }

  template <typename Element>
  void list(std::string_view, std::vector<Element>& elements) {
    static const std::size_t kNumColumns = wanted_fields<Element>().size();
    const std::size_t first = next_;
    elements.resize(num_values(columns_[first]));
    for (element_ = 0; element_ < elements.size(); ++element_) {
      next_ = first;
      visit_fields(*this, elements[element_]);
    }
    element_ = 0;
    next_ = first + kNumColumns;
  }

  /// Whether a field had fewer values than the struct has places.
  [[nodiscard]] bool is_incomplete() const { return is_incomplete_; }

 private:
  static std::size_t num_values(const FieldColumn& column) {
    return std::max({column.numbers.size(), column.times.size(), column.texts.size()});
  }

  template <typename Value>
  Value element_of(const std::vector<Value>& values, Value otherwise) {
    if (element_ < values.size()) return values[element_];
    is_incomplete_ = true;
    return otherwise;
  }
  double next_number() { return element_of(columns_[next_++].numbers, 0.0); }
  NumberArray next_array() { return element_of(columns_[next_++].arrays, NumberArray{}); }

  const FieldColumns& columns_;
  std::size_t next_ = 0;
  std::size_t element_ = 0;
  bool is_incomplete_ = false;
};

/// A plan for the topic's own definition, or for the well-known one where that cannot be read.
DecodingPlan plan_for(const MessageTopic& topic,
                      const std::vector<WantedField>& wanted,
                      std::string& remark) {
  if (!topic.definition.empty()) {
    const auto own = parse_message_definition(topic.type, topic.definition);
    if (own.fault.empty()) return {own, topic.encoding, wanted};
    remark = own.fault + "; the well-known one of " + plain_type_name(topic.type) + " is used";
  }
  const std::string text = builtin_definition(topic.type, topic.encoding);
  auto builtin = parse_message_definition(topic.type, text);
  if (text.empty()) builtin.fault = "the recording has no definition of " + topic.type;
  return {builtin, topic.encoding, wanted};
}

}  // namespace

template <typename MessageType>
MessageDecoder<MessageType>::MessageDecoder(const MessageTopic& topic)
    : plan_(plan_for(topic, wanted_fields<MessageType>(), remark_)) {}

template <typename MessageType>
std::string_view MessageDecoder<MessageType>::decode(std::string_view data, MessageType& message) {
  const std::string_view fault = plan_.run(data, columns_);
  if (!fault.empty()) return fault;
  FieldFiller filler(columns_);
  visit_fields(filler, message);
  return filler.is_incomplete() ? "a field has too few values" : std::string_view{};
}

template class MessageDecoder<LaserScan>;
template class MessageDecoder<MultiEchoLaserScan>;
template class MessageDecoder<PointCloud2>;
template class MessageDecoder<Odometry>;
template class MessageDecoder<PoseStamped>;
template class MessageDecoder<PoseWithCovarianceStamped>;
template class MessageDecoder<Imu>;
template class MessageDecoder<TfMessage>;
template class MessageDecoder<Path>;
template class MessageDecoder<OccupancyGrid>;

}  // namespace setsquare::ros
