// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/decompressor.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <new>

namespace setsquare {
namespace {

/// What zlib and bzip2 count in one step.
template <typename Bytes>
unsigned bounded_size(const Bytes& bytes) {
  return static_cast<unsigned>(
      std::min(bytes.size(), std::size_t{std::numeric_limits<unsigned>::max()}));
}

class GzipDecompressor final : public Decompressor {
 public:
  GzipDecompressor() {
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw std::bad_alloc();
  }
  GzipDecompressor(const GzipDecompressor&) = delete;
  GzipDecompressor& operator=(const GzipDecompressor&) = delete;
  ~GzipDecompressor() override { inflateEnd(&stream_); }

  void begin_frame() override { inflateReset(&stream_); }

  Step unpack(std::string_view packed, std::span<char> bytes) override {
    // zlib takes bytes as unsigned char, and leaves those of the input as they are.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream_.avail_in = bounded_size(packed);
    stream_.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream_.avail_out = bounded_size(bytes);
    const int outcome = inflate(&stream_, Z_NO_FLUSH);
    Step step{.num_taken = bounded_size(packed) - stream_.avail_in,
              .num_given = bounded_size(bytes) - stream_.avail_out};
    if (outcome == Z_STREAM_END) {
      step.outcome = Outcome::kFrameEnd;
    } else if (outcome != Z_OK && outcome != Z_BUF_ERROR) {
      step.outcome = Outcome::kCorrupt;
    }
    return step;
  }

  std::string reason() const override { return stream_.msg != nullptr ? stream_.msg : ""; }

 private:
  z_stream stream_{};
};

class Bzip2Decompressor final : public Decompressor {
 public:
  Bzip2Decompressor() { begin(); }
  Bzip2Decompressor(const Bzip2Decompressor&) = delete;
  Bzip2Decompressor& operator=(const Bzip2Decompressor&) = delete;
  ~Bzip2Decompressor() override { BZ2_bzDecompressEnd(&stream_); }

  void begin_frame() override {
    BZ2_bzDecompressEnd(&stream_);
    begin();
  }

  Step unpack(std::string_view packed, std::span<char> bytes) override {
    stream_.next_in = const_cast<char*>(packed.data());
    stream_.avail_in = bounded_size(packed);
    stream_.next_out = bytes.data();
    stream_.avail_out = bounded_size(bytes);
    const int outcome = BZ2_bzDecompress(&stream_);
    Step step{.num_taken = bounded_size(packed) - stream_.avail_in,
              .num_given = bounded_size(bytes) - stream_.avail_out};
    if (outcome == BZ_STREAM_END) {
      step.outcome = Outcome::kFrameEnd;
    } else if (outcome != BZ_OK) {
      step.outcome = Outcome::kCorrupt;
    }
    return step;
  }

 private:
  void begin() {
    stream_ = {};
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }

  bz_stream stream_{};
};

class Lz4Decompressor final : public Decompressor {
 public:
  Lz4Decompressor() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION))) {
      throw std::bad_alloc();
    }
  }
  Lz4Decompressor(const Lz4Decompressor&) = delete;
  Lz4Decompressor& operator=(const Lz4Decompressor&) = delete;
  ~Lz4Decompressor() override { LZ4F_freeDecompressionContext(context_); }

  void begin_frame() override { LZ4F_resetDecompressionContext(context_); }

  Step unpack(std::string_view packed, std::span<char> bytes) override {
    std::size_t num_taken = packed.size();
    std::size_t num_given = bytes.size();
    const std::size_t outcome =
        LZ4F_decompress(context_, bytes.data(), &num_given, packed.data(), &num_taken, nullptr);
    if (LZ4F_isError(outcome)) {
      reason_ = LZ4F_getErrorName(outcome);
      return {.outcome = Outcome::kCorrupt};
    }
    const bool is_at_end = outcome == 0;
    return {num_taken, num_given, is_at_end ? Outcome::kFrameEnd : Outcome::kGoesOn};
  }

  std::string reason() const override { return reason_; }

 private:
  LZ4F_dctx* context_ = nullptr;
  std::string reason_;
};

class ZstdDecompressor final : public Decompressor {
 public:
  ZstdDecompressor() : context_(ZSTD_createDCtx()) {
    if (context_ == nullptr) throw std::bad_alloc();
  }
  ZstdDecompressor(const ZstdDecompressor&) = delete;
  ZstdDecompressor& operator=(const ZstdDecompressor&) = delete;
  ~ZstdDecompressor() override { ZSTD_freeDCtx(context_); }

  void begin_frame() override { ZSTD_DCtx_reset(context_, ZSTD_reset_session_only); }

  Step unpack(std::string_view packed, std::span<char> bytes) override {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{bytes.data(), bytes.size(), 0};
    const std::size_t outcome = ZSTD_decompressStream(context_, &out, &in);
    if (ZSTD_isError(outcome) != 0) {
      reason_ = ZSTD_getErrorName(outcome);
      return {.outcome = Outcome::kCorrupt};
    }
    const bool is_at_end = outcome == 0;
    return {in.pos, out.pos, is_at_end ? Outcome::kFrameEnd : Outcome::kGoesOn};
  }

  std::string reason() const override { return reason_; }

 private:
  ZSTD_DCtx* context_ = nullptr;
  std::string reason_;
};

}  // namespace

std::string_view name_of(Packing packing) {
  switch (packing) {
    case Packing::kGzip:
      return "gzip";
    case Packing::kBzip2:
      return "bzip2";
    case Packing::kLz4:
      return "lz4";
    case Packing::kZstd:
      return "zstd";
  }
  assert(false);
  return {};
}

std::optional<Packing> packing_at(std::string_view beginning) {
  const bool is_bzip2 = beginning.size() >= kMagicBytes && beginning.starts_with("BZh") &&
                        beginning[3] >= '1' && beginning[3] <= '9';
  if (beginning.starts_with("\x1f\x8b")) return Packing::kGzip;
  if (is_bzip2) return Packing::kBzip2;
  if (beginning.starts_with("\x04\x22\x4d\x18")) return Packing::kLz4;
  if (beginning.starts_with("\x28\xb5\x2f\xfd")) return Packing::kZstd;
  return std::nullopt;
}

std::unique_ptr<Decompressor> make_decompressor(Packing packing) {
  switch (packing) {
    case Packing::kGzip:
      return std::make_unique<GzipDecompressor>();
    case Packing::kBzip2:
      return std::make_unique<Bzip2Decompressor>();
    case Packing::kLz4:
      return std::make_unique<Lz4Decompressor>();
    case Packing::kZstd:
      return std::make_unique<ZstdDecompressor>();
  }
  assert(false);
  return nullptr;
}

}  // namespace setsquare
