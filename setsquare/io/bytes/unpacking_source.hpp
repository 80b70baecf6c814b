// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/decompressor.hpp"

namespace setsquare {

/// The unpacked bytes of a packed stream, several frames (gzip: members) in a row included. Where
/// the stream is cut short or corrupt the bytes end there, and damage() says why.
class UnpackingSource final : public ByteSource {
 public:
  UnpackingSource(std::unique_ptr<ByteSource> packed, Packing packing);

  std::size_t read(std::span<char> bytes) override;
  std::optional<double> fraction_read() const override { return packed_->fraction_read(); }
  std::string damage() const override { return damage_; }

 private:
  bool refill();
  void end_with(std::string_view what, const std::string& reason);

  std::unique_ptr<ByteSource> packed_;
  Packing packing_;
  std::unique_ptr<Decompressor> decompressor_;
  std::vector<char> input_;
  std::string_view unread_;  ///< What of input_ is still to be unpacked.
  std::string damage_;
  bool is_at_frame_start_ = true;
  bool is_finished_ = false;
};

}  // namespace setsquare
