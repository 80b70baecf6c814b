// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/unpacking_source.hpp"

#include <fmt/core.h>

#include <utility>

namespace setsquare {
namespace {

constexpr std::size_t kInputBytes = 1 << 16;

}  // namespace

UnpackingSource::UnpackingSource(std::unique_ptr<ByteSource> packed, Packing packing)
    : packed_(std::move(packed)),
      packing_(packing),
      decompressor_(make_decompressor(packing)),
      input_(kInputBytes) {}

bool UnpackingSource::refill() {
  unread_ = {input_.data(), packed_->read(input_)};
  return !unread_.empty();
}

void UnpackingSource::end_with(std::string_view what, const std::string& reason) {
  is_finished_ = true;
  damage_ = fmt::format("the {} stream is {}", name_of(packing_), what);
  if (!reason.empty()) damage_ += " (" + reason + ")";
}

std::size_t UnpackingSource::read(std::span<char> bytes) {
  std::size_t num_given = 0;
  while (!is_finished_ && num_given == 0 && !bytes.empty()) {
    const bool has_packed = !unread_.empty() || refill();
    if (!has_packed && is_at_frame_start_) {
      is_finished_ = true;
      damage_ = packed_->damage();
      break;
    }
    // Without packed bytes, too: the decompressor may still hold some that it has unpacked.
    const Decompressor::Step step = decompressor_->unpack(unread_, bytes);
    unread_.remove_prefix(step.num_taken);
    num_given = step.num_given;
    is_at_frame_start_ = step.outcome == Decompressor::Outcome::kFrameEnd;
    if (is_at_frame_start_) {
      decompressor_->begin_frame();
    } else if (step.outcome == Decompressor::Outcome::kCorrupt) {
      end_with("corrupt", decompressor_->reason());
    } else if (!has_packed && num_given == 0) {
      end_with("cut short", packed_->damage());
    }
  }
  return num_given;
}

}  // namespace setsquare
