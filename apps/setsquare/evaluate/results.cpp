// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/results.hpp"

#include <fmt/core.h>

#include <CLI/Option.hpp>
#include <iterator>
#include <ostream>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/joined.hpp"

namespace setsquare::app {
namespace {

constexpr std::size_t kUsualResamples = 1000;

}  // namespace

std::optional<BootstrapParams> ResultOptions::bootstrap() const {
  const std::size_t num = num_resamples.value_or(directory.empty() ? 0 : kUsualResamples);
  if (num == 0) return std::nullopt;
  return BootstrapParams{.num_resamples = num};
}

void add_result_options(CLI::App& subcommand, ResultOptions& options) {
  subcommand.add_option("-o,--output", options.directory, "Write tables, plots and JSON into it")
      ->type_name("DIR");
  subcommand
      .add_option("--bootstrap",
                  options.num_resamples,
                  "Bounds of the figures, 5 and 95 %, by so many resamples of blocks; 20 or more")
      ->check(whole_number(20, 1'000'000))
      ->default_str("1000 with -o, else none")
      ->type_name("N");
}

std::string tsv_of(const ErrorSeries& errors) {
  std::string text = "stamp\ttranslation_m\trotation_deg\n";
  for (std::size_t i = 0; i < errors.stamps.size(); ++i) {
    fmt::format_to(std::back_inserter(text),
                   "{}\t{:.6f}\t{:.6f}\n",
                   to_string(errors.stamps[i]),
                   errors.translation_m[i],
                   deg_from_rad(errors.rotation_rad[i]));
  }
  return text;
}

void write_results(const ResultOptions& options,
                   const std::vector<ResultFile>& files,
                   const InputPaths& inputs,
                   std::ostream* told) {
  std::vector<std::string> names;
  for (const ResultFile& file : files) names.push_back(file.first);
  OutputSet outputs(options.directory, names, inputs);
  for (const auto& [name, bytes] : files) outputs.add(name, bytes);
  outputs.commit();
  if (told != nullptr) {
    *told << fmt::format("written: {}/{}\n", options.directory, joined(names));
  }
}

}  // namespace setsquare::app
