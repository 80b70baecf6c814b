// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/output_set.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <thread>

#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::output_set_test {

namespace fs = std::filesystem;
using app::OutputSet;

const std::vector<std::string> kNames = {"map.pgm", "map.yaml", "map.png", "extra.tsv", "run.json"};

class OutputSetTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string content(const std::string& name) const {
    return testing::content_of(folder_ / name);
  }
  void put(const fs::path& name, const std::string& bytes) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  /// Names of all that is in the folder, hidden or not.
  [[nodiscard]] std::set<std::string> entries() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }
  /// All files but extra.tsv, each with the same text.
  void write_set(const std::string& text) const {
    OutputSet outputs(folder_.string(), kNames);
    for (const std::string& name : kNames) {
      if (name != "extra.tsv") outputs.add(name, text);
    }
    outputs.commit();
  }
  void expect_set(const std::string& text) const {
    EXPECT_EQ(entries(), (std::set<std::string>{"map.pgm", "map.yaml", "map.png", "run.json"}));
    for (const std::string& name : entries()) EXPECT_EQ(content(name), text) << name;
  }

  const testing::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path() / "set";  ///< Not there yet.
};

TEST_F(OutputSetTest, AllFilesComeAtOnceAndReplaceTheLastSet) {
  {
    OutputSet outputs((folder_ / "deep").string(), kNames);
    for (const std::string& name : kNames) outputs.add(name, "one");
    for (const std::string& name : kNames) EXPECT_FALSE(fs::exists(folder_ / "deep" / name));
    outputs.commit();
    for (const std::string& name : kNames) EXPECT_TRUE(fs::exists(folder_ / "deep" / name));
  }
  fs::rename(folder_ / "deep", folder_.string() + "_moved");
  fs::remove(folder_);
  fs::rename(folder_.string() + "_moved", folder_);
  EXPECT_TRUE(fs::exists(folder_ / "extra.tsv"));
  write_set("two");
  expect_set("two");  // extra.tsv was the last set's
}

TEST_F(OutputSetTest, WithoutCommitNothingChanges) {
  {
    OutputSet outputs((folder_ / "a" / "b").string(), kNames);
    outputs.add("map.png", "half");
  }
  EXPECT_FALSE(fs::exists(folder_)) << "the directories that it made are gone";
  write_set("one");
  {
    OutputSet outputs(folder_.string(), kNames);
    outputs.add("map.png", "half");
  }
  expect_set("one");
}

TEST_F(OutputSetTest, OtherFilesAreLeftAlone) {
  put("notes.txt", "mine");
  write_set("one");
  EXPECT_EQ(content("notes.txt"), "mine");
  EXPECT_EQ(entries().size(), 5U);
}

TEST_F(OutputSetTest, WhatAKilledRunKeptAsideGoes) {
  write_set("one");
  put(".setsquare-new/map.png", "half");
  write_set("two");
  expect_set("two");
}

TEST_F(OutputSetTest, AKillWithinTheCommitIsMadeGoodByTheNextRun) {
  // After the first rename: the old set is there, or what is left of it.
  for (const bool is_old_whole : {true, false}) {
    fs::remove_all(folder_);
    for (const char* const name : {"map.pgm", "extra.tsv"}) put(name, "old");
    if (is_old_whole) put("run.json", "old");
    for (const std::string& name : kNames) {
      if (name != "extra.tsv") put(".setsquare-whole/" + name, "new");
    }
    { const OutputSet next(folder_.string(), kNames); }
    expect_set("new");
  }
  // While the new files take their places.
  fs::remove_all(folder_);
  put("map.pgm", "new");
  for (const char* const name : {"map.yaml", "map.png", "run.json"}) {
    put(std::string(".setsquare-move/") + name, "new");
  }
  { const OutputSet next(folder_.string(), kNames); }
  expect_set("new");
}

TEST_F(OutputSetTest, ARunKilledAtAnyMomentLeavesOneWholeSetOrSaysSo) {
  write_set("0");
  std::mt19937_64 generator = testing::make_generator();
  std::uniform_int_distribution<int> delay_us(0, 6000);
  int num_whole = 0;
  for (int round = 0; round < 60; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = 1;; ++i) write_set(std::to_string(i) + std::string(20'000, '.'));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(delay_us(generator)));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    const bool is_whole = fs::exists(folder_ / "run.json");
    num_whole += is_whole;
    std::set<std::string> texts;
    for (const std::string& name : kNames) {
      if (fs::exists(folder_ / name)) texts.insert(content(name));
    }
    EXPECT_LE(texts.size(), 1U) << "files of two runs, or a half one";
    if (is_whole) {
      for (const char* const name : {"map.pgm", "map.yaml", "map.png"}) {
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
      }
    }
    { const OutputSet next(folder_.string(), kNames); }
    expect_set(content("run.json"));
    EXPECT_FALSE(content("run.json").empty());
  }
  EXPECT_GT(num_whole, 0);
}

TEST_F(OutputSetTest, ARunEndedByASignalAtAnyMomentLeavesOneWholeSetAndNothingElse) {
  write_set("0");
  std::mt19937_64 generator = testing::make_generator();
  std::uniform_int_distribution<int> delay_us(0, 6000);
  for (int round = 0; round < 30; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = 1;; ++i) write_set(std::to_string(i) + std::string(20'000, '.'));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(delay_us(generator)));
    ASSERT_EQ(::kill(child, SIGTERM), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGTERM);
    expect_set(content("run.json"));
  }
}

TEST_F(OutputSetTest, AnInputIsNotReplaced) {
  write_set("one");
  fs::create_hard_link(folder_ / "map.png", temporary_.path() / "other name");
  EXPECT_THROW(OutputSet(folder_.string(), kNames, {(temporary_.path() / "other name").string()}),
               FileError);
  EXPECT_NO_THROW(OutputSet(folder_.string(), kNames, {(temporary_.path() / "absent").string()}));
  expect_set("one");
}

TEST_F(OutputSetTest, TwoRunsDoNotWriteIntoOneDirectory) {
  OutputSet first(folder_.string(), kNames);
  EXPECT_THROW(OutputSet(folder_.string(), kNames), FileError);
  first.add("run.json", "one");
  first.commit();
  EXPECT_EQ(content("run.json"), "one");
}

TEST_F(OutputSetTest, ADirectoryInAFilesPlaceIsReportedAtOnce) {
  put("map.png/x", "");
  EXPECT_THROW(OutputSet(folder_.string(), kNames), FileError);
  EXPECT_EQ(entries(), std::set<std::string>{"map.png"});
}

/// Sets that hold pieces/1.tum and so on, so many of them.
class NumberedFilesTest : public OutputSetTest {
 protected:
  void write_pieces(int num, const std::string& text) const {
    OutputSet outputs(folder_.string(), kWithPieces);
    for (int k = 1; k <= num; ++k) outputs.add("pieces/" + std::to_string(k) + ".tum", text);
    outputs.add("run.json", text);
    outputs.commit();
  }
  /// Names of all that is in `pieces`.
  [[nodiscard]] std::set<std::string> pieces() const {
    std::set<std::string> names;
    if (!fs::is_directory(folder_ / "pieces")) return names;
    for (const auto& entry : fs::directory_iterator(folder_ / "pieces")) {
      names.insert(entry.path().filename());
    }
    return names;
  }

  const std::vector<std::string> kWithPieces = {"map.png", "pieces/", "run.json"};
};

TEST_F(NumberedFilesTest, ThoseOfTheLastSetGoWithIt) {
  write_pieces(12, "one");
  EXPECT_EQ(pieces().size(), 12U);
  write_pieces(2, "two");
  EXPECT_EQ(pieces(), (std::set<std::string>{"1.tum", "2.tum"}));
  EXPECT_EQ(content("pieces/2.tum"), "two");
  write_pieces(0, "three");
  EXPECT_EQ(entries(), std::set<std::string>{"run.json"}) << "an empty folder goes, too";
}

TEST_F(NumberedFilesTest, FilesOfOtherNamesThereStay) {
  const std::set<std::string> others = {"mine.tum", "2.txt", "2b.tum", "-1.tum", ".tum"};
  for (const std::string& name : others) put("pieces/" + name, "mine");
  put("pieces/deeper/1.tum", "mine");
  write_pieces(3, "one");
  write_pieces(0, "two");
  for (const std::string& name : others) EXPECT_EQ(content("pieces/" + name), "mine") << name;
  EXPECT_EQ(content("pieces/deeper/1.tum"), "mine");
  EXPECT_EQ(pieces().size(), others.size() + 1);
}

TEST_F(NumberedFilesTest, WithoutCommitTheyStay) {
  write_pieces(3, "one");
  {
    OutputSet outputs(folder_.string(), kWithPieces);
    outputs.add("pieces/1.tum", "half");
  }
  EXPECT_EQ(pieces().size(), 3U);
  EXPECT_EQ(content("pieces/1.tum"), "one");
}

TEST_F(NumberedFilesTest, AKillWithinTheCommitIsMadeGoodByTheNextRun) {
  write_pieces(3, "old");
  put("pieces/mine.tum", "mine");
  put(".setsquare-whole/pieces/1.tum", "new");
  put(".setsquare-whole/run.json", "new");
  { const OutputSet next(folder_.string(), kWithPieces); }
  EXPECT_EQ(pieces(), (std::set<std::string>{"1.tum", "mine.tum"}));
  EXPECT_EQ(content("pieces/1.tum"), "new");
  EXPECT_EQ(content("run.json"), "new");
  // While the new files take their places.
  fs::remove(folder_ / "run.json");
  put(".setsquare-move/pieces/2.tum", "new");
  put(".setsquare-move/run.json", "new");
  { const OutputSet next(folder_.string(), kWithPieces); }
  EXPECT_EQ(pieces(), (std::set<std::string>{"1.tum", "2.tum", "mine.tum"}));
  EXPECT_EQ(content("run.json"), "new");
}

TEST_F(NumberedFilesTest, AnInputThereIsNotReplacedAndOneOfAnotherNameMayBeRead) {
  write_pieces(2, "one");
  put("pieces/mine.tum", "mine");
  const std::string input = (folder_ / "pieces" / "2.tum").string();
  EXPECT_THROW(OutputSet(folder_.string(), kWithPieces, {input}), FileError);
  const std::string other = (folder_ / "pieces" / "mine.tum").string();
  EXPECT_NO_THROW(OutputSet(folder_.string(), kWithPieces, {other}));
  EXPECT_EQ(content("pieces/2.tum"), "one");
}

TEST_F(NumberedFilesTest, WhatALinkLeadsToStays) {
  const fs::path elsewhere = temporary_.path() / "elsewhere";
  fs::create_directories(elsewhere);
  std::ofstream(elsewhere / "1.tum") << "mine";
  fs::create_directories(folder_);
  fs::create_directory_symlink(elsewhere, folder_ / "pieces");
  write_pieces(1, "one");
  EXPECT_EQ(testing::content_of(elsewhere / "1.tum"), "mine");
  EXPECT_EQ(content("pieces/1.tum"), "one");
}

}  // namespace setsquare::output_set_test
