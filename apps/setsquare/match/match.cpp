// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare match LOG I J` and `setsquare match LOG --pairs FILE`.
#include "apps/setsquare/match/match.hpp"

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <memory>
#include <string>
#include <vector>

#include "apps/setsquare/preset.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::app {
namespace {

/// What was given on the command line, whatever its value.
struct MatchChoice {
  bool has_pairs = false;
  bool has_output = false;
  bool has_frame = false;
};

struct MatchOptions {
  std::string log_path;
  std::vector<std::string> scans;
  std::string pairs_path;
  std::string output_path = "-";
  bool is_json = false;
  Preset preset = Preset::kDefault;
  bool is_of_sensor = false;
  LogOptions log;
};

/// Refuses options that the chosen way of matching would ignore.
void check_choice(const MatchChoice& given, const MatchOptions& options) {
  if (given.has_pairs) {
    if (!options.scans.empty()) throw Error("match: give two scans or --pairs, not both");
    if (options.pairs_path.empty()) throw Error("match: --pairs needs the name of a file");
    if (options.is_json) throw Error("match: --json is for two scans; --pairs writes a table");
    if (given.has_frame) throw Error("match: --frame is for two scans; --pairs writes robot poses");
  } else if (given.has_output) {
    throw Error("match: -o is for the table of --pairs; two scans go to standard output");
  }
}

void run_match(const MatchChoice& given, const MatchOptions& options) {
  check_choice(given, options);
  if (given.has_pairs) {
    match_pairs({.log_path = options.log_path,
                 .log = options.log,
                 .relations_path = options.pairs_path,
                 .output_path = options.output_path,
                 .preset = options.preset});
    return;
  }
  if (options.scans.size() != 2) {
    throw Error("match: name two scans, reference and current, or give --pairs (see --help)");
  }
  match_one({.log_path = options.log_path,
             .log = options.log,
             .scans = options.scans,
             .preset = options.preset,
             .is_of_sensor = options.is_of_sensor,
             .is_json = options.is_json});
}

}  // namespace

void add_match(CLI::App& application) {
  CLI::App* match =
      application.add_subcommand("match", "Relative pose of two scans, without an initial guess");
  const auto options = std::make_shared<MatchOptions>();
  add_log_argument(*match, options->log_path);
  match
      ->add_option("scans",
                   options->scans,
                   "Reference and current scan: indices (0 = first), or stamps in s when written "
                   "with a decimal point")
      ->expected(0, 2)
      ->type_name("I J");
  match
      ->add_option("--pairs",
                   options->pairs_path,
                   "Instead of two scans: match every pair of a relations file")
      ->type_name("FILE");
  match
      ->add_option(
          "-o,--output", options->output_path, "With --pairs: the table's file; - = stdout")
      ->type_name("FILE");
  match->add_flag("--json", options->is_json, "With two scans: print JSON");
  add_preset_option(*match, options->preset);
  add_frame_option(*match, options->is_of_sensor);
  add_log_options(*match, options->log);
  match->footer(
      "Two scans: the pose of the current scan in the reference's frame, in m and deg, with its\n"
      "standard deviations and the evidence. status is matched, ambiguous, degenerate, "
      "no_overlap,\n"
      "too_few_points or rejected; the pose is the best proposal whatever the status.\n"
      "--pairs: a table with a header and one tab-separated line per relation, in the file's "
      "order,\n"
      "in m, rad and microseconds, poses of the robot (docs/formats.md). A summary against the\n"
      "relations goes to standard error, by overlap where FILE.overlap lies in the "
      "folder of FILE.relations.\n"
      "Examples:\n"
      "  setsquare match intel.clf 100 140\n"
      "  setsquare match intel.clf 976052905.167303 976052911.885496 --json\n"
      "  setsquare match intel.clf --pairs intel.loop.relations -o intel.loop.tsv");
  match->callback([options, match] {
    const MatchChoice given = {.has_pairs = match->count("--pairs") > 0,
                               .has_output = match->count("--output") > 0,
                               .has_frame = match->count("--frame") > 0};
    run_match(given, *options);
  });
}

}  // namespace setsquare::app
