// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/block_unpacker.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/io/packing.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::block_unpacker_test {

using testing::long_text;
using testing::pack;

class BlockOf : public ::testing::TestWithParam<Packing> {};

TEST_P(BlockOf, IsUnpackedAgainAndAgain) {
  BlockUnpacker unpacker;
  for (const int num_lines : {0, 1, 3000, 50000, 17}) {
    const std::string text = long_text(num_lines);
    const std::string packed = pack(GetParam(), text);
    const auto block = unpacker.unpack(GetParam(), packed, text.size());
    EXPECT_TRUE(block.bytes == text) << num_lines;
    EXPECT_EQ(block.damage, "");
    EXPECT_EQ(block.num_packed_bytes, packed.size());
    EXPECT_TRUE(unpacker.unpack(GetParam(), packed).bytes == text);
  }
}

TEST_P(BlockOf, MayHaveSeveralFramesAndAStrangerBehindThem) {
  BlockUnpacker unpacker;
  const std::string packed =
      pack(GetParam(), "one ") + pack(GetParam(), "") + pack(GetParam(), "two");
  EXPECT_EQ(unpacker.unpack(GetParam(), packed, 7).bytes, "one two");
  const auto block = unpacker.unpack(GetParam(), packed + "something else", 7);
  EXPECT_EQ(block.bytes, "one two");
  EXPECT_EQ(block.num_packed_bytes, packed.size());
  EXPECT_TRUE(block.damage.starts_with("corrupt")) << block.damage;
}

TEST_P(BlockOf, AWrongSizeIsToldAndTheBytesAreGiven) {
  const std::string text = long_text();
  const std::string packed = pack(GetParam(), text);
  for (const std::uint64_t lie : {0UL, 1UL, text.size() - 1, text.size() + 1, 1UL << 40, ~0UL}) {
    BlockUnpacker unpacker;
    const auto block = unpacker.unpack(GetParam(), packed, lie);
    EXPECT_TRUE(block.bytes == text) << lie;
    EXPECT_EQ(block.damage,
              "of " + std::to_string(text.size()) + " bytes unpacked, not of " +
                  std::to_string(lie) + " as stated");
  }
}

TEST_P(BlockOf, WhatIsCutGivesItsBeginning) {
  const std::string text = long_text(30000);
  const std::string packed = pack(GetParam(), text);
  BlockUnpacker unpacker;
  std::size_t num_most = 0;
  for (std::size_t length = 1; length < packed.size(); length += 1 + packed.size() / 50) {
    const auto block = unpacker.unpack(GetParam(), packed.substr(0, length), text.size());
    EXPECT_TRUE(block.bytes == text.substr(0, block.bytes.size()));
    EXPECT_EQ(block.damage, "cut short") << length;
    num_most = std::max(num_most, block.bytes.size());
  }
  EXPECT_GT(num_most, text.size() / 2);
}

TEST_P(BlockOf, WhatIsDamagedGivesWhatStandsBefore) {
  const std::string text = long_text(60000);
  const std::string packed = pack(GetParam(), text);
  auto generator = testing::make_generator();
  BlockUnpacker unpacker;
  for (int round = 0; round < 30; ++round) {
    std::string damaged = packed;
    const auto at = static_cast<std::size_t>(
        testing::uniform(generator, 0.0, static_cast<double>(packed.size())));
    for (std::size_t i = at; i < std::min(packed.size(), at + 50); ++i) damaged[i] = '\xff';
    const auto block = unpacker.unpack(GetParam(), damaged, text.size());
    EXPECT_NE(block.damage, "") << at;
    // Up to the block that holds the damage; bzip2 has blocks of 100 kB, the others smaller ones.
    const double share_before = static_cast<double>(at) / static_cast<double>(packed.size());
    const double num_least = share_before * static_cast<double>(text.size()) - 250e3;
    const std::size_t num_sure = num_least > 0.0 ? static_cast<std::size_t>(num_least) : 0;
    ASSERT_GE(block.bytes.size(), num_sure) << at;
    EXPECT_TRUE(block.bytes.substr(0, num_sure) == text.substr(0, num_sure)) << at;
  }
}

TEST_P(BlockOf, AnySingleWrongByteIsNoticed) {
  const std::string text = long_text(200);
  const std::string packed = pack(GetParam(), text);
  BlockUnpacker unpacker;
  std::size_t num_unnoticed = 0;
  for (std::size_t at = 0; at < packed.size(); ++at) {
    std::string wrong = packed;
    wrong[at] = static_cast<char>(wrong[at] ^ 16);
    const auto block = unpacker.unpack(GetParam(), wrong, text.size());
    if (!block.damage.empty()) continue;
    ++num_unnoticed;
    EXPECT_EQ(block.bytes, text) << at;
  }
  EXPECT_LT(num_unnoticed, 20U);  // bytes that mean nothing: times, systems
}

TEST_P(BlockOf, NoMoreThanTheLimitIsUnpacked) {
  const std::string packed = pack(GetParam(), std::string(5'000'000, '\0'));
  BlockUnpacker unpacker(1'000'000);
  const auto block = unpacker.unpack(GetParam(), packed, 5'000'000);
  EXPECT_EQ(block.bytes.size(), 1'000'000U);
  EXPECT_EQ(block.damage, "of more than 1000000 bytes");
}

INSTANTIATE_TEST_SUITE_P(EveryPacking,
                         BlockOf,
                         ::testing::ValuesIn(kPackings),
                         [](const auto& packing) { return std::string(name_of(packing.param)); });

}  // namespace setsquare::block_unpacker_test
