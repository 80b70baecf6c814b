// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/crc32.hpp"

#include <zlib.h>

namespace setsquare {

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t sum_before) {
  return static_cast<std::uint32_t>(
      crc32_z(sum_before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace setsquare
