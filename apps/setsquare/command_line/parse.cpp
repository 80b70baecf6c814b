// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/command_line/parse.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstddef>
#include <iostream>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

namespace setsquare::app {
namespace {

/// Help without CLI11's shorthands: "=1", "x 2", "(0x)", "Excludes:--rate".
class HelpForm : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override {
    const bool has_value = option->get_type_size() != 0 && !option->get_type_name().empty();
    return has_value ? " " + option->get_type_name() : "";
  }
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override {
    const std::string& text = option->get_description();
    if (option->get_required() && !option->get_positional()) return text + " (required)";
    const std::string fallback = option->get_default_str();
    const bool is_shown = option->get_type_size() != 0 && !fallback.empty() && fallback != "[]";
    return is_shown ? fmt::format("{} (default: {})", text, fallback) : text;
  }
  [[nodiscard]] std::string make_option_usage(const CLI::Option* option) const override {
    const bool is_list = option->get_expected_max() > 1 && !option->get_type_name().empty();
    const std::string name = is_list ? option->get_type_name() : make_option_name(option, true);
    return option->get_required() ? name : "[" + name + "]";
  }
};

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// " (did you mean 'map'?)", or nothing where no word is near.
std::string nearest(const std::string& given, const std::vector<std::string>& words) {
  constexpr std::size_t kFar = 3;
  std::size_t least = std::min(kFar, given.size());
  std::string found;
  for (const std::string& word : words) {
    const std::size_t distance = edit_distance(given, word);
    if (distance >= least) continue;
    least = distance;
    found = fmt::format(" (did you mean '{}'?)", word);
  }
  return found;
}

std::vector<std::string> names_of_commands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* const sub : command.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// "setsquare evaluate ate".
std::string full_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return (parent == nullptr ? "" : full_name(*parent) + " ") + command.get_name();
}

/// The command without a subcommand that it needs: what there is to choose from.
int complain_of_no_command(const CLI::App& command) {
  std::cerr << fmt::format("Usage: {} COMMAND [OPTIONS]\nCommands:\n", full_name(command));
  for (const CLI::App* const sub : command.get_subcommands({})) {
    std::cerr << fmt::format("  {:<11} {}\n", sub->get_name(), sub->get_description());
  }
  std::cerr << fmt::format("See '{} COMMAND --help'.\n", full_name(command));
  return kExitBadInput;
}

/// The first words of the command line, as far as they name subcommands.
class NamedCommand {
 public:
  NamedCommand(const CLI::App& application, int argc, char** argv) : command_(&application) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (command_->get_subcommands({}).empty()) return;
      if (word.starts_with('-')) {
        has_option_ = true;
        return;
      }
      const CLI::App* const sub = find(word);
      if (sub == nullptr) {
        unknown_ = word;
        return;
      }
      command_ = sub;
    }
  }

  [[nodiscard]] const CLI::App& command() const { return *command_; }
  /// The word in a subcommand's place that is not a subcommand; empty where there is no such word.
  [[nodiscard]] const std::string& unknown() const { return unknown_; }
  /// Whether a subcommand is needed and the line ends before it.
  [[nodiscard]] bool is_cut() const {
    return !command_->get_subcommands({}).empty() && unknown_.empty() && !has_option_;
  }

 private:
  [[nodiscard]] const CLI::App* find(const std::string& word) const {
    for (const CLI::App* const sub : command_->get_subcommands({})) {
      if (sub->get_name() == word) return sub;
    }
    return nullptr;
  }

  const CLI::App* command_;
  std::string unknown_;
  bool has_option_ = false;
};

std::string words_of_error(const CLI::App& application,
                           const CLI::App& command,
                           const CLI::ParseError& error) {
  const std::vector<std::string> left = application.remaining(true);
  const bool is_about_left =
      dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
      (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && &command == &application);
  if (!is_about_left || left.empty()) return error.what();
  const auto option = std::find_if(
      left.begin(), left.end(), [](const std::string& word) { return word.starts_with('-'); });
  if (option == left.end()) return fmt::format("unexpected argument '{}'", left.front());
  const std::string name = option->substr(0, option->find('='));
  return fmt::format("unknown option '{}'{}", name, nearest(name, names_of_options(command)));
}

}  // namespace

void set_help_form(CLI::App& application) {
  application.formatter(std::make_shared<HelpForm>());
  application.get_formatter()->column_width(32);
  application.option_defaults()->always_capture_default();
}

int complain(const std::string& message) {
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << "setsquare: " << line << "\n";
  return kExitBadInput;
}

int parse_and_run(CLI::App& application, int argc, char** argv) {
  const NamedCommand named(application, argc, argv);
  if (named.is_cut()) return complain_of_no_command(named.command());
  if (!named.unknown().empty()) {
    return complain(fmt::format("unknown command '{}'{}; see '{} --help'",
                                named.unknown(),
                                nearest(named.unknown(), names_of_commands(named.command())),
                                full_name(named.command())));
  }
  int exit_code = 0;
  try {
    application.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    exit_code = application.exit(request);
  } catch (const CLI::RuntimeError& end) {  // a subcommand that is done and has its own exit code
    exit_code = end.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return complain(fmt::format("{}; see '{} --help'",
                                words_of_error(application, named.command(), error),
                                full_name(named.command())));
  }
  if (!std::cout.flush()) return complain("standard output: cannot be written");
  return exit_code;
}

}  // namespace setsquare::app
