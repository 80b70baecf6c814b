// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What `evaluate ate`, `rpe` and `relations` have in common: bounds, and files for papers.
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/setsquare/outputs/inputs.hpp"
#include "setsquare/eval/bootstrap.hpp"
#include "setsquare/eval/error_series.hpp"

namespace setsquare::app {

/// Whether there are bounds and files.
struct ResultOptions {
  std::string directory;                     // Empty: no files.
  std::optional<std::size_t> num_resamples;  // None: with files 1000, else no bounds.

  /// How errors are resampled; nothing where no bounds are wanted.
  [[nodiscard]] std::optional<BootstrapParams> bootstrap() const;
};

/// -o DIR and --bootstrap N. `options` must outlive the application.
void add_result_options(CLI::App& subcommand, ResultOptions& options);

/// A file of results: its name and bytes.
using ResultFile = std::pair<std::string, std::string>;

/// Each error with its stamp, under a header: "stamp", "translation_m", "rotation_deg".
[[nodiscard]] std::string tsv_of(const ErrorSeries& errors);

/// Writes the files, all or none, and says so on `told` where it is given. Throws FileError, also
/// where one of the inputs has the name of a file.
void write_results(const ResultOptions& options,
                   const std::vector<ResultFile>& files,
                   const InputPaths& inputs,
                   std::ostream* told);

}  // namespace setsquare::app
