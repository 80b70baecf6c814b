// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// The unpacked bytes of a gzip stream (RFC 1952), several members in a row included. Where the
/// stream is cut short or corrupt the bytes end there, and damage() says why.
class GzipSource final : public ByteSource {
 public:
  explicit GzipSource(std::unique_ptr<ByteSource> packed);
  ~GzipSource() override;
  GzipSource(const GzipSource&) = delete;
  GzipSource& operator=(const GzipSource&) = delete;

  std::size_t read(std::span<char> bytes) override;
  std::optional<double> fraction_read() const override { return packed_->fraction_read(); }
  std::string damage() const override { return damage_; }

 private:
  struct Inflater;

  bool refill();

  std::unique_ptr<ByteSource> packed_;
  std::vector<char> input_;
  std::unique_ptr<Inflater> inflater_;
  std::string damage_;
  bool is_at_member_start_ = true;
  bool is_finished_ = false;
};

}  // namespace setsquare
