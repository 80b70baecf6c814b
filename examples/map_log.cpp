// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The map of a log, in the files that `setsquare map` writes: map_log LOG FOLDER
#include <exception>
#include <iostream>
#include <string>

#include "setsquare/setsquare.hpp"

namespace {

void map_log(const char* path, const char* folder) {
  setsquare::Mapper mapper;
  const auto log = setsquare::open_log(path);
  while (const auto* record = log->next()) mapper.add(record->scan, record->T_odom_base);

  const setsquare::Map map = mapper.finish();
  for (const std::string& name : setsquare::save_map(map, folder)) std::cout << name << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    map_log(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
