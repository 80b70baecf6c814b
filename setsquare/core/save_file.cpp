// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "setsquare/core/error.hpp"

namespace setsquare {

void save_file(const std::string& path, std::string_view bytes) {
  const std::string temporary = path + ".part";
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  if (!file) throw FileError(path, std::string("cannot be written: ") + std::strerror(errno));
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error;
  if (file) {
    std::filesystem::rename(temporary, path, error);
    if (!error) return;
  }
  const std::string reason = error ? error.message() : "the disk may be full";
  std::filesystem::remove(temporary, error);
  throw FileError(path, "cannot be written: " + reason);
}

}  // namespace setsquare
