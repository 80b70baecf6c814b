// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Packs bytes, for the tests of what unpacks them.
#pragma once

#include <bzlib.h>
#include <gtest/gtest.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdint>
#include <string>

#include "setsquare/io/bytes/decompressor.hpp"

namespace setsquare::testing {

inline std::string pack_gzip(std::string bytes) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string pack_bzip2(std::string bytes) {
  std::string packed(bytes.size() + bytes.size() / 50 + 1000, '\0');
  auto num_packed = static_cast<unsigned>(packed.size());
  constexpr int kBlocksOf100Kb = 1;  // several blocks soon, as in large files
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(packed.data(),
                                     &num_packed,
                                     bytes.data(),
                                     static_cast<unsigned>(bytes.size()),
                                     kBlocksOf100Kb,
                                     0,
                                     0),
            BZ_OK);
  packed.resize(num_packed);
  return packed;
}

/// With a checksum of the whole, as ROS 1 writes it.
inline std::string pack_lz4(const std::string& bytes) {
  LZ4F_preferences_t preferences = LZ4F_INIT_PREFERENCES;
  preferences.frameInfo.blockSizeID = LZ4F_max64KB;
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string packed(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t num_packed =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
  EXPECT_EQ(LZ4F_isError(num_packed), 0U);
  packed.resize(num_packed);
  return packed;
}

/// In one call, so that the frame states its size; with a checksum.
inline std::string pack_zstd(const std::string& bytes) {
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t num_packed =
      ZSTD_compress2(context, packed.data(), packed.size(), bytes.data(), bytes.size());
  EXPECT_EQ(ZSTD_isError(num_packed), 0U);
  ZSTD_freeCCtx(context);
  packed.resize(num_packed);
  return packed;
}

/// One frame.
inline std::string pack(Packing packing, const std::string& bytes) {
  switch (packing) {
    case Packing::kGzip:
      return pack_gzip(bytes);
    case Packing::kBzip2:
      return pack_bzip2(bytes);
    case Packing::kLz4:
      return pack_lz4(bytes);
    case Packing::kZstd:
      return pack_zstd(bytes);
  }
  return {};
}

/// Text that packs to something of several blocks.
inline std::string long_text(int num_lines = 3000) {
  std::string text;
  for (int i = 0; i < num_lines; ++i) text += "line " + std::to_string(std::int64_t{i} * i) + "\n";
  return text;
}

}  // namespace setsquare::testing
