// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <vector>

#include "apps/setsquare/match/match.hpp"
#include "apps/setsquare/outputs/output_file.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/scans_at_stamps.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/relation.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/matching/base_frame.hpp"

namespace setsquare::app {
namespace {

/// A match of the pair of a relation.
struct PairOutcome {
  MatchResult result;       ///< Poses of the robot.
  double elapsed_us = 0.0;  ///< Preparing both scans from raw ranges, and the match.
};

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

constexpr const char* kTableHeader =
    "reference_stamp\tcurrent_stamp\tstatus\tx_m\ty_m\ttheta_rad\tzncc_x\tzncc_y\tagreement\t"
    "contradiction\toverlap\tscore\trunner_up_score\tprobability\tmicroseconds\n";

std::string table_line(const Scan& reference, const Scan& current, const PairOutcome& outcome) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const MatchResult& result = outcome.result;
  const Pose2 pose = result.T_reference_current.value_or(Pose2{kNaN, kNaN, kNaN});
  return fmt::format(
      "{}\t{}\t{}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t"
      "{:.5f}\t{:.1f}\n",
      to_string(reference.stamp),
      to_string(current.stamp),
      to_string(result.status),
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
      result.probability,
      outcome.elapsed_us);
}

/// "NAME.overlap" in the folder of "NAME.relations".
std::string overlap_path_beside(const std::string& relations_path) {
  return std::filesystem::path(relations_path).replace_extension(".overlap").string();
}

/// The overlaps that belong to the relations; none where there is no such file.
std::vector<PairOverlap> overlaps_beside(const std::string& relations_path, std::size_t num_pairs) {
  const std::string path = overlap_path_beside(relations_path);
  if (!std::filesystem::exists(path)) return {};
  auto overlaps = read_overlaps(path);
  if (overlaps.size() != num_pairs) {
    throw FormatError(
        path,
        "",
        fmt::format(
            "has {} lines for the {} relations of {}", overlaps.size(), num_pairs, relations_path));
  }
  return overlaps;
}

constexpr double kSuccess_m = 0.2;
constexpr double kSuccess_rad = rad_from_deg(30.0);  // the paper's criterion
constexpr double kTight_m = 0.05;
constexpr double kTight_rad = rad_from_deg(1.0);
constexpr double kWrong_m = 0.2;
constexpr double kWrong_rad = rad_from_deg(3.0);

struct PairError {
  double translation_m = std::numeric_limits<double>::infinity();
  double rotation_rad = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_within(double limit_m, double limit_rad) const {
    return translation_m <= limit_m && rotation_rad <= limit_rad;
  }
};

PairError error_of(const MatchResult& result, const Pose2& truth) {
  if (!result.T_reference_current) return {};
  const Pose2 error = truth.inverse() * *result.T_reference_current;
  return {std::hypot(error.x_m, error.y_m), std::abs(error.theta_rad)};
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Counts of one class of pairs.
struct Tally {
  std::size_t num_pairs = 0;
  std::size_t num_success = 0;
  std::size_t num_tight = 0;
  std::size_t num_matched = 0;
  std::size_t num_wrong = 0;
  std::vector<double> translation_m;
  std::vector<double> rotation_rad;
  std::vector<double> elapsed_us;

  void add(const PairOutcome& outcome, const PairError& error) {
    ++num_pairs;
    num_success += error.is_within(kSuccess_m, kSuccess_rad);
    num_tight += error.is_within(kTight_m, kTight_rad);
    const bool is_matched = outcome.result.status == MatchStatus::kMatched;
    num_matched += is_matched;
    num_wrong += is_matched && !error.is_within(kWrong_m, kWrong_rad);
    translation_m.push_back(error.translation_m);
    rotation_rad.push_back(error.rotation_rad);
    elapsed_us.push_back(outcome.elapsed_us);
  }
};

std::string row(const char* name, const Tally& tally) {
  if (tally.num_pairs == 0) return {};
  const auto percent = [&](std::size_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(tally.num_pairs);
  };
  return fmt::format(
      "{:<15} {:6} {:8.1f}% {:6.1f}% {:8.1f}% {:6} {:8.4f} m {:7.3f} deg {:9.1f} us\n",
      name,
      tally.num_pairs,
      percent(tally.num_success),
      percent(tally.num_tight),
      percent(tally.num_matched),
      tally.num_wrong,
      median(tally.translation_m),
      deg_from_rad(median(tally.rotation_rad)),
      median(tally.elapsed_us));
}

/// How the matches stand against the relations, as a table for a person: success (0.2 m and 30
/// deg), tight (0.05 m and 1 deg), matched, wrong among the matched (over 0.2 m or 3 deg), median
/// errors and time; by overlap where overlaps are given (one per relation, else none).
std::string match_summary(const std::vector<Relation>& relations,
                          const std::vector<PairOverlap>& overlaps,
                          const std::vector<PairOutcome>& outcomes) {
  Tally all;
  Tally high;
  Tally middle;
  Tally low;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const PairError error = error_of(outcomes[i].result, relations[i].T_reference_current);
    all.add(outcomes[i], error);
    if (overlaps.empty()) continue;
    const double overlap = overlaps[i].overlap;
    (overlap >= 0.45 ? high : overlap >= 0.20 ? middle : low).add(outcomes[i], error);
  }
  return "pairs            number  success   tight   matched  wrong    median error            "
         "median time\n" +
         row("all", all) + row("overlap >= 45 %", high) + row("overlap 20-45 %", middle) +
         row("overlap < 20 %", low);
}

}  // namespace

void match_pairs(const MatchPairsOptions& options) {
  const OutputFile output(
      options.output_path,
      {options.log_path, options.relations_path, overlap_path_beside(options.relations_path)});
  const auto relations = read_relations(options.relations_path);
  if (relations.empty()) throw FormatError(options.relations_path, "", "holds no relation");
  const auto overlaps = overlaps_beside(options.relations_path, relations.size());
  const auto scans = scans_at_stamps(options.log_path, options.log, stamps_of(relations));

  std::string table = kTableHeader;
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
  output.write(table);
  std::cerr << match_summary(relations, overlaps, outcomes);
}

}  // namespace setsquare::app
