// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare experiment paper -o DIR`: the paper's experiments again, from seeds.
#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "experiments/paper_experiment.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"

namespace setsquare::app {
namespace {

struct ExperimentOptions {
  std::string output_path;
  experiments::PaperExperimentParams params;
};

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw FileError(path, "cannot be made: " + error.message());
}

void run_paper(const ExperimentOptions& options) {
  make_folder(options.output_path);
  std::unique_ptr<ProgressBar> bar;
  std::string shown;
  const auto progress = [&](std::string_view section, std::size_t num_done, std::size_t num_all) {
    if (!bar || shown != section) {
      bar.reset();
      shown = section;
      bar = std::make_unique<ProgressBar>(shown);
    }
    bar->advance(static_cast<double>(num_done) / static_cast<double>(num_all));
  };
  const experiments::PaperExperiment experiment =
      experiments::run_paper_experiment(options.params, progress);
  bar.reset();
  const std::filesystem::path folder(options.output_path);
  save_file(folder / "paper.html", experiments::paper_html(experiment));
  save_file(folder / "paper.json", experiments::paper_json(experiment));
  std::cout << experiments::paper_text(experiment) << "written: " << options.output_path
            << "/paper.html, paper.json\n";
}

}  // namespace

void add_experiment(CLI::App& application) {
  const auto options = std::make_shared<ExperimentOptions>();
  options->params.num_threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App* experiment =
      application.add_subcommand("experiment", "Run experiments on simulated buildings");
  experiment->require_subcommand(1);
  CLI::App* paper = experiment->add_subcommand(
      "paper", "The experiments of Bando, Tsubouchi and Yuta 2014, theirs beside ours");
  paper->add_option("-o,--output", options->output_path, "Directory for the results")->required();
  const std::vector<std::string>& names = experiments::paper_section_names();
  paper->add_option("--only", options->params.sections, "Only these sections, parted by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  paper->add_option("--threads", options->params.num_threads, "Threads; as many as cores if absent")
      ->check(CLI::Range(1, 256));
  paper->add_flag("--quick", options->params.is_quick, "A few seeds of everything");
  paper->footer(
      "Writes paper.html (one page that needs no other file) and paper.json (all numbers).\n"
      "Examples:\n"
      "  setsquare experiment paper -o out\n"
      "  setsquare experiment paper -o out --only buildings --quick");
  paper->callback([options] { run_paper(*options); });
}

}  // namespace setsquare::app
