// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/sqlite/pages.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/sqlite/big_endian.hpp"

namespace setsquare::sqlite {
namespace {

constexpr std::string_view kDatabaseMagic("SQLite format 3\0", 16);

/// Places in the header with which the first page begins
/// (https://www.sqlite.org/fileformat2.html, section 1.3).
constexpr std::size_t kDatabaseHeaderBytes = 100;
constexpr std::size_t kPageBytesAt = 16;
constexpr std::size_t kChangeCounterAt = 24;
constexpr std::size_t kNumPagesAt = 28;
constexpr std::size_t kNumPagesIsOfChangeAt = 92;

std::uint32_t page_bytes_in(std::span<const char> header) {
  const std::uint32_t stated = big_endian_32(header.subspan(kPageBytesAt)) >> 16;
  return stated == 1 ? 65536 : stated;
}

/// The number of pages, where the program that wrote the file last kept it up to date.
std::optional<std::uint32_t> num_pages_in(std::span<const char> header) {
  const bool is_up_to_date = big_endian_32(header.subspan(kChangeCounterAt)) ==
                             big_endian_32(header.subspan(kNumPagesIsOfChangeAt));
  const std::uint32_t num_pages = big_endian_32(header.subspan(kNumPagesAt));
  if (!is_up_to_date || num_pages == 0) return std::nullopt;
  return num_pages;
}

}  // namespace

bool is_database(std::string_view beginning) { return beginning.starts_with(kDatabaseMagic); }

Pages::Pages(SeekableFile file, std::optional<SeekableFile> write_ahead_log)
    : file_(std::move(file)) {
  if (write_ahead_log) log_.emplace(std::move(*write_ahead_log));
  if (log_ && log_->page_bytes() == 0) log_.reset();
  measure();
}

void Pages::measure() {
  std::array<char, kDatabaseHeaderBytes> header{};
  const bool is_first_page_in_log = log_ && log_->offset_of(1);
  const std::size_t num_read = is_first_page_in_log
                                   ? log_->file().read_at(*log_->offset_of(1), header)
                                   : file_.read_at(0, header);
  if (num_read == 0) throw FormatError(name(), "", "the file is empty");
  const std::string_view beginning(header.data(), num_read);
  if (!is_database(beginning) && !kDatabaseMagic.starts_with(beginning)) {
    throw FormatError(name(), "", "not an SQLite file");
  }
  page_bytes_ = num_read < header.size() ? 0 : page_bytes_in(header);
  if (num_read == header.size() && !is_page_size(page_bytes_)) {
    throw FormatError(name(), "", "an SQLite file whose header is damaged: no such size of pages");
  }
  if (log_ && log_->page_bytes() != page_bytes_) log_.reset();
  num_pages_ = log_              ? log_->num_pages()
               : page_bytes_ > 0 ? static_cast<std::uint32_t>(file_.size() / page_bytes_)
                                 : 0;
  if (num_pages_ == 0) {
    throw FormatError(name(), "", "an SQLite file that is cut short within its first page");
  }
  num_pages_stated_ = log_ ? num_pages_ : num_pages_in(header).value_or(num_pages_);
}

std::size_t Pages::read_at(std::uint64_t offset, std::span<char> bytes) const {
  if (offset >= size_bytes()) return 0;
  const std::span<char> wanted = bytes.first(
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), size_bytes() - offset)));
  const auto page = static_cast<std::uint32_t>(offset / page_bytes_ + 1);
  const auto in_log = log_ ? log_->offset_of(page) : std::nullopt;
  const std::size_t num_read = in_log ? log_->file().read_at(*in_log + offset % page_bytes_, wanted)
                                      : file_.read_at(offset, wanted);
  // A number of pages that is 0 makes SQLite ask for the file's size.
  for (std::size_t at = kNumPagesAt; at < kNumPagesAt + 4; ++at) {
    if (at >= offset && at - offset < num_read) bytes[at - offset] = '\0';
  }
  return num_read;
}

}  // namespace setsquare::sqlite
