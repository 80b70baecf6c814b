// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare explain LOG I J -o FILE`: one match as a picture.
#include <fmt/core.h>

#include <array>
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/setsquare/outputs/output_file.hpp"
#include "apps/setsquare/preset.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/scans/select_scan.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/report/match/report.hpp"

namespace setsquare::app {
namespace {

struct ExplainOptions {
  std::string log_path;
  std::array<std::string, 2> scans;  ///< Reference and current.
  std::string output_path;
  Preset preset = Preset::kDefault;
  LogOptions log;
};

using MatchReportWriter = std::string (*)(const MatchStory& story);

MatchReportWriter writer_for(const std::string& output_path) {
  const std::string extension = std::filesystem::path(output_path).extension().string();
  if (extension == ".svg") return match_report_svg;
  if (extension == ".html") return match_report_html;
  throw FileError(output_path, "the name must end in .svg or .html");
}

std::string name_of_scan(const SelectedScan& selected) {
  return fmt::format("scan {}, stamp {}", selected.index, to_string(selected.scan.stamp));
}

void explain(const ExplainOptions& options) {
  const MatchReportWriter report_from = writer_for(options.output_path);
  const OutputFile output(options.output_path, {options.log_path});
  const std::vector<SelectedScan> selected =
      select_scans(options.log_path, options.scans, options.log);
  const StoryNames names = {.log = title_of_log(options.log_path),
                            .reference = name_of_scan(selected[0]),
                            .current = name_of_scan(selected[1])};
  const Scan& reference = selected[0].scan;
  const Scan& current = selected[1].scan;
  const MatchStory story = options.preset == Preset::kPaper
                               ? tell_paper_match(reference, current, names)
                               : tell_default_match(reference, current, names);
  output.write(report_from(story));
  for (const std::string& sentence : story.evidence) std::cout << sentence << "\n";
}

}  // namespace

void add_explain(CLI::App& application) {
  CLI::App* explain_command =
      application.add_subcommand("explain", "One match as a picture: what spoke for which pose");
  const auto options = std::make_shared<ExplainOptions>();
  add_log_argument(*explain_command, options->log_path);
  explain_command
      ->add_option("reference",
                   options->scans[0],
                   "Reference scan: an index (0 = first), or a stamp in s when written with a "
                   "decimal point")
      ->type_name("I")
      ->required();
  explain_command->add_option("current", options->scans[1], "Current scan, likewise")
      ->type_name("J")
      ->required();
  explain_command->add_option("-o,--output", options->output_path, "Picture (.svg) or page (.html)")
      ->type_name("FILE")
      ->required();
  add_preset_option(*explain_command, options->preset);
  add_log_options(*explain_command, options->log);
  explain_command->footer(
      "Shows the two scans as surfaces, the rotations that their walls propose, the proposals on\n"
      "their way to the answer and why the others lost, what the scores are made of, the rule of\n"
      "the verdict that decided, and the scans laid over each other. With --preset paper: the\n"
      "scans before and after thinning, the direction curve M(theta), the profiles and their\n"
      "correlations. Poses are those of the sensors.\n"
      "Examples:\n"
      "  setsquare explain intel.clf 100 140 -o match.svg\n"
      "  setsquare explain intel.clf 100 140 --preset paper -o match.html");
  explain_command->callback([options] { explain(*options); });
}

}  // namespace setsquare::app
