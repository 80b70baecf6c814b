// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare::ros {

/// The definition of a well-known message, in the form that recordings carry (with those of its
/// parts), for ROS 1 or ROS 2: they differ in how a time is written and in the header's `seq`.
/// For recordings without definitions, and for the schemas of those that we write. Empty for a type
/// that is not among messages.hpp's.
[[nodiscard]] std::string builtin_definition(std::string_view type, MessageEncoding encoding);

}  // namespace setsquare::ros
