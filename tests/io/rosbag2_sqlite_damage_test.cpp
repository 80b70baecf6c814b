// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// SQLite recordings that are cut short, damaged, or not written to their end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "setsquare/io/bags/rosbag2_sqlite.hpp"
#include "tests/io/recorded_messages.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::rosbag2_sqlite_damage_test {

namespace fs = std::filesystem;

using testing::cdr_bytes;
using testing::content_of;
using testing::DatabaseWriter;
using ::testing::HasSubstr;
using testing::made_up_messages;
using testing::names_in;
using testing::num_found;
using testing::read_by_sqlite;
using testing::read_bytes;
using testing::read_file;
using testing::Reading;
using testing::ReadMessage;
using testing::recording_bytes;
using ::testing::SizeIs;
using testing::TemporaryFolder;
using testing::write_recording;

TEST(Rosbag2SqliteDamage, OfACutFileTheMessagesBeforeTheCutAreGivenAndAWord) {
  const auto messages = made_up_messages(60);
  const std::string bytes = recording_bytes(messages, 4, 512);
  std::set<std::size_t> lengths;
  for (std::size_t length = 0; length < bytes.size(); length += 83) lengths.insert(length);
  for (std::size_t page = 512; page < bytes.size(); page += 512) {
    lengths.insert({page - 1, page, page + 1});
  }
  std::size_t num_most = 0;
  for (const std::size_t length : lengths) {
    const Reading read = read_bytes(bytes.substr(0, length));
    // The pages of a message need not lie in order: one with its last page behind the cut may come
    // before one that is whole.
    EXPECT_EQ(num_found(messages, read.messages), read.messages.size()) << length;
    EXPECT_TRUE(!read.error.empty() || !read.problems.empty()) << length;
    num_most = std::max(num_most, read.messages.size());
    if (length > bytes.size() / 2) {
      EXPECT_GT(read.messages.size(), messages.size() / 3) << length;
    }
  }
  EXPECT_GT(num_most, messages.size() - 3);
}

TEST(Rosbag2SqliteDamage, WhatIsReadableBehindADamagedPageIsRead) {
  const auto messages = made_up_messages(200);
  const std::string bytes = recording_bytes(messages, 3, 512);
  std::size_t num_with_end = 0;
  for (std::size_t page = 1; page < bytes.size() / 512; ++page) {
    std::string damaged = bytes;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(512 * page), 512, '\xee');
    const Reading read = read_bytes(damaged);
    std::size_t num_equal = 0;
    for (const ReadMessage& message : read.messages) {
      const auto number = static_cast<std::size_t>(message.time_ns - 1000);
      ASSERT_LT(number, messages.size());
      num_equal += static_cast<std::size_t>(message == messages[number]);
    }
    // A page in a message's middle can differ without notice: that message differs then.
    EXPECT_GE(num_equal + 1, read.messages.size()) << page;
    if (num_equal + 1 < messages.size()) {
      EXPECT_FALSE(read.problems.empty() && read.error.empty()) << page;
    }
    const bool has_end = !read.messages.empty() && read.messages.back().time_ns > 1190;
    num_with_end += static_cast<std::size_t>(has_end);
  }
  // All but the pages of the tables' roots and the last messages' own.
  EXPECT_GT(num_with_end, bytes.size() / 512 * 9 / 10);
}

TEST(Rosbag2SqliteDamage, RowsOnOnePageAreLostWithItAndNamed) {
  std::vector<ReadMessage> messages;
  for (int i = 0; i < 100; ++i) messages.push_back({"/scan", 1000 + i, cdr_bytes(100, 1)});
  std::string bytes = recording_bytes(messages, 3, 1024);
  const std::size_t marked = bytes.find(cdr_bytes(100, 1), bytes.size() / 2);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(marked / 1024 * 1024), 1024, '\0');
  const Reading read = read_bytes(bytes);
  EXPECT_EQ(read.problems.num_damaged, 1U);
  EXPECT_THAT(read.problems.first.at(0).reason, HasSubstr("unreadable to row"));
  EXPECT_GE(read.messages.size(), 88U);
  EXPECT_LT(read.messages.size(), 100U);
  EXPECT_EQ(read.positions.back(), 100U);
  std::size_t num_gaps = 0;
  for (std::size_t i = 1; i < read.positions.size(); ++i) {
    num_gaps += static_cast<std::size_t>(read.positions[i] != read.positions[i - 1] + 1);
  }
  EXPECT_EQ(num_gaps, 1U);
}

TEST(Rosbag2SqliteDamage, PagesThatLeadInCirclesEnd) {
  // All children of an inner page become its first: the rows of that one come again and again.
  std::string bytes = recording_bytes(made_up_messages(300), 3, 512);
  std::size_t num_changed = 0;
  for (std::size_t page = 512; page + 512 <= bytes.size(); page += 512) {
    const auto byte = [&bytes, page](std::size_t at) {
      return static_cast<std::uint8_t>(bytes[page + at]);
    };
    constexpr std::uint8_t kInnerPageOfTable = 5;
    if (byte(0) != kInnerPageOfTable) continue;
    const std::size_t num_cells = byte(3) * 256U + byte(4);
    const std::size_t first_cell = byte(12) * 256U + byte(13);
    for (std::size_t i = 0; i < num_cells; ++i) {
      const std::size_t cell = byte(12 + 2 * i) * 256U + byte(13 + 2 * i);
      bytes.replace(page + cell, 4, bytes, page + first_cell, 4);
    }
    ++num_changed;
  }
  ASSERT_GT(num_changed, 1U);
  const Reading read = read_bytes(bytes);
  EXPECT_FALSE(read.problems.empty());
}

TEST(Rosbag2SqliteDamage, FlippedBytesGiveNothingWorseThanProblems) {
  auto generator = testing::make_generator();
  const std::string bytes = recording_bytes(made_up_messages(40), 4, 512);
  for (int i = 0; i < 400; ++i) {
    std::string flipped = bytes;
    const int num_flips = 1 + i % 5;
    for (int flip = 0; flip < num_flips; ++flip) {
      const auto at = std::uniform_int_distribution<std::size_t>(0, flipped.size() - 1)(generator);
      flipped[at] = static_cast<char>(std::uniform_int_distribution<int>(0, 255)(generator));
    }
    EXPECT_LE(read_bytes(flipped).problems.first.size(), LogProblems::kMaxKept);
  }
}

/// A recording of 20 messages of which the first ten are in the file, the others in the write-ahead
/// log beside it: copied while the recorder runs.
std::vector<ReadMessage> write_running_recording(const fs::path& folder, const fs::path& copy) {
  const auto messages = made_up_messages(20);
  const fs::path path = folder / "running.db3";
  write_recording(path, {messages.begin(), messages.begin() + 10}, 3, 1024);
  DatabaseWriter database(path);
  database.run("PRAGMA journal_mode = WAL");
  database.run("PRAGMA wal_autocheckpoint = 0");
  for (std::size_t i = 10; i < messages.size(); ++i) {
    database.insert_message(i % 2 == 0 ? 1 : 2, messages[i].time_ns, messages[i].data);
  }
  fs::copy_file(path, copy);
  fs::copy_file(path.string() + "-wal", copy.string() + "-wal");
  return messages;
}

TEST(Rosbag2SqliteDamage, WhatAKilledRecorderLeftInTheWriteAheadLogIsRead) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  const auto messages = write_running_recording(folder.path(), path);
  const std::set<std::string> names = names_in(folder.path());
  const Reading read = read_file(path);
  EXPECT_EQ(read.messages, messages);
  EXPECT_EQ(read.problems.num_damaged, 0U);
  ASSERT_THAT(read.problems.remarks, SizeIs(1));
  EXPECT_THAT(read.problems.remarks[0], HasSubstr("did not come to its end"));
  EXPECT_EQ(names_in(folder.path()), names);
}

TEST(Rosbag2SqliteDamage, AJournalOfAKilledRecorderIsRemarked) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  const auto messages = made_up_messages(5);
  write_recording(path, messages);
  folder.write("a.db3-journal", "left");
  const Reading read = read_file(path);
  EXPECT_EQ(read.messages, messages);
  ASSERT_THAT(read.problems.remarks, SizeIs(1));
  EXPECT_THAT(read.problems.remarks[0], HasSubstr("a.db3-journal lies beside the file"));
  EXPECT_EQ(content_of(path.string() + "-journal"), "left");
}

TEST(Rosbag2SqliteDamage, OfADamagedWriteAheadLogAsMuchIsReadAsSqliteReads) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  const auto messages = write_running_recording(folder.path(), path);
  const std::string log = content_of(path.string() + "-wal");
  std::set<std::size_t> counts;
  for (std::size_t at = 0; at < log.size(); at += 397) {
    std::string damaged = log;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    for (const std::string& content : {damaged, log.substr(0, at)}) {
      std::ofstream(path.string() + "-wal", std::ios::binary) << content;
      const Reading read = read_file(path);
      // SQLite cleans up behind itself, so it gets copies.
      const fs::path copy = folder.path() / "copy.db3";
      fs::copy_file(path, copy, fs::copy_options::overwrite_existing);
      fs::copy_file(
          path.string() + "-wal", copy.string() + "-wal", fs::copy_options::overwrite_existing);
      EXPECT_EQ(read.messages, read_by_sqlite(copy)) << at;
      counts.insert(read.messages.size());
    }
  }
  EXPECT_EQ(*counts.begin(), 10U);
  EXPECT_GT(counts.size(), 8U);  // cut between all of the messages
}

}  // namespace setsquare::rosbag2_sqlite_damage_test
