// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/input_buffer.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace setsquare {
namespace {

/// Reads begin small, for small files, and double.
constexpr std::size_t kFirstReadBytes = 1 << 12;
constexpr std::size_t kLargestReadBytes = 1 << 18;

}  // namespace

InputBuffer::InputBuffer(std::unique_ptr<ByteSource> source)
    : ByteWindow({}), source_(std::move(source)), num_read_bytes_(kFirstReadBytes) {}

/// Makes room for num_bytes bytes behind those available; returns where that room begins.
std::size_t InputBuffer::make_room(std::size_t num_bytes) {
  const std::size_t num_kept = available().size();
  const std::size_t begin =
      num_kept > 0 ? static_cast<std::size_t>(available().data() - bytes_.data()) : 0;
  std::size_t end = begin + num_kept;
  if (bytes_.size() - end >= num_bytes) return end;
  if (begin > 0) std::memmove(bytes_.data(), bytes_.data() + begin, num_kept);
  end = num_kept;
  if (bytes_.size() - end < num_bytes) bytes_.resize(end + 2 * num_bytes);
  set_available({bytes_.data(), num_kept});
  return end;
}

bool InputBuffer::fill() {
  const std::size_t end = make_room(num_read_bytes_);
  num_read_bytes_ = std::min(2 * num_read_bytes_, kLargestReadBytes);
  const std::size_t num_read = source_->read(std::span(bytes_).subspan(end));
  const std::size_t num_kept = available().size();
  set_available({bytes_.data() + end - num_kept, num_kept + num_read});
  return num_read > 0;
}

std::uint64_t InputBuffer::skip(std::uint64_t num_bytes) {
  const std::uint64_t num_held = ByteWindow::skip(num_bytes);
  if (num_held == num_bytes) return num_held;
  const std::uint64_t num_jumped = source_->skip(num_bytes - num_held);
  pass_over(num_jumped);
  // Who jumps once will jump again: what the next read would take too much is copied for nothing.
  num_read_bytes_ = kFirstReadBytes;
  return num_held + num_jumped;
}

}  // namespace setsquare
