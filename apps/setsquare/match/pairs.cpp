// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/match/pairs.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <vector>

#include "apps/setsquare/match/summary.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/scans_at_stamps.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/matching/base_frame.hpp"

namespace setsquare::app {
namespace {

std::vector<Timestamp> stamps_of(const std::vector<Relation>& relations) {
  std::vector<Timestamp> stamps;
  stamps.reserve(2 * relations.size());
  for (const Relation& relation : relations) {
    stamps.push_back(relation.reference_stamp);
    stamps.push_back(relation.current_stamp);
  }
  return stamps;
}

PairOutcome match_pair(const Scan& reference, const Scan& current, Preset preset) {
  const auto start = std::chrono::steady_clock::now();
  const MatchResult of_sensor = match_by(preset, reference, current);
  const std::chrono::duration<double, std::micro> elapsed =
      std::chrono::steady_clock::now() - start;
  return {match_result_of_base(of_sensor, reference.T_base_sensor, current.T_base_sensor),
          elapsed.count()};
}

std::string table_line(const Scan& reference, const Scan& current, const PairOutcome& outcome) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const MatchResult& result = outcome.result;
  const Pose2 pose = result.T_reference_current.value_or(Pose2{kNaN, kNaN, kNaN});
  char line[400];
  std::snprintf(line,
                sizeof line,
                "%s\t%s\t%s\t%.6f\t%.6f\t%.6f\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\t%.1f\n",
                to_string(reference.stamp).c_str(),
                to_string(current.stamp).c_str(),
                std::string(to_string(result.status)).c_str(),
                pose.x_m,
                pose.y_m,
                pose.theta_rad,
                result.zncc_x,
                result.zncc_y,
                result.agreement,
                result.contradiction,
                result.overlap,
                result.score,
                result.runner_up ? result.runner_up->score : kNaN,
                outcome.elapsed_us);
  return line;
}

/// The overlaps beside "NAME.relations", in "NAME.overlap"; none where there is no such file.
std::vector<PairOverlap> overlaps_beside(const std::string& relations_path, std::size_t num_pairs) {
  auto path = std::filesystem::path(relations_path);
  path.replace_extension(".overlap");
  if (!std::filesystem::exists(path)) return {};
  auto overlaps = read_overlaps(path.string());
  if (overlaps.size() != num_pairs) {
    throw FormatError(path.string(), "", "has not one line a relation of " + relations_path);
  }
  return overlaps;
}

}  // namespace

void match_pairs(const MatchPairsOptions& options) {
  const auto relations = read_relations(options.relations_path);
  if (relations.empty()) throw FormatError(options.relations_path, "", "holds no relation");
  const auto overlaps = overlaps_beside(options.relations_path, relations.size());
  const auto scans = scans_at_stamps(options.log_path, options.log, stamps_of(relations));

  std::string table;
  std::vector<PairOutcome> outcomes;
  outcomes.reserve(relations.size());
  {
    ProgressBar progress("matching");
    for (std::size_t i = 0; i < relations.size(); ++i) {
      const Scan& reference = scans.at(relations[i].reference_stamp);
      const Scan& current = scans.at(relations[i].current_stamp);
      outcomes.push_back(match_pair(reference, current, options.preset));
      table += table_line(reference, current, outcomes.back());
      progress.advance(static_cast<double>(i + 1) / static_cast<double>(relations.size()));
    }
  }
  if (options.output_path == "-") {
    std::cout << table << std::flush;
  } else {
    save_file(options.output_path, table);
  }
  std::cerr << match_summary(relations, overlaps, outcomes);
}

}  // namespace setsquare::app
