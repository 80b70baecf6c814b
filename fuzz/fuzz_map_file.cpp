// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <string>

#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bytes/crc32.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map_summary.hpp"

namespace {

using namespace setsquare;

/// Writes the right checksum behind `num_bytes` bytes from `begin` on, of what follows too.
void mend_sum(std::string& bytes, std::size_t begin, std::size_t num_bytes, std::size_t num_after) {
  const std::string_view all = bytes;
  const std::size_t sum_at = begin + num_bytes;
  const std::string_view after = all.substr(sum_at + sizeof(std::uint32_t), num_after);
  const std::uint32_t sum = crc32_of(after, crc32_of(all.substr(begin, num_bytes)));
  std::memcpy(bytes.data() + sum_at, &sum, sizeof(sum));
}

/// Bytes whose checksums are right, as far as they have the form of a map file: what the fuzzer
/// changes gets behind them.
std::string with_mended_sums(std::string bytes) {
  constexpr std::size_t kHeadBytes = 16;
  constexpr std::size_t kSectionHeadBytes = 24;
  constexpr std::size_t kSumBytes = 4;
  if (bytes.size() < kHeadBytes + kSumBytes) return bytes;
  mend_sum(bytes, 0, kHeadBytes, 0);
  std::size_t at = kHeadBytes + kSumBytes;
  while (bytes.size() - at >= kSectionHeadBytes + kSumBytes) {
    std::uint64_t num_stored = 0;
    std::memcpy(&num_stored, bytes.data() + at + 8, sizeof(num_stored));
    const std::size_t num_left = bytes.size() - at - kSectionHeadBytes - kSumBytes;
    if (num_stored > num_left) return bytes;
    mend_sum(bytes, at, kSectionHeadBytes, num_stored);
    at += kSectionHeadBytes + kSumBytes + num_stored;
  }
  return bytes;
}

/// Law: what was read is a valid map, can be written, reads back and is written the same.
void read_and_write(const std::string& bytes) {
  try {
    const SavedMap saved = map_from_bytes(bytes, "fuzz");
    validate(saved.map);
    fuzz::require(summary_of(saved.map).num_scans == saved.map.scans.size());
    fuzz::require(placed_scans(saved.map).size() <= saved.map.kept_scans.size());
    const std::string written = map_file_bytes(saved.map, saved.record);
    const SavedMap again = map_from_bytes(written, "fuzz");
    fuzz::require(map_file_bytes(again.map, again.record) == written);
  } catch (const FormatError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::bytes_from(data, size);
  read_and_write(bytes);
  read_and_write(with_mended_sums(bytes));
  return 0;
}
