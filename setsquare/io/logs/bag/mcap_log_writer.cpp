// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/mcap_log_writer.hpp"

#include "setsquare/io/ros/builtin_definitions.hpp"

namespace setsquare {

MessageSink::Channel McapLogWriter::add_channel(const std::string& topic,
                                                const std::string& type,
                                                bool is_latched) {
  return file_.add_channel(topic,
                           type,
                           ros::builtin_definition(plain_type_name(type), MessageEncoding::kCdr),
                           is_latched);
}

}  // namespace setsquare
