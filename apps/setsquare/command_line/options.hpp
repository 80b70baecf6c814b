// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the options of all subcommands have in common: checks with plain messages, and names of
// choices.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace setsquare::app {

/// Refuses what is not a whole number from `low` to `high`, both included.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

/// Refuses what is not a finite number above `low`.
[[nodiscard]] CLI::Validator number_above(double low);

/// Refuses what is not a number above `low` and at most `high`.
[[nodiscard]] CLI::Validator number_above(double low, double high);

/// Refuses what is not a number from `low` to `high`, both included.
[[nodiscard]] CLI::Validator number_from(double low, double high);

/// Refuses what is not a number from -high to high other than 0.
[[nodiscard]] CLI::Validator number_not_zero(double high);

/// Refuses anything but the names, in any case; as a transform it gives the name as it is
/// written here.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> names);

/// "a|b|c".
[[nodiscard]] std::string bars_between(const std::vector<std::string>& names);

/// Adds an option that takes one of a few names, whatever its case. `value` must outlive the
/// application; `default_text` stands in the help.
template <typename Value, typename Choice>
CLI::Option* add_choice(CLI::App& subcommand,
                        const std::string& option,
                        Value& value,
                        const std::vector<std::pair<std::string, Choice>>& choices,
                        const std::string& description,
                        const std::string& default_text) {
  std::vector<std::string> names;
  for (const auto& [name, choice] : choices) names.push_back(name);
  const auto choose = [&value, choices](const std::string& given) {
    for (const auto& [name, choice] : choices) {
      if (name == given) value = choice;
    }
  };
  return subcommand.add_option_function<std::string>(option, choose, description)
      ->transform(one_of(names))
      ->type_name(bars_between(names))
      ->default_str(default_text);
}

}  // namespace setsquare::app
