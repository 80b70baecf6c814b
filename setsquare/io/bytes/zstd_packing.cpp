// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/zstd_packing.hpp"

#include <zstd.h>

#include "setsquare/core/error.hpp"

namespace setsquare {

void pack_zstd(std::string_view bytes, int level, std::string& packed) {
  packed.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0U) throw Error(std::string("zstd: ") + ZSTD_getErrorName(size));
  packed.resize(size);
}

std::string zstd_packed(std::string_view bytes, int level) {
  std::string packed;
  pack_zstd(bytes, level, packed);
  return packed;
}

}  // namespace setsquare
