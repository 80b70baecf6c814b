// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare convert LOG... OUT`: a log in another format.
#include <fmt/core.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/convert/map_recording.hpp"
#include "apps/setsquare/outputs/growing_output.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/log_chain.hpp"
#include "setsquare/io/logs/log_writer.hpp"

namespace setsquare::app {
namespace {

struct ConvertOptions {
  std::vector<std::string> paths;  ///< The logs, then the output.
  std::optional<LogFormat> format;
  ChunkPacking packing = ChunkPacking::kZstd;
  LogOptions log;
  std::string map_folder;  ///< Results of `setsquare map`, to be recorded; or empty.
};

struct Converted {
  std::uint64_t num_scans = 0;
  std::uint64_t num_others = 0;
  std::uint64_t num_refused = 0;  ///< Scans that the format cannot state.
  std::string first_reason;
  bool has_assumed_bearings = false;  ///< Scans of a log that states no angles.
};

LogFormat format_of(const ConvertOptions& options, const std::string& output) {
  if (options.format) return *options.format;
  if (const auto format = log_format_of(output)) return *format;
  throw Error(output +
              ": its name tells no format (.clf, .csv, .jsonl, .mcap, .tum); --format does");
}

Converted convert(LogReader& reader, LogWriter& writer) {
  Converted converted;
  ProgressBar progress("converting");
  while (const LogRecord* record = reader.next()) {
    progress.advance(reader.fraction_read());
    converted.has_assumed_bearings = converted.has_assumed_bearings || record->has_assumed_bearings;
    try {
      writer.write(*record);
      ++(record->kind == RecordKind::kScan ? converted.num_scans : converted.num_others);
    } catch (const ParameterError& error) {
      if (converted.num_refused++ == 0) converted.first_reason = error.what();
    }
  }
  writer.finish();
  return converted;
}

std::string name_of(const std::string& output_path) {
  return output_path == "-" ? "standard output" : output_path;
}

/// The output states the angles that were assumed: nobody can tell any more.
void tell_assumed_bearings(const Converted& converted, const LogOptions& options) {
  const bool is_said = options.field_of_view_rad || options.bearing_step_rad;
  if (!converted.has_assumed_bearings || is_said) return;
  std::cerr << "the log states no angles: those of 180 degrees are written (--field-of-view)\n";
}

void convert_map(const ConvertOptions& options, const std::vector<std::string>& logs) {
  const std::string& output_path = options.paths.back();
  if (format_of(options, output_path) != LogFormat::kMcap) {
    throw Error("--map: a map is recorded as mcap, not as " + output_path);
  }
  const auto reader = open_logs(logs, options.log);
  GrowingOutput output(output_path, logs);
  const RecordedMap recorded = record_map(
      options.map_folder, *reader, [&output](std::string_view bytes) { output.append(bytes); });
  output.commit();
  std::cerr << fmt::format(
      "{} scans and the map written to {}\n", recorded.num_scans, name_of(output_path));
  if (recorded.num_without_pose > 0) {
    std::cerr << fmt::format("left out: {} scans that the map has no pose of\n",
                             recorded.num_without_pose);
  }
  tell_problems(logs.front(), reader->problems());
}

void convert_log(const ConvertOptions& options) {
  if (options.paths.size() < 2) throw Error("convert: a log and an output are needed");
  const std::vector<std::string> logs(options.paths.begin(), options.paths.end() - 1);
  if (!options.map_folder.empty()) return convert_map(options, logs);
  const std::string& output_path = options.paths.back();
  const LogFormat format = format_of(options, output_path);
  LogOptions log_options = options.log;
  log_options.scans_only = false;
  if (log_options.sensor.empty()) log_options.sensor = "all";
  const auto reader = open_logs(logs, log_options);
  GrowingOutput output(output_path, logs);
  const auto writer = make_log_writer(
      format, [&output](std::string_view bytes) { output.append(bytes); }, options.packing);
  const Converted converted = convert(*reader, *writer);
  output.commit();
  std::cerr << fmt::format("{} scans, {} other records written to {}\n",
                           converted.num_scans,
                           converted.num_others - writer->num_left_out(),
                           name_of(output_path));
  if (writer->num_left_out() > 0) {
    std::cerr << fmt::format("left out: {} records that the format has no place for\n",
                             writer->num_left_out());
  }
  if (converted.num_refused > 0) {
    std::cerr << fmt::format(
        "left out: {} scans, the first since {}\n", converted.num_refused, converted.first_reason);
  }
  if (format != LogFormat::kTum) tell_assumed_bearings(converted, options.log);
  tell_problems(logs.front(), reader->problems());
}

}  // namespace

void add_convert(CLI::App& application) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* convert_command =
      application.add_subcommand("convert", "Write a log in another format");
  convert_command
      ->add_option("log", options->paths, "Logs of one run in their order, then the output")
      ->type_name("... OUT")
      ->required();
  add_choice<std::optional<LogFormat>, LogFormat>(*convert_command,
                                                  "--format",
                                                  options->format,
                                                  {{"carmen", LogFormat::kCarmen},
                                                   {"csv", LogFormat::kCsv},
                                                   {"jsonl", LogFormat::kJsonLines},
                                                   {"mcap", LogFormat::kMcap},
                                                   {"tum", LogFormat::kTum}},
                                                  "Of the output",
                                                  "by the output's name");
  add_choice<ChunkPacking, ChunkPacking>(
      *convert_command,
      "--compression",
      options->packing,
      {{"none", ChunkPacking::kNone}, {"lz4", ChunkPacking::kLz4}, {"zstd", ChunkPacking::kZstd}},
      "Of mcap's chunks",
      "zstd");
  convert_command
      ->add_option("--map",
                   options->map_folder,
                   "Record what setsquare map made of the log: the map growing, the way, closures")
      ->type_name("DIR");
  add_log_options(*convert_command, options->log);
  convert_command->get_option("--sensor")->default_str("all");
  convert_command->footer(
      "mcap: a ROS 2 bag, which Foxglove and Lichtblick open; jsonl: everything, exactly; csv: "
      "the\n"
      "scans; carmen: scans of one laser, to the millimetre; tum: reference poses (or odometry).\n"
      "docs/formats.md describes them. The last name is the output, - = stdout.\n"
      "Examples:\n"
      "  setsquare convert my_bag scans.jsonl\n"
      "  setsquare convert intel.clf intel.mcap\n"
      "  setsquare map intel.clf -o out && setsquare convert intel.clf --map out map.mcap\n"
      "  setsquare convert run.bag truth.tum --topic /ground_truth\n"
      "  setsquare convert part1.mcap part2.mcap - --format csv --rate 5 | head");
  convert_command->callback([options] { convert_log(*options); });
}

}  // namespace setsquare::app
