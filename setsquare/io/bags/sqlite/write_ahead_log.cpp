// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/sqlite/write_ahead_log.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/io/bags/sqlite/big_endian.hpp"

namespace setsquare::sqlite {
namespace {

constexpr std::size_t kLogHeaderBytes = 32;
constexpr std::size_t kFrameHeaderBytes = 24;
/// The last bit tells in which byte order the checksum's words are read: 1 for big-endian.
constexpr std::uint32_t kLogMagic = 0x377f0682;

/// The checksum of all that stands before in the log: two words that depend on each other.
class Checksum {
 public:
  explicit Checksum(bool is_big_endian) : is_big_endian_(is_big_endian) {}

  void add(std::span<const char> bytes) {
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
      first_ += word(bytes) + second_;
      second_ += word(bytes.subspan(4)) + first_;
    }
  }
  [[nodiscard]] bool is_stated_by(std::span<const char> bytes) const {
    return big_endian_32(bytes) == first_ && big_endian_32(bytes.subspan(4)) == second_;
  }

 private:
  [[nodiscard]] std::uint32_t word(std::span<const char> bytes) const {
    return is_big_endian_ ? big_endian_32(bytes) : little_endian_32(bytes);
  }

  bool is_big_endian_;
  std::uint32_t first_ = 0;
  std::uint32_t second_ = 0;
};

/// A frame: the number of its page, the database's size where it ends a transaction (else 0), the
/// log's salt, the checksum, the page.
struct Frame {
  std::span<const char> bytes;

  [[nodiscard]] std::uint32_t page() const { return big_endian_32(bytes); }
  [[nodiscard]] std::uint32_t num_pages_committed() const {
    return big_endian_32(bytes.subspan(4));
  }
  [[nodiscard]] bool is_whole(std::span<const char> salt, Checksum& checksum) const {
    checksum.add(bytes.first(8));
    checksum.add(bytes.subspan(kFrameHeaderBytes));
    return std::ranges::equal(salt, bytes.subspan(8, 8)) &&
           checksum.is_stated_by(bytes.subspan(16));
  }
};

}  // namespace

WriteAheadLog::WriteAheadLog(SeekableFile file) : file_(std::move(file)) {
  std::vector<char> header(kLogHeaderBytes);
  if (file_.read_at(0, header) < header.size()) return;
  const std::span<const char> head(header);
  const std::uint32_t magic = big_endian_32(head);
  page_bytes_ = big_endian_32(head.subspan(8));
  if ((magic & ~1U) != kLogMagic || !is_page_size(page_bytes_)) return;

  Checksum checksum((magic & 1U) != 0);
  checksum.add(head.first(24));
  if (!checksum.is_stated_by(head.subspan(24))) return;

  Transaction begun;
  std::vector<char> bytes(kFrameHeaderBytes + page_bytes_);
  for (std::uint64_t offset = header.size(); file_.read_at(offset, bytes) == bytes.size();
       offset += bytes.size()) {
    const Frame frame{bytes};
    if (!frame.is_whole(head.subspan(16, 8), checksum)) return;
    begun[frame.page()] = offset + kFrameHeaderBytes;
    if (frame.num_pages_committed() > 0) commit(begun, frame.num_pages_committed());
  }
}

void WriteAheadLog::commit(Transaction& transaction, std::uint32_t num_pages) {
  num_pages_ = num_pages;
  for (const auto& [page, offset] : transaction) offset_of_page_[page] = offset;
  transaction.clear();
}

std::optional<std::uint64_t> WriteAheadLog::offset_of(std::uint32_t page) const {
  const auto found = offset_of_page_.find(page);
  if (found == offset_of_page_.end()) return std::nullopt;
  return found->second;
}

}  // namespace setsquare::sqlite
