// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/input_buffer.hpp"

#include <algorithm>
#include <utility>

namespace setsquare {
namespace {

/// Reads begin small, for small files, and double.
constexpr std::size_t kFirstReadBytes = 1 << 12;
constexpr std::size_t kLargestReadBytes = 1 << 18;

}  // namespace

InputBuffer::InputBuffer(std::unique_ptr<ByteSource> source)
    : source_(std::move(source)), num_read_bytes_(kFirstReadBytes) {}

void InputBuffer::make_room(std::size_t num_bytes) {
  if (bytes_.size() - end_ >= num_bytes) return;
  std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(begin_),
            bytes_.begin() + static_cast<std::ptrdiff_t>(end_),
            bytes_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (bytes_.size() - end_ < num_bytes) bytes_.resize(end_ + 2 * num_bytes);
}

bool InputBuffer::fill() {
  make_room(num_read_bytes_);
  num_read_bytes_ = std::min(2 * num_read_bytes_, kLargestReadBytes);
  const std::size_t num_read = source_->read(std::span(bytes_).subspan(end_));
  end_ += num_read;
  return num_read > 0;
}

bool InputBuffer::ensure(std::size_t num_bytes) {
  while (available().size() < num_bytes) {
    if (!fill()) return false;
  }
  return true;
}

}  // namespace setsquare
