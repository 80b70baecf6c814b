// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/block_unpacker.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <span>

namespace setsquare {
namespace {

/// A little more than the block needs, so that its end is seen without growing once more.
constexpr std::size_t kSpareBlockBytes = 64;
/// A stated size is believed at once up to this many times the packed bytes; scans pack to a third.
constexpr std::size_t kUsualRatio = 16;
constexpr std::size_t kFirstBlockBytes = 1 << 12;

}  // namespace

/// How many bytes a step takes and gives at most.
struct BlockUnpacker::Pace {
  std::size_t num_taken;
  std::size_t num_given;
};

Decompressor& BlockUnpacker::decompressor(Packing packing) {
  auto& place = decompressors_[static_cast<std::size_t>(packing)];
  if (!place) place = make_decompressor(packing);
  return *place;
}

void BlockUnpacker::make_room(std::size_t num_bytes_packed,
                              std::optional<std::uint64_t> num_bytes_stated) {
  const std::uint64_t usual = kFirstBlockBytes + kUsualRatio * std::uint64_t{num_bytes_packed};
  const std::uint64_t wanted =
      std::min({usual, num_bytes_stated.value_or(usual), std::uint64_t{max_block_bytes_}});
  const auto num_bytes = static_cast<std::size_t>(wanted) + kSpareBlockBytes;
  if (bytes_.size() < num_bytes) bytes_.resize(num_bytes);
}

BlockUnpacker::Block BlockUnpacker::unpack_frames(Packing packing,
                                                  std::string_view packed,
                                                  const Pace& pace) {
  Decompressor& frames = decompressor(packing);
  frames.begin_frame();
  Block block;
  std::size_t num_taken = 0;
  std::size_t num_given = 0;
  while (block.damage.empty() && block.num_packed_bytes < packed.size()) {
    if (num_given == bytes_.size()) {
      bytes_.resize(std::min(2 * bytes_.size(), max_block_bytes_ + kSpareBlockBytes));
    }
    const Decompressor::Step step =
        frames.unpack(packed.substr(num_taken, pace.num_taken),
                      std::span(bytes_).subspan(num_given).first(
                          std::min(pace.num_given, bytes_.size() - num_given)));
    num_taken += step.num_taken;
    num_given += step.num_given;
    if (step.outcome == Decompressor::Outcome::kFrameEnd) {
      block.num_packed_bytes = num_taken;
      frames.begin_frame();
    } else if (step.outcome == Decompressor::Outcome::kCorrupt) {
      const std::string reason = frames.reason();
      block.damage = reason.empty() ? "corrupt" : "corrupt (" + reason + ")";
    } else if (step.num_taken == 0 && step.num_given == 0) {
      block.damage = "cut short";
    }
    if (num_given > max_block_bytes_) {
      num_given = max_block_bytes_;
      block.damage = fmt::format("of more than {} bytes", max_block_bytes_);
    }
  }
  block.bytes = {bytes_.data(), num_given};
  return block;
}

BlockUnpacker::Block BlockUnpacker::unpack(Packing packing,
                                           std::string_view packed,
                                           std::optional<std::uint64_t> num_bytes_stated) {
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  constexpr Pace kFast{kAll, kAll};
  /// A step that fails gives nothing, so the way up to the damage is gone again in small ones.
  constexpr Pace kCareful{1 << 10, 1 << 16};
  make_room(packed.size(), num_bytes_stated);
  Block block = unpack_frames(packing, packed, kFast);
  if (!block.damage.empty()) block = unpack_frames(packing, packed, kCareful);
  if (block.damage.empty() && num_bytes_stated && block.bytes.size() != *num_bytes_stated) {
    block.damage = fmt::format(
        "of {} bytes unpacked, not of {} as stated", block.bytes.size(), *num_bytes_stated);
  }
  return block;
}

}  // namespace setsquare
