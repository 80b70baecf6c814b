// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <cstdlib>
#include <string>

#include "apps/setsquare/command_line/options.hpp"

namespace setsquare::live_app {

/// ROS_DOMAIN_ID, else 0. One that is no number is refused when the domain is joined.
[[nodiscard]] inline int domain_of_environment() {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return 0;
  char* end = nullptr;
  const long domain = std::strtol(text, &end, 10);
  const bool is_number = *end == '\0' && domain >= 0 && domain <= 232;
  return is_number ? static_cast<int>(domain) : -1;
}

inline void add_domain_options(CLI::App& subcommand, int& domain, bool& is_local) {
  subcommand.add_option("--domain", domain, "Of ROS 2, instead of ROS_DOMAIN_ID")
      ->check(app::whole_number(0, 232))
      ->type_name("N")
      ->capture_default_str();
  subcommand.add_flag_callback(
      "--network", [&is_local] { is_local = false; }, "Speak with other machines, too");
}

}  // namespace setsquare::live_app
