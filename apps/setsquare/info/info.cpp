// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare info LOG`: what is in a log and what is wrong with it.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "apps/setsquare/info/map.hpp"
#include "apps/setsquare/info/report.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/faults/find_faults.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::app {
namespace {

struct InfoOptions {
  std::string log_path;
  LogOptions log;
  bool is_json = false;
};

/// A recording of messages without a scan is worth a look, too: it has topics.
void survey_log(LogReader& reader, InfoReport& report) {
  ProgressBar progress("reading");
  try {
    while (const LogRecord* record = reader.next()) {
      report.survey.add(*record);
      progress.advance(reader.fraction_read());
    }
  } catch (const FormatError&) {
    if (reader.overview().empty()) throw;
  }
}

void tell_info(const InfoOptions& options) {
  if (is_map(options.log_path)) {
    print_map_info(options.log_path, options.is_json, std::cout);
    return;
  }
  LogOptions log_options = options.log;
  log_options.scans_only = false;
  if (log_options.sensor.empty()) log_options.sensor = "all";
  const auto reader = open_log(options.log_path, log_options);
  InfoReport report;
  survey_log(*reader, report);
  report.path = options.log_path == "-" ? "standard input" : options.log_path;
  report.format = reader->format();
  report.front_sensor = reader->front_sensor();
  report.problems = reader->problems();
  report.recording = reader->overview();
  report.findings = find_faults(report.survey, report.problems);
  if (options.is_json) {
    print_info_json(report, std::cout);
  } else {
    print_info(report, std::cout);
  }
}

}  // namespace

void add_info(CLI::App& application) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* info = application.add_subcommand(
      "info", "What is in a log and what is wrong with it, or what is in a map");
  add_log_argument(*info, options->log_path);
  CLI::Option* const log = info->get_option("log");
  log->description(log->get_description() + "; or the file or folder of a map");
  info->add_flag("--json", options->is_json, "Print JSON");
  add_log_options(*info, options->log);
  info->get_option("--sensor")->default_str("all");
  info->footer(
      "Angles in deg, lengths in m, times in s.\nExamples:\n  setsquare info intel.clf\n  zcat "
      "log.gz | setsquare info - --json\n  setsquare info out/map.setsquare");
  info->callback([options] { tell_info(*options); });
}

}  // namespace setsquare::app
