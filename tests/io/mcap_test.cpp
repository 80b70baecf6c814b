// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/mcap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/io/mcap_bytes.hpp"
#include "tests/io/read_all.hpp"
#include "tests/io/read_messages.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::mcap_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::mcap_channel;
using testing::mcap_chunk;
using testing::mcap_file;
using testing::mcap_message;
using testing::mcap_message_index;
using testing::mcap_record;
using testing::mcap_schema;
using testing::raw;
using testing::ReadMessage;
using testing::ReadRecording;

ReadRecording read_mcap(const std::string& bytes, MessageSource::IsWanted is_wanted = {}) {
  Mcap source(std::make_unique<InputBuffer>(make_memory_source(bytes)));
  source.set_wanted(std::move(is_wanted));
  return testing::read_all_messages(source);
}

std::string descriptions() {
  return mcap_schema(1, "sensor_msgs/msg/LaserScan", "float32[] ranges") +
         mcap_schema(2, "sensor_msgs/msg/Image", "uint8[] data") + mcap_channel(1, 1, "/scan") +
         mcap_channel(2, 2, "/camera");
}

/// Message number i: scans, and every third an image.
ReadMessage message_of(int i) {
  const bool is_image = i % 3 == 2;
  std::string data;
  for (int k = 0; k < (is_image ? 200 : 40); ++k) data += static_cast<char>(i * 31 + k * k);
  return {is_image ? "/camera" : "/scan", 1'000'000'000LL + i, data};
}

std::vector<ReadMessage> messages_of(int begin, int end) {
  std::vector<ReadMessage> messages;
  for (int i = begin; i < end; ++i) messages.push_back(message_of(i));
  return messages;
}

std::string records_of(const std::vector<ReadMessage>& messages) {
  std::string records;
  for (const ReadMessage& message : messages) {
    records += mcap_message(message.topic == "/scan" ? 1 : 2,
                            static_cast<std::uint64_t>(message.time_ns),
                            message.data);
  }
  return records;
}

constexpr int kNumMessages = 12;

/// Three chunks of four messages; the descriptions in the first.
std::string chunks_of(const std::string& compression) {
  std::string chunks;
  for (int begin = 0; begin < kNumMessages; begin += 4) {
    const std::string records =
        (begin == 0 ? descriptions() : "") + records_of(messages_of(begin, begin + 4));
    chunks += mcap_chunk(records, compression) + mcap_message_index(1) + mcap_message_index(2);
  }
  return chunks;
}

std::string unchunked() { return descriptions() + records_of(messages_of(0, kNumMessages)); }

/// The same messages in every way that the format knows.
std::vector<std::string> every_layout() {
  return {unchunked(), chunks_of(""), chunks_of("lz4"), chunks_of("zstd")};
}

TEST(Mcap, IsToldByItsMagic) {
  EXPECT_TRUE(is_mcap(mcap_file("")));
  EXPECT_FALSE(is_mcap("\x89MCAP"));
  EXPECT_FALSE(is_mcap("#ROSBAG V2.0\n"));
  EXPECT_FALSE(is_mcap(""));
}

TEST(Mcap, GivesTheSameMessagesOfEveryLayout) {
  for (const std::string& records : every_layout()) {
    const ReadRecording recording = read_mcap(mcap_file(records));
    EXPECT_EQ(recording.messages, messages_of(0, kNumMessages));
    EXPECT_THAT(recording.num_messages, ElementsAre(8, 4));
    EXPECT_TRUE(recording.problems.empty());
  }
}

TEST(Mcap, ReadsFromASlowPipe) {
  for (const std::string& records : every_layout()) {
    for (const std::size_t at_once : {1, 7, 100}) {
      Mcap source(std::make_unique<InputBuffer>(
          std::make_unique<testing::TricklingSource>(mcap_file(records), at_once)));
      EXPECT_EQ(testing::read_all_messages(source).messages, messages_of(0, kNumMessages));
    }
  }
}

TEST(Mcap, JumpsOverWhatIsNotWanted) {
  for (const std::string& records : every_layout()) {
    const ReadRecording recording = read_mcap(
        mcap_file(records), [](const MessageTopic& topic) { return topic.name == "/camera"; });
    EXPECT_EQ(recording.messages.size(), 4U);
    EXPECT_EQ(testing::num_found(messages_of(0, kNumMessages), recording.messages), 4U);
    EXPECT_THAT(recording.num_messages, ElementsAre(8, 4));
  }
}

TEST(Mcap, SaysWhatItsTopicsAre) {
  const std::string records =
      mcap_schema(7, "sensor_msgs/msg/LaserScan", "struct LaserScan", "ros2idl") +
      mcap_schema(8, "sensor_msgs/LaserScan", "float32[] ranges", "ros1msg") +
      mcap_schema(9, "foxglove.LaserScan", "a descriptor", "protobuf") +
      mcap_channel(1, 7, "/cdr", "cdr") + mcap_channel(2, 8, "/ros1", "ros1") +
      mcap_channel(3, 9, "/protobuf", "protobuf") + mcap_channel(4, 0, "/json", "json");
  const ReadRecording recording = read_mcap(mcap_file(mcap_chunk(records, "zstd")));
  ASSERT_EQ(recording.topics.size(), 4U);
  EXPECT_EQ(recording.topics[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recording.topics[0].definition, "struct LaserScan");
  EXPECT_EQ(recording.topics[0].encoding, MessageEncoding::kCdr);
  EXPECT_EQ(recording.topics[1].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recording.topics[1].encoding, MessageEncoding::kRos1);
  EXPECT_EQ(recording.topics[2].type, "foxglove.LaserScan");
  EXPECT_EQ(recording.topics[2].definition, "");
  EXPECT_EQ(recording.topics[2].encoding, MessageEncoding::kOther);
  EXPECT_EQ(recording.topics[3].type, "");
  EXPECT_TRUE(recording.problems.empty());
}

TEST(Mcap, TwoChannelsOfOneTopicAreOneAndRepetitionsAreNothingNew) {
  const std::string records = descriptions() + mcap_channel(3, 1, "/scan") +
                              mcap_message(1, 5, "a") + descriptions() + mcap_message(3, 6, "b");
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_THAT(recording.num_messages, ElementsAre(2, 0));
  EXPECT_TRUE(recording.problems.empty());
}

TEST(Mcap, WhatContradictsOrIsMissingIsCounted) {
  const std::string records = descriptions() + mcap_channel(1, 1, "/another") +
                              mcap_channel(5, 6, "/without_schema") + mcap_message(9, 5, "lost") +
                              mcap_message(1, 5, "a");
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_THAT(recording.messages, ElementsAre(ReadMessage{"/scan", 5, "a"}));
  ASSERT_EQ(recording.problems.num_damaged, 3U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("channel 1 is described again"));
  EXPECT_THAT(recording.problems.first[1].reason, HasSubstr("schema 6"));
  EXPECT_THAT(recording.problems.first[2].reason, HasSubstr("channel 9"));
}

TEST(Mcap, TimesBeyondTheClockAreTheLatest) {
  const ReadRecording recording =
      read_mcap(mcap_file(descriptions() + mcap_message(1, ~std::uint64_t{0}, "")));
  ASSERT_EQ(recording.messages.size(), 1U);
  EXPECT_EQ(recording.messages[0].time_ns, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(recording.messages[0].data, "");
}

TEST(Mcap, AWrongChecksumIsToldAndTheMessagesAreGiven) {
  for (const char* compression : {"lz4", "zstd"}) {
    const std::string chunk =
        mcap_chunk(descriptions() + records_of(messages_of(0, 4)), compression, 1);
    const ReadRecording recording = read_mcap(mcap_file(chunk));
    EXPECT_EQ(recording.messages, messages_of(0, 4));
    ASSERT_EQ(recording.problems.num_damaged, 1U);
    EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("checksum"));
  }
}

TEST(Mcap, AChunkThatCannotBeReadIsPassed) {
  const std::string records =
      descriptions() + mcap_chunk("xxxx", "brotli") + mcap_message(1, 5, "a");
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_THAT(recording.messages, ElementsAre(ReadMessage{"/scan", 5, "a"}));
  ASSERT_EQ(recording.problems.num_damaged, 1U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("brotli"));
}

TEST(Mcap, NeitherSummaryNorFooterIsNeeded) {
  for (const std::string& records : every_layout()) {
    const ReadRecording recording =
        read_mcap(testing::kMcapMagicBytes + testing::mcap_header() + records);
    EXPECT_EQ(recording.messages, messages_of(0, kNumMessages));
    EXPECT_EQ(recording.problems.num_damaged, 0U);
    EXPECT_THAT(recording.problems.remarks, ElementsAre(HasSubstr("cut short")));
  }
}

TEST(Mcap, PrivateRecordsArePassedUnknownOnesCounted) {
  const std::string records = descriptions() + mcap_record(0x99, "of an application") +
                              mcap_record(0x30, "of a later version") + mcap_message(1, 5, "a");
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_THAT(recording.messages, ElementsAre(ReadMessage{"/scan", 5, "a"}));
  ASSERT_EQ(recording.problems.num_damaged, 1U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("unknown kind 48"));
}

TEST(Mcap, ALongerRecordOfALaterVersionIsRead) {
  std::string channel = mcap_channel(1, 1, "/scan").substr(9) + "more";
  const std::string records =
      mcap_schema(1, "a/msg/B", "") + mcap_record(0x04, channel) + mcap_message(1, 5, "a");
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_EQ(recording.messages.size(), 1U);
  EXPECT_TRUE(recording.problems.empty());
}

TEST(Mcap, CutAnywhereItGivesWhatStandsBeforeAndSaysSo) {
  const std::vector<ReadMessage> all = messages_of(0, kNumMessages);
  for (const std::string& records : every_layout()) {
    const std::string whole = mcap_file(records);
    std::size_t num_before = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const ReadRecording recording = read_mcap(whole.substr(0, length));
      const auto num_read = static_cast<std::ptrdiff_t>(recording.messages.size());
      ASSERT_LE(recording.messages.size(), all.size());
      ASSERT_TRUE(std::equal(all.begin(), all.begin() + num_read, recording.messages.begin()));
      ASSERT_GE(recording.messages.size(), num_before) << length;
      ASSERT_FALSE(recording.problems.remarks.empty()) << length;
      num_before = recording.messages.size();
    }
    EXPECT_EQ(num_before, all.size());
  }
}

TEST(Mcap, CutInsideAnUncompressedMessageItGivesAllBefore) {
  const std::string whole = testing::kMcapMagicBytes + testing::mcap_header() + unchunked();
  const std::size_t first = whole.size() - records_of(messages_of(0, kNumMessages)).size();
  for (std::size_t length = first; length < whole.size(); ++length) {
    int num_whole = 0;
    std::size_t end = first;
    while (true) {
      end += records_of({message_of(num_whole)}).size();
      if (end > length) break;
      ++num_whole;
    }
    const bool is_inside = end - records_of({message_of(num_whole)}).size() != length;
    const ReadRecording recording = read_mcap(whole.substr(0, length));
    ASSERT_EQ(recording.messages, messages_of(0, num_whole)) << length;
    ASSERT_EQ(recording.problems.num_damaged, is_inside ? 1U : 0U) << length;
  }
}

/// Every byte changed in turn: one damaged record costs itself, a chunk's damaged compression the
/// chunk.
TEST(Mcap, AnyOneWrongByteCostsLittle) {
  auto generator = testing::make_generator();
  const std::vector<ReadMessage> all = messages_of(0, kNumMessages);
  std::size_t num_kept_in_all = 0;
  std::size_t num_tried = 0;
  for (const std::string& records : every_layout()) {
    const std::string whole = mcap_file(records);
    const std::size_t first = whole.find(all[0].data);
    const bool is_packed = records != unchunked() && records != chunks_of("");
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 + generator() % 255));
      const ReadRecording recording = read_mcap(damaged);
      ASSERT_LE(recording.messages.size(), all.size() + 1) << at;
      const std::size_t num_kept = testing::num_found(all, recording.messages);
      // A packed chunk is lost from the damage on, the first with the descriptions of all.
      if (is_packed || at < first) continue;
      EXPECT_GE(num_kept, all.size() - 4) << at;
      num_kept_in_all += num_kept;
      ++num_tried;
    }
  }
  EXPECT_GE(num_kept_in_all, num_tried * (all.size() - 1)) << "on average";
}

TEST(Mcap, AHoleOfZerosCostsWhatItCovers) {
  const std::string whole = mcap_file(unchunked());
  const std::string one = records_of({message_of(5)});
  const std::size_t begin = whole.find(one);
  std::string damaged = whole;
  damaged.replace(begin + 3, one.size() + 20, one.size() + 20, '\0');
  const ReadRecording recording = read_mcap(damaged);
  EXPECT_EQ(testing::num_found(messages_of(0, kNumMessages), recording.messages), 10U);
  EXPECT_GE(recording.problems.num_damaged, 1U);
}

TEST(Mcap, AMessageThatReachesBeyondItsChunkDoesNotSwallowTheNext) {
  std::string lying = records_of({message_of(1)});
  lying[3] = '\x0f';  // 1 MB more
  const std::string records = mcap_chunk(descriptions() + records_of({message_of(0)}) + lying +
                                         records_of(messages_of(2, 5))) +
                              mcap_chunk(records_of(messages_of(5, 1000)));
  const ReadRecording recording = read_mcap(mcap_file(records));
  EXPECT_EQ(testing::num_found(messages_of(0, 1000), recording.messages), 999U);
  ASSERT_EQ(recording.problems.num_damaged, 1U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("beyond its chunk"));
}

TEST(Mcap, LyingLengthsNeitherHangNorAllocate) {
  for (const std::uint64_t lie : {1ULL << 20, 1ULL << 29, 1ULL << 33, 1ULL << 62, ~0ULL}) {
    for (int op = 0; op < 256; ++op) {
      const std::string record = raw(static_cast<std::uint8_t>(op)) + raw(lie) + "some bytes";
      const ReadRecording recording =
          read_mcap(mcap_file(descriptions() + mcap_message(1, 5, "a") + record));
      ASSERT_EQ(recording.messages.size(), 1U) << op;
      ASSERT_FALSE(recording.problems.empty()) << op;
    }
  }
}

TEST(Mcap, AChunkThatLiesAboutItsSizesGivesItsMessages) {
  const std::string records = descriptions() + records_of(messages_of(0, 4));
  for (const char* compression : {"lz4", "zstd"}) {
    std::string chunk = mcap_chunk(records, compression);
    for (const std::uint64_t lie : {0ULL, 100ULL, 1ULL << 40, ~0ULL}) {
      chunk.replace(9 + 16, 8, raw(lie));
      const ReadRecording recording = read_mcap(mcap_file(chunk));
      EXPECT_EQ(recording.messages, messages_of(0, 4)) << lie;
      EXPECT_EQ(recording.problems.num_damaged, 1U);
    }
  }
}

/// Bytes that begin like records everywhere are passed in linear time.
TEST(Mcap, GarbageThatLooksLikeRecordsIsPassedQuickly) {
  std::string garbage;
  while (garbage.size() < 3'000'000) garbage += std::string("\x05\x40\x40\x03\0\0\0\0\0", 9);
  for (const char filler : {'\0', '\x05', '\xff'}) {
    const std::string records =
        descriptions() + garbage + std::string(3'000'000, filler) + records_of(messages_of(0, 2));
    const ReadRecording recording = read_mcap(mcap_file(records));
    EXPECT_EQ(testing::num_found(messages_of(0, 2), recording.messages), 2U);
  }
}

TEST(Mcap, TellsOfTheDamageOfWhatPackedTheFile) {
  const std::string packed = testing::pack_zstd(mcap_file(chunks_of("")));
  Mcap source(std::make_unique<InputBuffer>(
      unpack(make_memory_source(packed.substr(0, packed.size() - 10)))));
  EXPECT_THAT(testing::read_all_messages(source).problems.remarks,
              ::testing::Contains(HasSubstr("the zstd stream is cut short")));
}

}  // namespace setsquare::mcap_test
