// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/gzip_source.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

#include "setsquare/core/error.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::gzip_source_test {

std::string gzip(std::string bytes) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct Unpacked {
  std::string bytes;
  std::string damage;
};

Unpacked unpack_all(const std::string& packed, std::size_t num_bytes_at_once) {
  const auto source = unpack(std::make_unique<testing::TricklingSource>(packed, num_bytes_at_once));
  Unpacked unpacked;
  std::string block(1000, '\0');
  while (const std::size_t num_read = source->read(block))
    unpacked.bytes.append(block, 0, num_read);
  unpacked.damage = source->damage();
  return unpacked;
}

std::string long_text() {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "line " + std::to_string(i * i) + "\n";
  return text;
}

TEST(GzipSource, UnpacksWhateverTheChunks) {
  const std::string text = long_text();
  for (const std::size_t at_once : {1, 3, 1000, 1000000}) {
    const Unpacked unpacked = unpack_all(gzip(text), at_once);
    EXPECT_EQ(unpacked.bytes, text);
    EXPECT_EQ(unpacked.damage, "");
  }
}

TEST(GzipSource, ReadsSeveralMembersAsOne) {
  EXPECT_EQ(unpack_all(gzip("one ") + gzip("") + gzip("two"), 5).bytes, "one two");
}

TEST(GzipSource, PlainBytesPassUnchanged) {
  for (const char* text : {"", "\x1f", "\x1fx", "plain"}) {
    EXPECT_EQ(unpack_all(text, 1).bytes, text);
  }
}

TEST(GzipSource, ACutStreamGivesItsBeginningAndSaysSo) {
  const std::string text = long_text();
  const std::string packed = gzip(text);
  for (std::size_t length = 2; length < packed.size(); length += 7) {
    const Unpacked unpacked = unpack_all(packed.substr(0, length), 100);
    EXPECT_EQ(unpacked.bytes, text.substr(0, unpacked.bytes.size()));
    EXPECT_EQ(unpacked.damage, "the gzip stream is cut short") << length;
  }
}

TEST(GzipSource, AFlippedBitIsNoticedByTheEnd) {
  const std::string packed = gzip(long_text());
  for (std::size_t at = 20; at < packed.size(); at += 11) {
    std::string flipped = packed;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    EXPECT_NE(unpack_all(flipped, 1000).damage, "") << at;
  }
}

TEST(FileSource, SaysWhyAFileCannotBeRead) {
  EXPECT_THROW(static_cast<void>(open_file_source("/no/such/file")), FileError);
  const auto directory = open_file_source("/");
  std::string block(10, '\0');
  EXPECT_THROW(static_cast<void>(directory->read(block)), FileError);
}

}  // namespace setsquare::gzip_source_test
