// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Feeds files, or the files of folders, to a fuzz target without libFuzzer: the corpus becomes a
// test that any compiler builds. Usage: replay TARGET FILE_OR_FOLDER...
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "fuzz/fuzz_target.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool replay(setsquare::fuzz::Target* target, const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  std::cout << path.string() << " (" << data.size() << " bytes)" << std::endl;
  return target(data.data(), data.size()) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  setsquare::fuzz::Target* target = argc > 1 ? setsquare::fuzz::target_named(argv[1]) : nullptr;
  if (target == nullptr) {
    std::cerr << "usage: replay TARGET FILE_OR_FOLDER...\n";
    return 2;
  }
  std::size_t num_files = 0;
  for (int i = 2; i < argc; ++i) {
    for (const fs::path& path : files_below(argv[i])) {
      if (!replay(target, path)) {
        std::cerr << path.string() << ": cannot be replayed\n";
        return 1;
      }
      ++num_files;
    }
  }
  if (num_files == 0) std::cerr << "no file to replay\n";
  return num_files == 0 ? 1 : 0;
}
