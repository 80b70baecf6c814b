// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag1.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/io/read_all.hpp"
#include "tests/io/read_messages.hpp"
#include "tests/io/rosbag1_bytes.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::rosbag1_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::raw;
using testing::ReadMessage;
using testing::ReadRecording;
using testing::rosbag_chunk;
using testing::rosbag_connection;
using testing::rosbag_file;
using testing::rosbag_index;
using testing::rosbag_message;
using testing::rosbag_record;

ReadRecording read_bag(const std::string& bytes, MessageSource::IsWanted is_wanted = {}) {
  Rosbag1 source(std::make_unique<InputBuffer>(make_memory_source(bytes)), "test.bag");
  source.set_wanted(std::move(is_wanted));
  return testing::read_all_messages(source);
}

/// Connections as ROS numbers them, and one of a large number.
constexpr std::uint32_t kScan = 0;
constexpr std::uint32_t kCamera = 70000;

std::string descriptions() {
  return rosbag_connection(kScan, "/scan", "sensor_msgs/LaserScan", "float32[] ranges") +
         rosbag_connection(kCamera, "/camera", "sensor_msgs/Image", "uint8[] data");
}

/// Message number i: scans, and every third an image.
ReadMessage message_of(int i) {
  const bool is_image = i % 3 == 2;
  std::string data;
  for (int k = 0; k < (is_image ? 200 : 40); ++k) data += static_cast<char>(i * 31 + k * k);
  return {is_image ? "/camera" : "/scan", 1'000'000'000LL * (100 + i) + i, data};
}

std::vector<ReadMessage> messages_of(int begin, int end) {
  std::vector<ReadMessage> messages;
  for (int i = begin; i < end; ++i) messages.push_back(message_of(i));
  return messages;
}

std::string records_of(const std::vector<ReadMessage>& messages) {
  std::string records;
  for (const ReadMessage& message : messages) {
    records += rosbag_message(message.topic == "/scan" ? kScan : kCamera,
                              static_cast<std::uint32_t>(message.time_ns / 1'000'000'000),
                              static_cast<std::uint32_t>(message.time_ns % 1'000'000'000),
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
    chunks += rosbag_chunk(records, compression) + rosbag_index(kScan) + rosbag_index(kCamera);
  }
  return chunks;
}

/// Version 2.0 allows records outside of chunks.
std::string unchunked() { return descriptions() + records_of(messages_of(0, kNumMessages)); }

/// The same messages in every way that the format knows.
std::vector<std::string> every_bag() {
  return {rosbag_file(unchunked(), 0),
          rosbag_file(chunks_of("none"), 3),
          rosbag_file(chunks_of("bz2"), 3),
          rosbag_file(chunks_of("lz4"), 3)};
}

/// What a recorder that was killed leaves: no index, and a last chunk whose sizes are zero.
std::string open_bag(const std::string& compression) {
  const auto packed = [&compression](const std::string& records) {
    if (compression == "bz2") return testing::pack_bzip2(records);
    return compression == "lz4" ? testing::pack_lz4(records) : records;
  };
  const std::string open_chunk_head =
      rosbag_record(0x05, testing::rosbag_chunk_head_fields(compression, 0), "");
  return testing::kRosbagMagicBytes + testing::rosbag_header(0, 0) +
         rosbag_chunk(descriptions() + records_of(messages_of(0, 4)), compression) +
         rosbag_index(kScan) + open_chunk_head + packed(records_of(messages_of(4, kNumMessages)));
}

TEST(Rosbag1, IsToldByItsMagic) {
  EXPECT_TRUE(is_rosbag1("#ROSBAG V2.0\n"));
  EXPECT_TRUE(is_rosbag1("#ROSBAG V1.2\n"));
  EXPECT_TRUE(is_rosbag1("#ROSRECORD V1.1\n"));
  EXPECT_FALSE(is_rosbag1("#ROSBAG"));
  EXPECT_FALSE(is_rosbag1(""));
}

TEST(Rosbag1, GivesTheSameMessagesOfEveryBag) {
  for (const std::string& bag : every_bag()) {
    const ReadRecording recording = read_bag(bag);
    EXPECT_EQ(recording.messages, messages_of(0, kNumMessages));
    EXPECT_THAT(recording.num_messages, ElementsAre(8, 4));
    EXPECT_TRUE(recording.problems.empty());
  }
}

TEST(Rosbag1, ReadsFromASlowPipe) {
  for (const std::string& bag : every_bag()) {
    for (const std::size_t at_once : {1, 7, 100}) {
      Rosbag1 source(
          std::make_unique<InputBuffer>(std::make_unique<testing::TricklingSource>(bag, at_once)),
          "test.bag");
      EXPECT_EQ(testing::read_all_messages(source).messages, messages_of(0, kNumMessages));
    }
  }
}

TEST(Rosbag1, JumpsOverWhatIsNotWanted) {
  for (const std::string& bag : every_bag()) {
    const ReadRecording recording =
        read_bag(bag, [](const MessageTopic& topic) { return topic.name == "/camera"; });
    EXPECT_EQ(recording.messages.size(), 4U);
    EXPECT_EQ(testing::num_found(messages_of(0, kNumMessages), recording.messages), 4U);
    EXPECT_THAT(recording.num_messages, ElementsAre(8, 4));
  }
}

TEST(Rosbag1, SaysWhatItsTopicsAre) {
  const ReadRecording recording = read_bag(rosbag_file(
      rosbag_connection(1, "/remapped", "sensor_msgs/LaserScan", "float32[] ranges", "/own"), 0));
  ASSERT_EQ(recording.topics.size(), 1U);
  EXPECT_EQ(recording.topics[0].name, "/remapped");
  EXPECT_EQ(recording.topics[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(recording.topics[0].definition, "float32[] ranges");
  EXPECT_EQ(recording.topics[0].encoding, MessageEncoding::kRos1);
}

TEST(Rosbag1, TwoConnectionsOfOneTopicAreOneAndRepetitionsAreNothingNew) {
  const std::string records =
      descriptions() + rosbag_connection(3, "/scan", "sensor_msgs/LaserScan", "") +
      rosbag_message(kScan, 5, 0, "a") + descriptions() + rosbag_message(3, 6, 0, "b");
  const ReadRecording recording = read_bag(rosbag_file(records, 0));
  EXPECT_THAT(recording.num_messages, ElementsAre(2, 0));
  EXPECT_TRUE(recording.problems.empty());
}

TEST(Rosbag1, AnOlderVersionIsRefusedWithWhatToDo) {
  for (const char* beginning : {"#ROSBAG V1.2\n", "#ROSBAG V1.1\n", "#ROSRECORD V1.1\n"}) {
    try {
      read_bag(std::string(beginning) + std::string(1000, 'x'));
      FAIL() << beginning;
    } catch (const FormatError& error) {
      EXPECT_THAT(error.what(), HasSubstr("test.bag"));
      EXPECT_THAT(error.what(), HasSubstr("rosbag fix"));
    }
  }
}

TEST(Rosbag1, ABagThatWasNotClosedGivesAllThatWasWritten) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const ReadRecording recording = read_bag(open_bag(compression));
    EXPECT_EQ(recording.messages, messages_of(0, kNumMessages)) << compression;
    EXPECT_EQ(recording.problems.num_damaged, 0U);
    EXPECT_THAT(recording.problems.remarks, ElementsAre(HasSubstr("not closed")));
  }
}

TEST(Rosbag1, ABagThatWasNotClosedMayEndAnywhere) {
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    const std::string bag = open_bag(compression);
    for (std::size_t length = 13; length < bag.size(); ++length) {
      const ReadRecording recording = read_bag(bag.substr(0, length));
      const std::vector<ReadMessage> expected =
          messages_of(0, static_cast<int>(recording.messages.size()));
      ASSERT_EQ(recording.messages, expected) << length;
      ASSERT_THAT(recording.problems.remarks, ElementsAre(HasSubstr("not closed")));
    }
  }
}

TEST(Rosbag1, RecordsMayFollowAnOpenPackedChunk) {
  const std::string bag = open_bag("lz4") + rosbag_index(kScan) + records_of({message_of(12)});
  EXPECT_EQ(read_bag(bag).messages, messages_of(0, 13));
}

TEST(Rosbag1, AnIndexThatLiesIsNotAsked) {
  const std::string wrong_index = rosbag_record(
      0x04,
      testing::rosbag_field("conn", raw<std::uint32_t>(9)) + testing::rosbag_field("count", "x"),
      "nothing that fits");
  const std::string bag =
      rosbag_file(wrong_index + chunks_of("bz2") + wrong_index + testing::rosbag_chunk_info(), 3);
  const ReadRecording recording = read_bag(bag);
  EXPECT_EQ(recording.messages, messages_of(0, kNumMessages));
  EXPECT_TRUE(recording.problems.empty());
}

/// The recorder of 2010 stated 20 bytes for every entry and wrote 12.
TEST(Rosbag1, AnIndexWhoseLengthIsOverstatedIsPassed) {
  constexpr std::uint32_t kNumEntries = 7;
  const std::string overstated = rosbag_record(
      0x04,
      testing::rosbag_field("conn", raw(kScan)) + testing::rosbag_field("count", raw(kNumEntries)),
      std::string(20 * kNumEntries, '\0'));
  const std::string index = overstated.substr(0, overstated.size() - 8 * kNumEntries);
  const std::string bag = rosbag_file(chunks_of("none") + index + rosbag_index(kScan), 3);
  const ReadRecording recording = read_bag(bag);
  EXPECT_EQ(recording.messages, messages_of(0, kNumMessages));
  EXPECT_TRUE(recording.problems.empty());
}

TEST(Rosbag1, CutAnywhereItGivesWhatStandsBeforeAndSaysSo) {
  const std::vector<ReadMessage> all = messages_of(0, kNumMessages);
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const std::string whole = rosbag_file(chunks_of(compression), 3);
    std::size_t num_before = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const ReadRecording recording = read_bag(whole.substr(0, length));
      ASSERT_EQ(recording.messages, messages_of(0, static_cast<int>(recording.messages.size())));
      ASSERT_GE(recording.messages.size(), num_before) << length;
      ASSERT_FALSE(recording.problems.remarks.empty()) << length;
      num_before = recording.messages.size();
    }
    EXPECT_EQ(num_before, all.size());
  }
}

TEST(Rosbag1, CutInsideAnUncompressedMessageItGivesAllBefore) {
  const std::string whole = rosbag_file(unchunked(), 0);
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
    const ReadRecording recording = read_bag(whole.substr(0, length));
    ASSERT_EQ(recording.messages, messages_of(0, num_whole)) << length;
    ASSERT_EQ(recording.problems.num_damaged, is_inside ? 1U : 0U) << length;
  }
}

/// Every byte changed in turn: one damaged record costs itself, a chunk's damaged compression the
/// chunk.
TEST(Rosbag1, AnyOneWrongByteCostsLittle) {
  auto generator = testing::make_generator();
  const std::vector<ReadMessage> all = messages_of(0, kNumMessages);
  std::size_t num_kept_in_all = 0;
  std::size_t num_tried = 0;
  for (const std::string& whole : every_bag()) {
    const std::size_t first = whole.find(all[0].data);
    const bool is_packed =
        whole != rosbag_file(unchunked(), 0) && whole != rosbag_file(chunks_of("none"), 3);
    for (std::size_t at = 13; at < whole.size(); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 + generator() % 255));
      const ReadRecording recording = read_bag(damaged);
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

TEST(Rosbag1, AHoleOfZerosCostsWhatItCovers) {
  const std::string whole = rosbag_file(unchunked(), 0);
  const std::string one = records_of({message_of(5)});
  std::string damaged = whole;
  damaged.replace(whole.find(one) + 3, one.size() + 20, one.size() + 20, '\0');
  const ReadRecording recording = read_bag(damaged);
  EXPECT_EQ(testing::num_found(messages_of(0, kNumMessages), recording.messages), 10U);
  EXPECT_EQ(recording.problems.num_damaged, 1U);
}

TEST(Rosbag1, AMessageThatReachesBeyondItsChunkDoesNotSwallowTheNext) {
  std::string lying = records_of({message_of(1)});
  lying[lying.size() - message_of(1).data.size() - 2] = '\x0f';  // 1 MB more
  const std::string chunks = rosbag_chunk(descriptions() + records_of({message_of(0)}) + lying +
                                              records_of(messages_of(2, 5)),
                                          "none") +
                             rosbag_chunk(records_of(messages_of(5, 1000)), "none");
  const ReadRecording recording = read_bag(rosbag_file(chunks, 2));
  EXPECT_EQ(testing::num_found(messages_of(0, 1000), recording.messages), 999U);
  ASSERT_EQ(recording.problems.num_damaged, 1U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("beyond its chunk"));
}

TEST(Rosbag1, WhatContradictsOrIsUnknownIsCounted) {
  const std::string records = descriptions() + rosbag_connection(kScan, "/another", "a/B", "") +
                              rosbag_message(9, 5, 0, "lost") +
                              rosbag_record(0x55, "", "of a later version") +
                              rosbag_chunk("xxxx", "brotli") + rosbag_message(kScan, 5, 0, "a");
  const ReadRecording recording = read_bag(rosbag_file(records, 0));
  EXPECT_THAT(recording.messages, ElementsAre(ReadMessage{"/scan", 5'000'000'000, "a"}));
  ASSERT_EQ(recording.problems.num_damaged, 4U);
  EXPECT_THAT(recording.problems.first[0].reason, HasSubstr("connection 0 is described again"));
  EXPECT_THAT(recording.problems.first[1].reason, HasSubstr("connection 9"));
  EXPECT_THAT(recording.problems.first[2].reason, HasSubstr("unknown kind 85"));
  EXPECT_THAT(recording.problems.first[3].reason, HasSubstr("brotli"));
}

TEST(Rosbag1, LyingLengthsNeitherHangNorAllocate) {
  const std::string message = rosbag_message(kScan, 5, 0, "a");
  for (const std::uint32_t lie : {0U, 1U, 60U, 1U << 16, 1U << 29, 1U << 31, ~0U}) {
    for (std::size_t at = 0; at + 4 <= message.size(); ++at) {
      std::string lying = message;
      lying.replace(at, 4, raw(lie));
      const ReadRecording recording =
          read_bag(rosbag_file(descriptions() + message + lying + message, 0));
      ASSERT_GE(recording.messages.size(), 1U) << at;
      ASSERT_LE(recording.messages.size(), 3U) << at;
    }
  }
}

/// Bytes that begin like records everywhere are passed in linear time.
TEST(Rosbag1, GarbageThatLooksLikeRecordsIsPassedQuickly) {
  std::string garbage;
  while (garbage.size() < 2'000'000) garbage += raw<std::uint32_t>(30'000) + raw<std::uint32_t>(20);
  for (const char filler : {'\0', '\x05', '='}) {
    const std::string records =
        descriptions() + garbage + std::string(2'000'000, filler) + records_of(messages_of(0, 2));
    const ReadRecording recording = read_bag(rosbag_file(records, 0));
    EXPECT_EQ(recording.messages, messages_of(0, 2));
    EXPECT_EQ(recording.problems.num_damaged, 1U);
  }
}

}  // namespace setsquare::rosbag1_test
