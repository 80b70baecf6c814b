// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/unpacking_source.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/io/packing.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::unpacking_source_test {

using testing::long_text;
using testing::pack;

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

class UnpackingSourceOf : public ::testing::TestWithParam<Packing> {};

TEST_P(UnpackingSourceOf, UnpacksWhateverTheChunks) {
  const std::string text = long_text();
  for (const std::size_t at_once : {1, 3, 1000, 1000000}) {
    const Unpacked unpacked = unpack_all(pack(GetParam(), text), at_once);
    EXPECT_EQ(unpacked.bytes, text);
    EXPECT_EQ(unpacked.damage, "");
  }
}

TEST_P(UnpackingSourceOf, ReadsSeveralFramesAsOne) {
  const std::string packed =
      pack(GetParam(), "one ") + pack(GetParam(), "") + pack(GetParam(), "two");
  EXPECT_EQ(unpack_all(packed, 5).bytes, "one two");
}

TEST_P(UnpackingSourceOf, ACutStreamGivesItsBeginningAndSaysSo) {
  const std::string text = long_text();
  const std::string packed = pack(GetParam(), text);
  const std::string says = "the " + std::string(name_of(GetParam())) + " stream is cut short";
  std::size_t num_most = 0;
  for (std::size_t length = kMagicBytes; length < packed.size(); length += 7) {
    const Unpacked unpacked = unpack_all(packed.substr(0, length), 100);
    EXPECT_EQ(unpacked.bytes, text.substr(0, unpacked.bytes.size()));
    EXPECT_GE(unpacked.bytes.size(), num_most);
    EXPECT_EQ(unpacked.damage, says) << length;
    num_most = unpacked.bytes.size();
  }
  EXPECT_GT(num_most, 0U);
}

TEST_P(UnpackingSourceOf, AFlippedBitThatMattersIsNoticedByTheEnd) {
  const std::string text = long_text();
  const std::string packed = pack(GetParam(), text);
  std::size_t num_unnoticed = 0;
  for (std::size_t at = 20; at < packed.size(); at += 11) {
    std::string flipped = packed;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    const Unpacked unpacked = unpack_all(flipped, 1000);
    EXPECT_TRUE(!unpacked.damage.empty() || unpacked.bytes == text) << at;
    if (unpacked.damage.empty()) ++num_unnoticed;
  }
  EXPECT_LE(num_unnoticed, 1U);  // the last bits of bzip2 fill up a byte
}

TEST_P(UnpackingSourceOf, PackedTwiceTellsOfTheInnerDamage) {
  const std::string packed = pack(GetParam(), long_text());
  const std::string cut = testing::pack_gzip(packed.substr(0, packed.size() / 2));
  const auto source = unpack(unpack(make_memory_source(cut.substr(0, cut.size() - 20))));
  source->skip(long_text().size());
  EXPECT_NE(source->damage().find("cut short"), std::string::npos);
  EXPECT_NE(source->damage().find("gzip"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(EveryPacking,
                         UnpackingSourceOf,
                         ::testing::ValuesIn(kPackings),
                         [](const auto& packing) { return std::string(name_of(packing.param)); });

TEST(UnpackingSource, PlainBytesPassUnchanged) {
  for (const char* text :
       {"", "\x1f", "\x1fx", "plain", "BZh", "BZhx", "\x04\x22\x4d", "\x28\xb5"}) {
    EXPECT_EQ(unpack_all(text, 1).bytes, text);
    EXPECT_EQ(unpack_all(text, 1).damage, "");
  }
}

}  // namespace setsquare::unpacking_source_test
