// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The relative pose of the first and the last scan of a log: match_two_scans LOG
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "setsquare/setsquare.hpp"

namespace {

void match_first_and_last(const char* path) {
  std::vector<setsquare::Scan> scans;
  const auto log = setsquare::open_log(path);
  while (const auto* record = log->next()) scans.push_back(record->scan);
  if (scans.empty()) throw std::runtime_error(std::string(path) + ": no scans");

  const auto match = setsquare::match(scans.front(), scans.back());
  std::cout << setsquare::to_string(match.status) << "\n";  // "matched", "ambiguous", ...
  if (const auto& pose = match.T_reference_current) {
    std::cout << pose->x_m << " m, " << pose->y_m << " m, " << pose->theta_rad << " rad\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    match_first_and_last(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
