// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// setsquare-experiment, which `setsquare experiment` starts: the paper's experiments again, from
// seeds.
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <unistd.h>

#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "apps/setsquare/progress_bar.hpp"
#include "experiments/goals.hpp"
#include "experiments/paper_experiment.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#ifdef SETSQUARE_HAS_MRPT
#include "benchmarks/peers/mrpt_icp.hpp"
#endif

namespace setsquare::experiments {
namespace {

constexpr int kExitGoalMissed = 1;
/// Bad file, option or parameter.
constexpr int kExitBadInput = 2;

struct ExperimentOptions {
  std::string output_path;
  bool checks_goals = false;
  PaperExperimentParams params;
};

/// MRPT's ICP as the paper ran it: Levenberg-Marquardt, default parameters, zero guess. Empty where
/// the program was built without MRPT.
PeerMatcher mrpt_icp() {
#ifdef SETSQUARE_HAS_MRPT
  return [](const Scan& reference, const Scan& current) -> std::optional<Pose2> {
    try {
      return peers::match_by_mrpt_icp(
          reference, current, peers::MrptIcpAlgorithm::kLevenbergMarquardt);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  };
#else
  return {};
#endif
}

/// Makes the folder and makes sure, before the computing, that files can be written into it.
void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw FileError(path, "cannot be made: " + error.message());
  if (!std::filesystem::is_directory(path)) throw FileError(path, "is no folder");
  if (::access(path.c_str(), W_OK | X_OK) != 0) throw FileError(path, "cannot be written into");
}

PaperExperiment run_with_progress(const PaperExperimentParams& params) {
  std::unique_ptr<app::ProgressBar> bar;
  std::string shown;
  return run_paper_experiment(
      params, [&](std::string_view section, std::size_t num_done, std::size_t num_all) {
        if (!bar || shown != section) {
          bar.reset();
          shown = section;
          bar = std::make_unique<app::ProgressBar>(shown);
        }
        bar->advance(static_cast<double>(num_done) / static_cast<double>(num_all));
      });
}

/// Prints the goals and what was reached; returns whether every required goal that was measured is
/// met.
bool check_goals(const PaperExperiment& experiment) {
  std::vector<Goal> goals = goals_of(experiment);
  goals.push_back(time_goal(experiment));
  bool are_met = true;
  for (const Goal& goal : goals) {
    if (!goal.is_known) continue;
    are_met = are_met && goal.meets_must;
    fmt::print(std::cout,
               "[{}] {}: {} (must: {}; aim: {})\n",
               goal.meets_aim    ? "aim"
               : goal.meets_must ? "must"
                                 : "missed",
               goal.what,
               goal.reached,
               goal.must,
               goal.aim);
  }
  return are_met;
}

int run_paper(const ExperimentOptions& options) {
  make_folder(options.output_path);
  PaperExperimentParams params = options.params;
  params.icp = mrpt_icp();
  const auto& sections = params.sections;
  const bool wants_icp =
      sections.empty() ||
      std::find(sections.begin(), sections.end(), "section_5_1") != sections.end();
  if (wants_icp && !params.icp) {
    std::cerr << "setsquare experiment: MRPT's ICP is left out: install libmrpt-dev "
                 "(tools/install_packages peers), build again\n";
  }
  const PaperExperiment experiment = run_with_progress(params);
  const std::filesystem::path folder(options.output_path);
  const std::string html = paper_html(experiment);
  const std::string json = paper_json(experiment);
  const FileBytes files[] = {{folder / "paper.html", html}, {folder / "paper.json", json}};
  save_files(files);
  std::cout << paper_text(experiment) << "written: " << options.output_path
            << "/paper.html, paper.json\n";
  if (options.checks_goals && !check_goals(experiment)) return kExitGoalMissed;
  return 0;
}

/// `setsquare experiment paper` and its options.
CLI::App* add_paper(CLI::App& application, ExperimentOptions& options) {
  options.params.num_threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App* paper = application.add_subcommand(
      "paper", "The experiments of Bando, Tsubouchi and Yuta 2014, their results and ours");
  paper->add_option("-o,--output", options.output_path, "Folder for the results")->required();
  paper->add_option("--only", options.params.sections, "Only these sections, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(paper_section_names()));
  paper->add_option("--threads", options.params.num_threads, "Threads; as many as cores if absent")
      ->check(CLI::Range(1, 256));
  paper->add_flag("--quick", options.params.is_quick, "A few seeds of everything");
  paper->add_flag("--check-goals",
                  options.checks_goals,
                  "Print what this project set out to reach and what it reached; exit code 1 "
                  "where a minimum is missed");
  paper->footer(
      "Writes paper.html (one page that needs no other file) and paper.json (all numbers).\n"
      "Examples:\n"
      "  setsquare experiment paper -o out\n"
      "  setsquare experiment paper -o out --only buildings --quick");
  return paper;
}

int complain(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "setsquare experiment: " << message << "\n";
  return kExitBadInput;
}

int run(int argc, char** argv) {
  CLI::App application{"Runs experiments on simulated buildings.", "setsquare experiment"};
  application.require_subcommand(1);
  ExperimentOptions options;
  add_paper(application, options);
  int exit_code = 0;
  try {
    application.parse(argc, argv);
    exit_code = run_paper(options);
  } catch (const CLI::Success& request) {  // --help
    exit_code = application.exit(request);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (see --help)");
  }
  if (!std::cout.flush()) return complain("standard output: cannot be written");
  return exit_code;
}

}  // namespace
}  // namespace setsquare::experiments

int main(int argc, char** argv) {
  try {
    return setsquare::experiments::run(argc, argv);
  } catch (const std::exception& error) {
    return setsquare::experiments::complain(error.what());
  }
}
