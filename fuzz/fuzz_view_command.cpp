// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "fuzz/fuzz_target.hpp"
#include "setsquare/view/command.hpp"
#include "setsquare/view/same_origin.hpp"

namespace {

using setsquare::view::Command;

std::string text_of(const Command& command) {
  switch (command.kind) {
    case Command::Kind::kSave:
      return R"({"do":"save"})";
    case Command::Kind::kPause:
      return fmt::format(R"({{"do":"pause","on":{}}})", command.is_on);
    case Command::Kind::kSetPose:
      break;
  }
  const auto& [x_m, y_m, theta_rad] = command.T_map_base;
  return fmt::format(R"({{"do":"set_pose","x":{},"y":{},"heading":{}}})", x_m, y_m, theta_rad);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  if (const auto command = view::parse_command(bytes)) {
    const Pose2& pose = command->T_map_base;
    fuzz::require(std::abs(pose.x_m) <= 1e6 && std::abs(pose.y_m) <= 1e6);
    fuzz::require(std::abs(pose.theta_rad) <= 1e6);
    const auto again = view::parse_command(text_of(*command));
    fuzz::require(again && again->kind == command->kind && again->is_on == command->is_on &&
                  again->T_map_base == pose);
  }
  fuzz::require(view::is_same_origin("http://" + bytes, bytes) == view::is_own_host(bytes));
  return 0;
}
