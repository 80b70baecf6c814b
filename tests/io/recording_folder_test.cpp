// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/recording_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/io/bags/rosbag2_sqlite.hpp"
#include "tests/io/recorded_messages.hpp"

namespace setsquare::recording_folder_test {

namespace fs = std::filesystem;

using testing::content_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::made_up_messages;
using testing::num_found;
using testing::Reading;
using testing::ReadMessage;
using ::testing::SizeIs;
using testing::TemporaryFolder;
using testing::write_recording;

/// Messages that are there, then an error if there is one: a file of another format.
class ListedMessages final : public MessageSource {
 public:
  ListedMessages(std::vector<ReadMessage> messages, std::string error)
      : messages_(std::move(messages)), error_(std::move(error)) {}

  bool read(Message& message) override {
    while (next_ < messages_.size()) {
      const ReadMessage& recorded = messages_[next_++];
      MessageTopic topic{recorded.topic, "test_msgs/Any", "", MessageEncoding::kCdr};
      const std::size_t index = add_topic(std::move(topic));
      count(index);
      if (!is_wanted(index)) continue;
      message = {index, {recorded.time_ns}, recorded.data, next_};
      return true;
    }
    if (!error_.empty()) throw FileError("listed", error_);
    return false;
  }
  std::string format() const override { return "listed messages"; }
  std::optional<double> fraction_read() const override { return 0.5; }

 private:
  std::vector<ReadMessage> messages_;
  std::string error_;
  std::size_t next_ = 0;
};

/// By content, as the library's own does it; a file that begins with "fails" fails when read.
std::unique_ptr<MessageSource> open_file(const std::string& path) {
  const std::string content = content_of(path);
  if (content.starts_with("fails")) {
    return std::make_unique<ListedMessages>(made_up_messages(3), "Input/output error");
  }
  if (content.starts_with("SQLite")) return std::make_unique<Rosbag2Sqlite>(path);
  return std::make_unique<Rosbag2Sqlite>(unpack(open_file_source(path)), path);
}

Reading read_folder(const fs::path& path, const MessageSource::IsWanted& is_wanted = {}) {
  return testing::read_source(
      [&] { return std::make_unique<RecordingFolder>(path.string(), open_file); }, is_wanted);
}

/// A metadata.yaml as rosbag2 writes it in one of its versions.
std::string metadata_text(int version,
                          const std::vector<std::string>& files,
                          int num_scans,
                          int num_images,
                          const std::string& compression_mode = "") {
  const auto topic = [version](const char* name, const char* type, int num_messages) {
    std::string text = "    - topic_metadata:\n        name: " + std::string(name) +
                       "\n        type: " + type + "\n        serialization_format: cdr\n";
    if (version >= 9) {
      text +=
          "        offered_qos_profiles:\n          - history: keep_last\n            depth: 1\n";
    } else if (version >= 4) {
      text += "        offered_qos_profiles: \"- history: 3\\n  depth: 0\"\n";
    }
    return text + "      message_count: " + std::to_string(num_messages) + "\n";
  };
  std::string text = "rosbag2_bagfile_information:\n  version: " + std::to_string(version) +
                     "\n  storage_identifier: sqlite3\n  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - \"" + file + "\"\n";
  text += "  duration:\n    nanoseconds: 40\n  starting_time:\n    nanoseconds_since_epoch: 1000\n";
  text += "  message_count: " + std::to_string(num_scans + num_images) + "\n";
  text += "  topics_with_message_count:\n" +
          topic("/scan", "sensor_msgs/msg/LaserScan", num_scans) +
          topic("/camera/image_raw", "sensor_msgs/msg/Image", num_images);
  if (version >= 3) {
    text += "  compression_format: " + std::string(compression_mode.empty() ? "\"\"" : "zstd") +
            "\n  compression_mode: \"" + compression_mode + "\"\n";
  }
  if (version >= 5) text += "  files: []\n";
  if (version >= 6) text += "  custom_data: ~\n";
  if (version >= 8) text += "  ros_distro: \"jazzy\"";
  return text;
}

void write(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::string packed(const std::string& bytes) {
  std::string all(ZSTD_compressBound(bytes.size()), '\0');
  all.resize(ZSTD_compress(all.data(), all.size(), bytes.data(), bytes.size(), 1));
  return all;
}

/// Twelve files of ten messages each, "run_0.db3" to "run_11.db3", and what is in them.
class Recording : public ::testing::Test {
 protected:
  Recording() {
    folder_ = temporary_.path() / "run";
    fs::create_directory(folder_);
    for (int i = 0; i < 12; ++i) {
      const std::string name = "run_" + std::to_string(i) + ".db3";
      const auto part = made_up_messages(10, 1000 + 10 * i);
      write_recording(folder_ / name, part);
      names_.push_back(name);
      messages_.insert(messages_.end(), part.begin(), part.end());
    }
  }

  void write_metadata(int version, const std::vector<std::string>& files) {
    write(folder_ / "metadata.yaml", metadata_text(version, files, 60, 60));
  }
  std::vector<std::string> names_with(const std::string& prefix) const {
    std::vector<std::string> names = names_;
    for (std::string& name : names) name.insert(0, prefix);
    return names;
  }
  std::vector<ReadMessage> without_file(std::size_t file) const {
    std::vector<ReadMessage> messages = messages_;
    const auto begin = messages.begin() + static_cast<std::ptrdiff_t>(10 * file);
    messages.erase(begin, begin + 10);
    return messages;
  }

  TemporaryFolder temporary_;
  fs::path folder_;
  std::vector<std::string> names_;
  std::vector<ReadMessage> messages_;
};

TEST_F(Recording, IsReadAsOneWhateverTheVersionOfItsMetadata) {
  for (int version = 1; version <= 9; ++version) {
    write_metadata(version, names_with(version < 4 ? "run/" : ""));
    const Reading read = read_folder(folder_);
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(read.messages, messages_) << version;
    EXPECT_TRUE(read.problems.empty()) << version << read.problems.remarks.at(0);
    ASSERT_THAT(read.topics, SizeIs(2));
    EXPECT_THAT(read.num_messages, ElementsAre(60, 60));
  }
}

TEST_F(Recording, IsFoundByItsMetadataFileToo) {
  write_metadata(5, names_);
  EXPECT_EQ(read_folder(folder_ / "metadata.yaml").messages, messages_);
  const fs::path here = fs::current_path();
  fs::current_path(folder_);
  EXPECT_EQ(read_folder("metadata.yaml").messages, messages_);
  EXPECT_EQ(read_folder(".").messages, messages_);
  fs::current_path(here);
}

TEST_F(Recording, PathsOfAnotherMachineOrAnotherNameCountByTheirNames) {
  for (const char* prefix : {"/home/robot/bags/run/", "old_name/", "./"}) {
    write_metadata(4, names_with(prefix));
    const Reading read = read_folder(folder_);
    EXPECT_EQ(read.messages, messages_) << prefix;
    EXPECT_TRUE(read.problems.empty());
  }
}

TEST_F(Recording, WithoutMetadataItsFilesAreReadByNumber) {
  const Reading read = read_folder(folder_);
  EXPECT_EQ(read.messages, messages_);
  EXPECT_EQ(read.problems.num_damaged, 0U);
  ASSERT_THAT(read.problems.remarks, SizeIs(1));
  EXPECT_THAT(read.problems.remarks[0], HasSubstr("no usable metadata.yaml"));
}

TEST_F(Recording, WithDamagedMetadataItsFilesAreReadByNumber) {
  for (const char* text : {"",
                           "rosbag2_bagfile_information:\n  - [",
                           "a: b",
                           "- 3",
                           "rosbag2_bagfile_information: 7",
                           "rosbag2_bagfile_information:\n  relative_file_paths: 3\n"}) {
    write(folder_ / "metadata.yaml", text);
    const Reading read = read_folder(folder_);
    EXPECT_EQ(read.messages, messages_) << text;
    EXPECT_FALSE(read.problems.remarks.empty());
  }
}

TEST_F(Recording, AMissingFileIsNamedAndTheRestRead) {
  write_metadata(5, names_);
  fs::remove(folder_ / "run_3.db3");
  const Reading read = read_folder(folder_);
  EXPECT_EQ(read.messages, without_file(3));
  EXPECT_EQ(read.problems.num_damaged, 1U);
  EXPECT_EQ(read.problems.first.at(0).location, "run_3.db3");
  EXPECT_THAT(read.problems.remarks,
              ElementsAre("metadata.yaml announces other numbers of messages: 60 of /scan, 55 "
                          "there; 60 of /camera/image_raw, 55 there"));
}

TEST_F(Recording, AFileThatCannotBeReadIsNamedAndTheRestRead) {
  write_metadata(5, names_);
  write(folder_ / "run_3.db3", "no such format");
  Reading read = read_folder(folder_);
  EXPECT_EQ(read.messages, without_file(3));
  EXPECT_EQ(summary(read.problems), "1 damaged record skipped, at run_3.db3: not an SQLite file");

  write(folder_ / "run_3.db3", "fails");
  read = read_folder(folder_);
  EXPECT_THAT(read.messages, SizeIs(110 + 3));
  EXPECT_THAT(summary(read.problems), HasSubstr("run_3.db3: "));
  EXPECT_THAT(summary(read.problems), HasSubstr("Input/output error"));
}

TEST_F(Recording, WhatIsWrongInAFileIsSaidWithItsName) {
  write_metadata(5, names_);
  const std::string content = content_of(folder_ / "run_3.db3");
  write(folder_ / "run_3.db3", content.substr(0, content.size() / 2));
  const Reading read = read_folder(folder_);
  EXPECT_EQ(num_found(messages_, read.messages), read.messages.size());
  EXPECT_GE(read.messages.size(), 110U);
  EXPECT_LT(read.messages.size(), 120U);
  EXPECT_THAT(read.problems.first.at(0).location, HasSubstr("run_3.db3, "));
  EXPECT_THAT(read.problems.remarks.at(0), HasSubstr("run_3.db3: the file is cut short"));
}

TEST_F(Recording, AFileThatMetadataDoesNotNameIsRemarked) {
  std::vector<std::string> fewer = names_;
  fewer.pop_back();
  write_metadata(5, fewer);
  const Reading read = read_folder(folder_);
  EXPECT_EQ(read.messages, without_file(11));
  EXPECT_THAT(read.problems.remarks.at(0),
              HasSubstr("metadata.yaml does not name run_11.db3, which is not read"));
}

TEST_F(Recording, FilesOfOtherNamesThanTheMetadataSaysAreRead) {
  write_metadata(5, {"before_it_was_renamed_0.db3"});
  const Reading read = read_folder(folder_);
  EXPECT_EQ(read.messages, messages_);
  EXPECT_THAT(read.problems.remarks.at(0), HasSubstr("before_it_was_renamed_0.db3"));
}

TEST_F(Recording, PackedFilesAreUnpacked) {
  std::vector<std::string> packed_names;
  for (const std::string& name : names_) {
    packed_names.push_back(name + ".zstd");
    write(folder_ / packed_names.back(), packed(content_of(folder_ / name)));
    fs::remove(folder_ / name);
  }
  write(folder_ / "metadata.yaml", metadata_text(5, packed_names, 60, 60, "FILE"));
  EXPECT_EQ(read_folder(folder_).messages, messages_);
  // The metadata of a recording that was packed later, and no metadata at all.
  write_metadata(5, names_);
  EXPECT_EQ(read_folder(folder_).messages, messages_);
  fs::remove(folder_ / "metadata.yaml");
  EXPECT_EQ(read_folder(folder_).messages, messages_);
  // One that was unpacked beside, as rosbag2 does when it plays.
  write_recording(folder_ / "run_3.db3", made_up_messages(10, 1030));
  EXPECT_EQ(read_folder(folder_).messages, messages_);
}

TEST_F(Recording, OnlyWantedTopicsAreHandedOnAndAllAreCounted) {
  write(folder_ / "metadata.yaml", metadata_text(5, names_, 60, 7));
  const Reading read =
      read_folder(folder_, [](const MessageTopic& topic) { return topic.name == "/scan"; });
  EXPECT_THAT(read.messages, SizeIs(60));
  EXPECT_THAT(read.num_messages, ElementsAre(60, 60));
  EXPECT_TRUE(read.problems.empty());  // of unwanted topics no count need be known
}

TEST_F(Recording, TellsHowMuchIsRead) {
  write_metadata(5, names_);
  RecordingFolder source(folder_.string(), open_file);
  Message message;
  double previous = 0.0;
  while (source.read(message)) {
    EXPECT_GE(*source.fraction_read(), previous);
    previous = *source.fraction_read();
  }
  EXPECT_EQ(source.fraction_read(), 1.0);
  EXPECT_FALSE(source.read(message));
  EXPECT_EQ(source.format(), "ROS 2 bag (SQLite)");
}

TEST_F(Recording, NothingIsWrittenIntoItsFolder) {
  write_metadata(5, names_);
  const std::set<std::string> before = testing::names_in(folder_);
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(read_folder(folder_).messages, messages_);
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(testing::names_in(folder_), before);
}

TEST(RecordingFolder, MergesTopicsWhoseNumbersDiffer) {
  const TemporaryFolder folder;
  const auto write_part = [&folder](int number, const char* first, const char* second) {
    testing::DatabaseWriter database(folder.path() / ("a_" + std::to_string(number) + ".db3"));
    database.create_tables(2);
    database.insert_topic(first, "std_msgs/msg/String");
    database.insert_topic(second, number == 0 ? "std_msgs/msg/String" : "std_msgs/String");
    database.insert_message(1, 10 * number, "one");
    database.insert_message(2, 10 * number + 1, "two");
  };
  write_part(0, "/a", "/b");
  write_part(1, "/b", "/c");
  const Reading read = read_folder(folder.path());
  EXPECT_THAT(read.messages,
              ElementsAre(ReadMessage{"/a", 0, "one"},
                          ReadMessage{"/b", 1, "two"},
                          ReadMessage{"/b", 10, "one"},
                          ReadMessage{"/c", 11, "two"}));
  EXPECT_THAT(read.num_messages, ElementsAre(1, 2, 1));
}

TEST(RecordingFolder, UnpacksMessagesOfAnyFormat) {
  const TemporaryFolder folder;
  auto messages = made_up_messages(4);
  for (ReadMessage& message : messages) message.data = packed(message.data);
  messages[2].data.pop_back();
  write(folder.path() / "a.mcap", "");
  const Reading read = testing::read_source([&] {
    return std::make_unique<RecordingFolder>(folder.path().string(), [&](const std::string&) {
      return std::make_unique<ListedMessages>(messages, "");
    });
  });
  auto expected = made_up_messages(4);
  expected.erase(expected.begin() + 2);
  EXPECT_EQ(read.messages, expected);
  EXPECT_EQ(read.problems.first.at(0).reason, "the packed message is cut short");
}

TEST(RecordingFolder, SaysWhatAFolderIsThatIsNoRecording) {
  const TemporaryFolder folder;
  const auto error = [&folder] { return read_folder(folder.path()).error; };
  EXPECT_THAT(error(), HasSubstr("a folder without a recording"));
  write(folder.path() / "metadata.yaml", metadata_text(5, {"gone_0.db3"}, 1, 1));
  EXPECT_THAT(error(), HasSubstr("no file that metadata.yaml names is there: gone_0.db3"));
  fs::remove(folder.path() / "metadata.yaml");
  fs::create_directory(folder.path() / "monday");
  write(folder.path() / "monday" / "metadata.yaml", "");
  EXPECT_THAT(error(), HasSubstr("name one of them: monday"));
  write_recording(folder.path() / "kitchen.db3", made_up_messages(2));
  EXPECT_EQ(error(), "");
  write(folder.path() / "hall.mcap", "");
  EXPECT_THAT(error(), HasSubstr("files of several recordings"));
  EXPECT_THAT(error(), HasSubstr("hall.mcap, kitchen.db3"));
  fs::remove(folder.path() / "kitchen.db3");
  EXPECT_THAT(error(), HasSubstr("no file of it can be read; hall.mcap: the file is empty"));
  write(folder.path() / "hall.mcap", "fails");
  EXPECT_EQ(error(), "listed: Input/output error");
  EXPECT_THAT(read_folder(folder.path() / "none").error, HasSubstr("No such file"));
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(read_folder(folder.path() / "pipe").error, HasSubstr("neither a folder nor a file"));
}

TEST(RecordingFolder, RefusesMessagesPackedInWaysThatItDoesNotKnow) {
  const TemporaryFolder folder;
  write_recording(folder.path() / "a_0.db3", made_up_messages(2));
  std::string text = metadata_text(5, {"a_0.db3"}, 1, 1, "MESSAGE");
  text.replace(text.find("zstd"), 4, "lz77");
  write(folder.path() / "metadata.yaml", text);
  EXPECT_THAT(read_folder(folder.path()).error, HasSubstr("\"lz77\", which is not known"));
}

TEST(RecordingFiles, NumbersInNamesCountAsNumbers) {
  const std::vector<std::string> ordered = {"a",
                                            "a_0",
                                            "a_1",
                                            "a_02",
                                            "a_3",
                                            "a_10",
                                            "a_10b",
                                            "a_99999999999999999999",
                                            "b_1_2",
                                            "b_1_10",
                                            "b_2_1"};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t j = 0; j < ordered.size(); ++j) {
      EXPECT_EQ(is_before_by_number(ordered[i], ordered[j]), i < j) << ordered[i] << ordered[j];
    }
  }
}

TEST(RecordingMetadata, IsRecognised) {
  EXPECT_TRUE(is_recording_metadata(metadata_text(5, {}, 1, 1)));
  EXPECT_TRUE(is_recording_metadata("---\n" + metadata_text(5, {}, 1, 1)));
  EXPECT_FALSE(is_recording_metadata("image: map.pgm"));
  EXPECT_FALSE(is_recording_metadata(""));
}

TEST(RecordingMetadata, HoldsWhatIsThereAndNothingElse) {
  const RecordingMetadata metadata =
      recording_metadata_from_text(metadata_text(8, {"a_0.db3", "a_1.db3"}, 3, 4, "FILE"), "test");
  EXPECT_THAT(metadata.files, ElementsAre("a_0.db3", "a_1.db3"));
  EXPECT_EQ(metadata.compression_format, "zstd");
  EXPECT_EQ(metadata.compression_mode, "FILE");
  ASSERT_THAT(metadata.topics, SizeIs(2));
  EXPECT_EQ(metadata.topics[0].name, "/scan");
  EXPECT_EQ(metadata.topics[0].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(metadata.topics[1].num_messages, 4U);

  const std::string odd =
      "rosbag2_bagfile_information:\n  topics_with_message_count: [7, {message_count: -1}, "
      "{message_count: 5}, {message_count: 2, topic_metadata: [3]}, {message_count: [1]}]\n"
      "  relative_file_paths: [{}, '', [a], b]\n  compression_mode: {}\n";
  const RecordingMetadata little = recording_metadata_from_text(odd, "test");
  EXPECT_THAT(little.files, ElementsAre("b"));
  EXPECT_THAT(little.topics, SizeIs(1));
  EXPECT_EQ(little.compression_mode, "");
}

}  // namespace setsquare::recording_folder_test
