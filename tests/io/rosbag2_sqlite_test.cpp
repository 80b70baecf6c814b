// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag2_sqlite.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/io/recorded_messages.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::rosbag2_sqlite_test {

namespace fs = std::filesystem;

using testing::cdr_bytes;
using testing::content_of;
using testing::DatabaseWriter;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
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

bool is_scan(const MessageTopic& topic) { return topic.type == "sensor_msgs/LaserScan"; }

class EveryVersion : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rosbag2Sqlite, EveryVersion, ::testing::Values(1, 2, 3, 4));

TEST_P(EveryVersion, OfTheTablesIsRead) {
  const TemporaryFolder folder;
  const auto messages = made_up_messages(41);
  write_recording(folder.path() / "a.db3", messages, GetParam());
  const Reading read = read_file(folder.path() / "a.db3");
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.messages, messages);
  EXPECT_TRUE(read.problems.empty());
  ASSERT_THAT(read.topics, SizeIs(2));
  EXPECT_EQ(read.topics[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(read.topics[1].type, "sensor_msgs/Image");
  EXPECT_EQ(read.topics[0].encoding, MessageEncoding::kCdr);
  EXPECT_THAT(read.num_messages, ElementsAre(21, 20));
  EXPECT_EQ(read.positions.front(), 1U);  // the row's number
  EXPECT_EQ(read.positions.back(), 41U);
}

TEST(Rosbag2Sqlite, UnwantedTopicsAreCountedAndNotHandedOn) {
  const auto messages = made_up_messages(30);
  const Reading read = read_bytes(recording_bytes(messages), is_scan);
  std::vector<ReadMessage> scans = messages;
  std::erase_if(scans, [](const ReadMessage& message) { return message.topic != "/scan"; });
  EXPECT_EQ(read.messages, scans);
  EXPECT_THAT(read.num_messages, ElementsAre(15, 15));
}

TEST(Rosbag2Sqlite, DefinitionsInTheLanguageOfMessagesAreKept) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  {
    DatabaseWriter database(path);
    database.create_tables(4);
    database.insert_topic("/a", "std_msgs/msg/String");
    database.insert_topic("/b", "std_msgs/msg/Bool");
    database.run(
        "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, "
        "type_description_hash) VALUES ('std_msgs/msg/String', 'ros2msg', 'string data', ''), "
        "('std_msgs/msg/Bool', 'ros2idl', 'module std_msgs', '')");
  }
  const Reading read = read_file(path);
  ASSERT_THAT(read.topics, SizeIs(2));
  EXPECT_EQ(read.topics[0].definition, "string data");
  EXPECT_EQ(read.topics[1].definition, "");
}

TEST(Rosbag2Sqlite, AnotherSerialisationIsNamedAsSuch) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  {
    DatabaseWriter database(path);
    database.create_tables(2);
    database.insert_topic("/a", "std_msgs/msg/String", "protobuf");
    database.insert_message(1, 5, "\x28\xb5\x2f\xfd");  // not to be unpacked
  }
  const Reading read = read_file(path);
  EXPECT_EQ(read.topics.at(0).encoding, MessageEncoding::kOther);
  EXPECT_THAT(read.messages, ElementsAre(ReadMessage{"/a", 5, "\x28\xb5\x2f\xfd"}));
}

TEST(Rosbag2Sqlite, ARecordingWithoutMessagesIsOne) {
  const Reading read = read_bytes(recording_bytes({}));
  EXPECT_EQ(read.error, "");
  EXPECT_THAT(read.messages, IsEmpty());
  EXPECT_THAT(read.topics, SizeIs(2));
  EXPECT_TRUE(read.problems.empty());
}

TEST(Rosbag2Sqlite, MessagesPackedOneByOneAreUnpacked) {
  const auto messages = made_up_messages(20);
  std::vector<ReadMessage> packed = messages;
  for (ReadMessage& message : packed) {
    std::string bytes(ZSTD_compressBound(message.data.size()), '\0');
    bytes.resize(
        ZSTD_compress(bytes.data(), bytes.size(), message.data.data(), message.data.size(), 1));
    message.data = bytes;
  }
  packed[4].data.resize(packed[4].data.size() / 2);
  const Reading read = read_bytes(recording_bytes(packed));
  std::vector<ReadMessage> expected = messages;
  expected.erase(expected.begin() + 4);
  EXPECT_EQ(read.messages, expected);
  EXPECT_EQ(read.problems.num_damaged, 1U);
  EXPECT_EQ(summary(read.problems),
            "1 damaged record skipped, at row 5: the packed message is cut short");
}

TEST(Rosbag2Sqlite, RowsThatAreNoMessagesAreCounted) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  {
    DatabaseWriter database(path);
    database.run("CREATE TABLE topics(id, name, type, serialization_format)");
    database.run("CREATE TABLE messages(topic_id, timestamp, data)");
    database.run("INSERT INTO topics VALUES (7, '/a', 'std_msgs/msg/String', 'cdr')");
    database.run(
        "INSERT INTO messages VALUES (8, 1, 'x'), (7, 'soon', 'x'), (NULL, 1, 'x'), "
        "(7, 1, NULL), (7, 1, 3.5), (7, 2, 'good')");
  }
  const Reading read = read_file(path);
  EXPECT_THAT(read.messages, ElementsAre(ReadMessage{"/a", 2, "good"}));
  EXPECT_EQ(read.problems.num_damaged, 5U);
  EXPECT_EQ(read.problems.first.at(0).location, "row 1");
  EXPECT_EQ(read.problems.first.at(0).reason, "no topic has the id 8");
  EXPECT_THAT(read.problems.first.at(1).reason, HasSubstr("whole numbers"));
}

TEST(Rosbag2Sqlite, SaysWhatAFileIsThatIsNoRecording) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  {
    DatabaseWriter database(path);
    database.run("CREATE TABLE songs(title)");
    database.run("CREATE TABLE singers(name)");
    database.run("CREATE VIEW messages AS SELECT 1 AS topic_id, 2 AS timestamp, 3 AS data");
  }
  EXPECT_THAT(read_file(path).error,
              HasSubstr("no ROS 2 bag: it has no table topics, but songs, singers"));
  DatabaseWriter(path).run("CREATE TABLE topics(id, name, kind, serialization_format)");
  EXPECT_THAT(read_file(path).error, HasSubstr("its table topics has no type"));
  DatabaseWriter(path).run("ALTER TABLE topics RENAME COLUMN kind TO type");
  EXPECT_THAT(read_file(path).error, HasSubstr("it has no table messages"));

  EXPECT_EQ(read_bytes("").error, "test.db3: the file is empty");
  EXPECT_EQ(read_bytes("#ROSBAG V2.0\n").error, "test.db3: not an SQLite file");
  EXPECT_THAT(read_bytes("SQLite for").error, HasSubstr("cut short within its first page"));
  EXPECT_THAT(read_file(folder.path()).error, HasSubstr("directory"));
  EXPECT_THAT(read_file(folder.path() / "none.db3").error, HasSubstr("No such file"));
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(read_file(pipe).error, HasSubstr("not a regular file"));
}

TEST(Rosbag2Sqlite, AgreesWithSqliteOnPagesOfAnySize) {
  auto generator = testing::make_generator();
  const TemporaryFolder folder;
  for (int page_bytes = 512; page_bytes <= 65536; page_bytes *= 2) {
    std::vector<ReadMessage> messages = made_up_messages(30);
    for (ReadMessage& message : messages) {
      const double log_size = testing::uniform(generator, 0.0, 12.0);
      message.data = cdr_bytes(static_cast<std::size_t>(std::exp(log_size)), 3);
    }
    const fs::path path = folder.path() / (std::to_string(page_bytes) + ".db3");
    write_recording(path, messages, 3, page_bytes);
    const Reading read = read_file(path);
    EXPECT_EQ(read.messages, read_by_sqlite(path)) << page_bytes;
    EXPECT_EQ(read.messages, messages) << page_bytes;
    EXPECT_TRUE(read.problems.empty());
  }
}

TEST(Rosbag2Sqlite, PathsMayHoldAnyLetters) {
  const TemporaryFolder folder;
  const auto messages = made_up_messages(5);
  for (const char* name : {"a b.db3",
                           "100%20.db3",
                           "what?mode=rwc.db3",
                           "#1.db3",
                           "gr\xc3\xbc\xc3\x9f"
                           "e.db3",
                           "file:x.db3",
                           ":memory:",
                           "it's \"quoted\"",
                           "\xff.db3"}) {
    const fs::path path = folder.path() / name;
    write_recording(folder.path() / "made.db3", messages);
    fs::rename(folder.path() / "made.db3", path);
    EXPECT_EQ(read_file(path).messages, messages) << name;
  }
}

TEST(Rosbag2Sqlite, NothingIsWrittenBesideTheFile) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.db3";
  const auto messages = made_up_messages(20);
  write_recording(path, messages);
  // A file that says that it has a write-ahead log, which is gone.
  DatabaseWriter(path).run("PRAGMA journal_mode = WAL");
  const std::string content = content_of(path);
  const std::set<std::string> names = names_in(folder.path());
  fs::permissions(path, fs::perms::owner_read);
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  {
    Rosbag2Sqlite source(path);
    Message message;
    ASSERT_TRUE(source.read(message));
    EXPECT_EQ(names_in(folder.path()), names);
  }
  EXPECT_EQ(read_file(path).messages, messages);
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(names_in(folder.path()), names);
  EXPECT_EQ(content_of(path), content);
}

/// Another folder for temporary files, as long as it lives.
class TemporaryFilesIn {
 public:
  explicit TemporaryFilesIn(const fs::path& folder) { ::setenv("TMPDIR", folder.c_str(), 1); }
  ~TemporaryFilesIn() { ::unsetenv("TMPDIR"); }
  TemporaryFilesIn(const TemporaryFilesIn&) = delete;
  TemporaryFilesIn& operator=(const TemporaryFilesIn&) = delete;
};

TEST(Rosbag2Sqlite, PackedFilesAndPipesAreReadThroughATemporaryFile) {
  std::vector<ReadMessage> messages = made_up_messages(300);
  for (ReadMessage& message : messages) message.data.append(cdr_bytes(2000, 5));
  const std::string bytes = recording_bytes(messages);
  const TemporaryFolder folder;
  const TemporaryFilesIn temporary_files(folder.path());
  {
    Rosbag2Sqlite source(make_memory_source(bytes), "-");
    Message message;
    EXPECT_TRUE(source.read(message));
    EXPECT_THAT(names_in(folder.path()), IsEmpty());  // it has no name
  }
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  EXPECT_EQ(read_bytes(packed).messages, messages);
  const Reading cut = read_bytes(packed.substr(0, packed.size() - 10));
  EXPECT_EQ(num_found(messages, cut.messages), cut.messages.size());
  EXPECT_GT(cut.messages.size(), 100U);
  EXPECT_THAT(summary(cut.problems), HasSubstr("cut short"));
  EXPECT_THAT(read_bytes(packed.substr(0, 20)).error, HasSubstr("cut short"));
}

TEST(Rosbag2Sqlite, SaysWhatToDoWhereATemporaryFileCannotBeWritten) {
  const std::string bytes = recording_bytes(made_up_messages(100));
  const TemporaryFolder folder;
  {
    const TemporaryFilesIn temporary_files(folder.path() / "none");
    const std::string error = read_bytes(bytes).error;
    EXPECT_THAT(error, HasSubstr("cannot be copied into the folder of temporary files"));
    EXPECT_THAT(error, HasSubstr("set TMPDIR"));
  }
  // As on a full disk: a file may not grow beyond a limit.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 10000;
  const auto previous_action = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = read_bytes(bytes).error;
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, previous_action);
  EXPECT_THAT(error, HasSubstr("test.db3: cannot be copied into the folder of temporary files"));
}

TEST(Rosbag2Sqlite, TellsHowMuchIsRead) {
  Rosbag2Sqlite source(make_memory_source(recording_bytes(made_up_messages(100))), "test.db3");
  EXPECT_EQ(source.fraction_read(), 0.0);
  Message message;
  double previous = 0.0;
  while (source.read(message)) {
    EXPECT_GT(*source.fraction_read(), previous);
    previous = *source.fraction_read();
  }
  EXPECT_EQ(source.fraction_read(), 1.0);
  EXPECT_EQ(source.format(), "ROS 2 bag (SQLite)");
}

}  // namespace setsquare::rosbag2_sqlite_test
