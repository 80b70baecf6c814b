// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// compare_peers FOLDER [LOG...] - our matchers and MRPT's ICP, the baseline of bando2014, on
// the same pairs of scans, in one run, without an initial guess. FOLDER holds one folder per log:
// intel/intel.clf, intel/intel.local.relations, intel/intel.loop.relations.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/peers/comparison.hpp"
#include "benchmarks/peers/mrpt_icp.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"

namespace {

using setsquare::Scan;
using namespace setsquare::peers;

std::vector<Matcher> all_matchers() {
  return {{"MRPT ICP, classic",
           [](const Scan& reference, const Scan& current) {
             return match_by_mrpt_icp(reference, current, MrptIcpAlgorithm::kClassic);
           }},
          {"MRPT ICP, Levenberg-Marquardt",
           [](const Scan& reference, const Scan& current) {
             return match_by_mrpt_icp(reference, current, MrptIcpAlgorithm::kLevenbergMarquardt);
           }},
          {"Setsquare, paper",
           [](const Scan& reference, const Scan& current) {
             return setsquare::match_paper(reference, current).T_reference_current;
           }},
          {"Setsquare", [](const Scan& reference, const Scan& current) {
             return setsquare::match(reference, current).T_reference_current;
           }}};
}

void print_scores(const std::string& log,
                  const std::string& set,
                  std::size_t num_pairs,
                  const std::vector<MatcherScore>& scores) {
  const double our_median_ms = scores.back().median_ms;
  for (const MatcherScore& score : scores) {
    std::printf("| %s %s (%zu) | %s | %.1f | %.1f | %.3f | %.2f |\n",
                log.c_str(),
                set.c_str(),
                num_pairs,
                score.name.c_str(),
                100.0 * score.success,
                100.0 * score.tight,
                score.median_ms,
                score.median_ms / our_median_ms);
  }
  std::fflush(stdout);
}

void compare_on_logs(const std::filesystem::path& folder, const std::vector<std::string>& logs) {
  const std::vector<Matcher> matchers = all_matchers();
  std::puts("| pairs | matcher | success % | tight % | median ms | times ours |");
  std::puts("|---|---|---|---|---|---|");
  for (const std::string& log : logs) {
    const std::filesystem::path stem = folder / log / log;
    for (const std::string& set : {std::string("local"), std::string("loop")}) {
      const auto pairs =
          read_pair_set(stem.string() + ".clf", stem.string() + "." + set + ".relations");
      print_scores(log, set, pairs.size(), compare(matchers, pairs));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: compare_peers FOLDER [LOG...]\n", stderr);
    return 2;
  }
  std::vector<std::string> logs(argv + 2, argv + argc);
  if (logs.empty()) logs = {"intel", "aces", "fr079"};
  try {
    compare_on_logs(argv[1], logs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_peers: %s\n", error.what());
    return 2;
  }
  return 0;
}
