// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The relative pose of two scans of a log: match_two_scans LOG
#include <iostream>
#include <memory>
#include <vector>

#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/matching/scan_matcher.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    std::vector<setsquare::Scan> scans;
    const auto reader = setsquare::open_log(argv[1]);
    while (const auto* record = reader->next()) scans.push_back(record->scan);

    const setsquare::MatchResult result = setsquare::match(scans.front(), scans.back());
    std::cout << setsquare::to_string(result.status) << "\n";
    if (result.T_reference_current) {
      std::cout << result.T_reference_current->x_m << " m, " << result.T_reference_current->y_m
                << " m, " << result.T_reference_current->theta_rad << " rad\n";
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
