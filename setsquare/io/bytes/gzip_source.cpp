// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/gzip_source.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace setsquare {
namespace {

constexpr std::size_t kInputBytes = 1 << 16;
constexpr int kGzipOnly = 16 + MAX_WBITS;

/// zlib takes bytes as unsigned char; the same bytes, another type.
Bytef* as_zlib_bytes(char* bytes) { return reinterpret_cast<Bytef*>(bytes); }

}  // namespace

struct GzipSource::Inflater {
  Inflater() {
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream); }

  z_stream stream{};
};

GzipSource::GzipSource(std::unique_ptr<ByteSource> packed)
    : packed_(std::move(packed)), input_(kInputBytes), inflater_(std::make_unique<Inflater>()) {}

GzipSource::~GzipSource() = default;

bool GzipSource::refill() {
  const std::size_t num_read = packed_->read(input_);
  inflater_->stream.next_in = as_zlib_bytes(input_.data());
  inflater_->stream.avail_in = static_cast<uInt>(num_read);
  return num_read > 0;
}

std::size_t GzipSource::read(std::span<char> bytes) {
  z_stream& stream = inflater_->stream;
  const std::size_t num_wanted =
      std::min(bytes.size(), std::size_t{std::numeric_limits<uInt>::max()});
  stream.next_out = as_zlib_bytes(bytes.data());
  stream.avail_out = static_cast<uInt>(num_wanted);
  while (!is_finished_ && stream.avail_out == num_wanted && num_wanted > 0) {
    if (stream.avail_in == 0 && !refill()) {
      is_finished_ = true;
      if (!is_at_member_start_) damage_ = "the gzip stream is cut short";
      break;
    }
    const int outcome = inflate(&stream, Z_NO_FLUSH);
    is_at_member_start_ = outcome == Z_STREAM_END;
    if (outcome == Z_STREAM_END) {
      inflateReset(&stream);
    } else if (outcome != Z_OK && outcome != Z_BUF_ERROR) {
      is_finished_ = true;
      damage_ = std::string("the gzip stream is corrupt") +
                (stream.msg != nullptr ? std::string(" (") + stream.msg + ")" : std::string());
    }
  }
  return num_wanted - stream.avail_out;
}

}  // namespace setsquare
