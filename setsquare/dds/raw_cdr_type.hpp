// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from participant.cpp, its only caller: how the DDS library carries bytes that it does not
// look at.
#pragma once

#include <cstdint>
#include <cstring>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <string>

#include "setsquare/dds/participant.hpp"

namespace setsquare::dds {

/// A type whose messages are strings of CDR, header included.
class RawCdrType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  explicit RawCdrType(const std::string& name) {
    constexpr std::uint32_t kUsualBytes = 4096;  // More is allocated as it comes.
    setName(name.c_str());
    m_typeSize = kUsualBytes;
    m_isGetKeyDefined = false;
    auto_fill_type_information(false);
    auto_fill_type_object(false);
  }

  bool serialize(void* data, Payload* payload) override {
    const std::string& message = *static_cast<std::string*>(data);
    if (message.size() > payload->max_size) return false;
    std::memcpy(payload->data, message.data(), message.size());
    payload->length = static_cast<std::uint32_t>(message.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  /// A message that is none, or too large, becomes empty: whoever takes it counts it.
  bool deserialize(Payload* payload, void* data) override {
    std::string& message = *static_cast<std::string*>(data);
    message.clear();
    if (payload->length >= 4 && payload->length <= Participant::kMaxMessageBytes) {
      message.assign(reinterpret_cast<const char*>(payload->data), payload->length);
    }
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    const auto num_bytes =
        static_cast<std::uint32_t>(static_cast<const std::string*>(data)->size());
    return [num_bytes] { return num_bytes; };
  }
  void* createData() override { return new std::string; }
  void deleteData(void* data) override { delete static_cast<std::string*>(data); }
  bool getKey(void* /*data*/,
              eprosima::fastrtps::rtps::InstanceHandle_t* /*handle*/,
              bool /*force_md5*/) override {
    return false;
  }
};

}  // namespace setsquare::dds
